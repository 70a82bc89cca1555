// @vitest-environment happy-dom
/** What is offered where something cannot be. */
import { expect, it } from "vitest";
import type { Conflict, Repair } from "../src/contract";
import { ConflictPanel } from "../src/edit/conflict_panel";
import { scene } from "./rooms";

it("offers each repair once, pieces called as in a sentence, however many conflicts it ends", () => {
  document.body.innerHTML = "<section></section>";
  const panel = new ConflictPanel(document.querySelector("section") as HTMLElement);
  const taken: Repair[] = [];
  panel.onTake = (_, repair) => taken.push(repair);
  const out = (id: string): Repair => ({ action: "leave_out", id, dx: 0, dz: 0, rotation: 0 }) as Repair;
  const conflicts = [[out("den_1/counter_2")], [out("den_1/counter_2"), out("hall_2/bed_1")], [out("den_1/bed_1")]]
    .map((repairs): Conflict => ({ ids: [], message: "no way", repairs }) as unknown as Conflict);
  panel.show({ sent: scene([]), moved: [], room: "den_1", conflicts, live: false });
  const buttons = [...panel.host.querySelectorAll("button")];
  expect(buttons.map((one) => one.textContent)).toEqual(["Leave out counter 2", "Leave out the bed", "Leave out the bed", "Close"]);
  for (const one of buttons.slice(0, 3)) one.click();
  expect(taken.map(({ id }) => id)).toEqual(["den_1/counter_2", "hall_2/bed_1", "den_1/bed_1"]);
});
