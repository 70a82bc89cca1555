/** Words for what is edited and repaired. */
import type { Repair } from "../contract";
import { say, sayNumber } from "../words/language";
import { idWords as pieceWords } from "../words/telling";

export { idWords as pieceWords } from "../words/telling";

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
