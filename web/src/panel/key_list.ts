/** What keys do, as the dialog of keys tells it: a heading, then keys and what they do. */
import { say, type Words } from "../words/language";

/** The keys that keyboards of other languages call otherwise, also as `aria-keyshortcuts` has them. */
const CALLED: Readonly<Record<string, Words>> = { Ctrl: "Ctrl", Control: "Ctrl", Shift: "Shift", Del: "Del", Delete: "Del" };

/** What the reader's keyboard calls keys, such as Ctrl+Z. */
export function keyWords(keys: string): string {
  return keys.split("+").map((key) => (CALLED[key] ? say(CALLED[key]) : key)).join("+");
}

export const KEY_LIST: readonly (readonly [Words, readonly (readonly [keys: string, does: Words])[]])[] = [
  ["The house", [
    ["R", "another house, its seed drawn"],
    ["1", "walk through"],
    ["2", "top down"],
    ["3", "3D"],
    ["4", "the plan"],
    ["5", "the plan beside the house, or away"],
    ["↑ ↓ ← →", "on the house, with no piece chosen: more from above, from the side, turn it; with Shift look up, down, left, right"],
    ["+ -", "nearer, further away"],
    ["T", "open or close the doors and drawers of the chosen piece; with none chosen the door in the middle of the view, walking the nearest ahead; with Shift all furniture"],
    ["L", "names of all pieces; with Shift those of decorations, too"],
    ["O", "free floor and door squares"],
    ["D", "diagnose"],
    ["F", "flag the chosen piece for the diagnosis"],
    ["Esc", "choose nothing"],
    ["[ ]", "fold the controls, the text away, or show them"],
    ["Ctrl+P", "print the plan, whatever is in view"],
    ["?", "these keys"],
  ]],
  ["A piece", [
    ["A", "add one"],
    ["↑ ↓ ← →", "move the chosen one 5 cm; with Shift 1 cm"],
    ["Q E", "turn it left, right"],
    ["K", "lock or unlock it"],
    ["H", "why it stands here"],
    ["Del", "delete it with what lies on it"],
    ["Shift+Enter", "in the text, as Shift and a click in the house: choose one more, or one less"],
    ["Ctrl+D", "copy what is chosen beside it"],
    ["Ctrl+C Ctrl+V", "copy it, paste it"],
    ["M", "the tape measure"],
    ["Alt", "while a piece is dragged: lined up with nothing"],
    ["Ctrl+Z", "undo"],
    ["Ctrl+Shift+Z Ctrl+Y", "redo"],
    ["Esc", "end a drag, put the piece back"],
  ]],
  ["A plan that is drawn", [
    ["V", "choose and move"],
    ["B", "draw a room"],
    ["U X", "add area to the chosen room, cut area from it"],
    ["D W P G", "door, window, passage, garage door: click a wall, or an arrow for that side of the chosen room"],
    ["N", "a room of 4 by 3 m"],
    ["F", "fit all in view"],
    ["Shift Alt", "while a wall is dragged: for its room alone; no snapping"],
  ]],
  ["The text", [
    ["↑ ↓", "from one piece to the next; Page Up and Page Down by ten"],
    ["Enter", "choose the piece, again: go to the house, where arrows move it; in the search, the next one found"],
  ]],
  ["Walking", [
    ["W A S D", "ahead, left, back, right"],
    ["↑ ↓", "ahead, back"],
    ["← →", "turn"],
    ["Shift", "hurry"],
    ["Esc", "leave"],
  ]],
];
