import { describe, expect, it, vi } from "vitest";
import { Home, type Shown } from "../src/state/home";
import { piece, room, scene } from "./rooms";

function shown(seed: number, ids: readonly string[] = ["sofa_1"]): Shown {
  const furniture = ids.map((id) => piece(id, { locked: id === "bed_1" }));
  return { scene: scene([room("bedroom_1", [0, 0, 4, 4], { furniture })], { seed }), issues: [], conflicts: [], timing: 1 };
}

describe("history", () => {
  it("goes back and forward through steps, to the very same states", () => {
    const home = new Home();
    const [first, second, third] = [shown(1), shown(2), shown(3)];
    home.show(first, "new");
    home.show(second, "step");
    home.show(third, "step");
    home.undo();
    expect(home.shown).toMatchObject(second);
    home.undo();
    expect(home.shown).toMatchObject(first);
    expect([home.canUndo, home.canRedo]).toEqual([false, true]);
    home.undo();
    expect(home.shown).toMatchObject(first);
    home.redo();
    home.redo();
    expect(home.shown).toMatchObject(third);
    expect(home.canRedo).toBe(false);
  });

  it("chooses what a deletion took, once that is undone, and nothing of what came for something else", () => {
    const home = new Home();
    home.show(shown(1, ["sofa_1", "bed_1", "lamp_1"]), "new");
    home.select("sofa_1");
    home.show(shown(1, ["lamp_1"]), "step");
    expect(home.chosen).toEqual([]);
    home.undo();
    expect(home.chosen).toEqual(["sofa_1", "bed_1"]);
    home.redo();
    expect(home.chosen).toEqual([]);
    home.show(shown(1, ["desk_1"]), "step"); // the room anew
    home.undo();
    expect(home.chosen).toEqual([]);
    home.show({ ...shown(1), scene: scene([room("drawn_1", [0, 0, 4, 4])]) }, "step"); // another plan, in which nothing stands
    home.undo();
    expect(home.chosen).toEqual([]);
    home.undo();
    home.select("lamp_1");
    home.redo();
    home.undo();
    expect(home.chosen).toEqual(["lamp_1"]); // who has chosen something keeps it
  });

  it("takes for no step what leaves the home as it was, and keeps what can be redone", () => {
    const home = new Home();
    const [first, second] = [shown(1), shown(2)];
    home.show(first, "new");
    home.show(second, "step");
    home.undo();
    home.show(shown(5), "live");
    home.show(shown(1), "step");
    expect(home.shown).toMatchObject(first);
    expect([home.canUndo, home.canRedo]).toEqual([false, true]);
    home.show({ ...shown(1), made: { seed: 1, style: "rustic" } as never }, "step");
    expect([home.canUndo, home.canRedo]).toEqual([true, false]);
  });

  it("takes no moment of an edit for a step", () => {
    const home = new Home();
    const [first, end] = [shown(1), shown(9)];
    home.show(first, "new");
    home.show(shown(2), "live");
    home.show(shown(3), "live");
    expect(home.scene?.seed).toBe(3);
    expect(home.settled).toMatchObject(first);
    expect(home.canUndo).toBe(false);
    home.show(end, "step");
    home.undo();
    expect(home.shown).toMatchObject(first);
    home.redo();
    expect(home.shown).toMatchObject(end);
  });

  it("forgets what was undone when another step is taken, and all for another house", () => {
    const home = new Home();
    home.show(shown(1), "new");
    home.show(shown(2), "step");
    home.undo();
    home.show(shown(3), "step");
    expect(home.canRedo).toBe(false);
    home.show(shown(4), "new");
    expect(home.canUndo).toBe(false);
  });
});

describe("what is in hand", () => {
  it("is told to whoever listens, once a change", () => {
    const home = new Home();
    const [told, toldHow, flags] = [vi.fn(), vi.fn(), vi.fn()];
    home.on("selected", told);
    home.on("shown", toldHow);
    home.on("flagged", flags);
    home.show(shown(1), "new");
    home.select("sofa_1");
    home.select("sofa_1");
    home.select("gone_1");
    home.toggleFlag("gone_1");
    expect([home.selected, home.flagged.size]).toEqual(["sofa_1", 0]);
    home.toggleFlag("sofa_1");
    expect(told.mock.calls).toEqual([["sofa_1"]]);
    expect(toldHow.mock.calls).toEqual([["new"]]);
    expect([...home.flagged]).toEqual(["sofa_1"]);
    home.toggleFlag("sofa_1");
    expect(flags).toHaveBeenCalledTimes(2);
    expect(home.flagged.size).toBe(0);
  });

  it("is dropped with the body that is gone, and kept with one that stays", () => {
    const home = new Home();
    home.show(shown(1, ["sofa_1", "bed_1"]), "new");
    home.select("sofa_1");
    home.selectRoom("bedroom_1");
    home.toggleFlag("sofa_1");
    home.toggleFlag("bed_1");
    home.show(shown(2, ["bed_1"]), "step");
    expect(home.selected).toBeNull();
    expect([...home.flagged]).toEqual(["bed_1"]);
    expect(home.room).toBe("bedroom_1");
  });

  it("reads locks from the scene", () => {
    const home = new Home();
    home.show(shown(1, ["sofa_1", "bed_1"]), "new");
    expect([...home.locked]).toEqual(["bed_1"]);
    expect(home.find("bed_1")?.room.id).toBe("bedroom_1");
    expect(home.find("nothing")).toBeNull();
  });
});
