/** Words for what is edited and repaired. */
import type { Repair, Scene } from "../contract";
import { say, sayName, sayNumber } from "../words/language";

/** A piece's id as a person calls it: its kind, and its number where it is not the first. */
export function pieceWords(id: string): string {
  const name = id.split("/").at(-1) ?? id;
  const [, kind = name, number = "1"] = /^(.*?)_(\d+)$/.exec(name) ?? [];
  return number === "1" ? sayName(kind) : `${sayName(kind)} ${number}`;
}

/** What the service says of a scene, its pieces called as a person calls them. */
export function withNames(said: string, scene: Scene): string {
  const ids = scene.rooms.flatMap(({ furniture }) => furniture.map(({ id }) => id)).filter((id) => said.includes(id));
  const whole = ids.sort((a, b) => b.length - a.length).map((id) => id.replace(/[\\^$.*+?()[\]{}|]/g, "\\$&")).join("|");
  return whole ? said.replace(new RegExp(`(?<![\\w/])(?:${whole})(?![\\w/])`, "g"), (id) => `the ${pieceWords(id)}`) : said;
}

export function repairWords(repair: Repair): string {
  const piece = pieceWords(repair.id);
  switch (repair.action) {
    case "move": return say("Let the {piece} stand away from its wall", { piece });
    case "unlock": return say("Unlock the {piece}", { piece });
    case "turn": return say("Turn the {piece} to {angle}°", { piece, angle: repair.rotation });
    case "shrink": return say("Shrink the {piece} to {width} × {depth} m", { piece, width: sayNumber(repair.width, 2), depth: sayNumber(repair.depth, 2) });
    case "leave_out": return say("Leave out the {piece}", { piece });
  }
}
