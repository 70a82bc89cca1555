/** Words for what is edited and repaired. */
import type { Repair } from "../contract";

/** A piece's id as a person calls it: its kind, and its number where it is not the first. */
export function pieceWords(id: string): string {
  const name = id.split("/").at(-1) ?? id;
  const [, kind = name, number = "1"] = /^(.*?)_(\d+)$/.exec(name) ?? [];
  return number === "1" ? kind.replaceAll("_", " ") : `${kind.replaceAll("_", " ")} ${number}`;
}

export function repairWords(repair: Repair): string {
  const piece = `the ${pieceWords(repair.id)}`;
  switch (repair.action) {
    case "move": return `Let ${piece} stand away from its wall`;
    case "unlock": return `Unlock ${piece}`;
    case "turn": return `Turn ${piece} to ${repair.rotation}°`;
    case "shrink": return `Shrink ${piece} to ${repair.width.toFixed(2)} × ${repair.depth.toFixed(2)} m`;
    case "leave_out": return `Leave out ${piece}`;
  }
}
