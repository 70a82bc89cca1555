/** Words for what is edited and repaired. */
import type { Repair } from "../contract";
import { say, sayNumber } from "../words/language";
import { theWords } from "../words/telling";

export function repairWords(repair: Repair): string {
  const piece = theWords(repair.id);
  switch (repair.action) {
    case "move": return say("Let {piece} stand away from its wall", { piece });
    case "unlock": return say("Unlock {piece}", { piece });
    case "turn": return say("Turn {piece} to {angle}°", { piece, angle: repair.rotation });
    case "shrink": return say("Shrink {piece} to {width} × {depth} m", { piece, width: sayNumber(repair.width, 2), depth: sayNumber(repair.depth, 2) });
    case "leave_out": return say("Leave out {piece}", { piece });
  }
}
