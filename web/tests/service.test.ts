// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from "vitest";
import { DEFAULTS } from "../src/address";
import { fieldWords, refusalWords } from "../src/panel/field_words";
import { brokenOf, countsOf, totalMs, unfurnishedOf, unfurnishedWords } from "../src/panel/status";
import type { Issue } from "../src/contract";
import { generate, problemFrom, ServiceProblem, view } from "../src/service";
import { opening, piece, room, scene } from "./rooms";

const signal = new AbortController().signal;

function answering(answer: () => Promise<Response>) {
  const fetched = vi.fn<(url: URL, request: RequestInit) => Promise<Response>>(answer);
  vi.stubGlobal("fetch", fetched);
  return fetched;
}

afterEach(() => vi.unstubAllGlobals());

describe("calls", () => {
  it("send the request as JSON to the service that served the page", async () => {
    const fetched = answering(async () => new Response('{"scene":{},"issues":[],"timing_ms":{}}'));
    await generate(DEFAULTS, signal);
    const [url, sent] = fetched.mock.calls[0] ?? [];
    expect(url?.href).toBe(new URL("generate", document.baseURI).href);
    expect(JSON.parse(String(sent?.body))).toEqual({
      seed: 42, width: 20, depth: 15, min_room_size: 3, max_depth: 5, use_spine: true, outdoor: true,
    });
  });

  it("wrap a scene to be viewed", async () => {
    const fetched = answering(async () => new Response('{"text":"","lines":[]}'));
    await view(scene([]), signal);
    expect(Object.keys(JSON.parse(String(fetched.mock.calls[0]?.[1].body)))).toEqual(["scene"]);
  });

  it("say what the service says of a field", async () => {
    const document = { title: "A field is wrong", detail: "width is 5000; allowed: 2 to 1000", errors: [{ field: "width", problem: "is 5000", allowed: "2 to 1000" }] };
    answering(async () => new Response(JSON.stringify(document), { status: 422 }));
    const problem = await generate(DEFAULTS, signal).catch((reason: unknown) => reason);
    expect(problem).toBeInstanceOf(ServiceProblem);
    expect(problem).toMatchObject({ detail: document.detail, fields: document.errors });
  });

  it("say in clear words that the service is gone", async () => {
    answering(async () => { throw new TypeError("Failed to fetch"); });
    await expect(generate(DEFAULTS, signal)).rejects.toMatchObject({ title: "The service does not answer" });
  });

  it("take an answer cut short for a lost service", async () => {
    answering(async () => new Response('{"scene":'));
    await expect(generate(DEFAULTS, signal)).rejects.toMatchObject({ title: "The service does not answer" });
  });

  it("let a withdrawn question pass as such", async () => {
    answering(async () => { throw new DOMException("gone", "AbortError"); });
    await expect(generate(DEFAULTS, signal)).rejects.toMatchObject({ name: "AbortError" });
  });

  it("have words for refusals without a document", () => {
    for (const status of [401, 413, 429, 503]) expect(problemFrom(status, null).detail).not.toBe("It gave no reason.");
    expect(problemFrom(418, null).detail).toBe("It gave no reason.");
  });
});

describe("words of a field", () => {
  it("add what is allowed, once", () => {
    expect(fieldWords({ field: "width", problem: "is 1", allowed: "2 to 1000" })).toBe("is 1; allowed: 2 to 1000");
    expect(fieldWords({ field: "width", problem: "must be 2 to 1000", allowed: "2 to 1000" })).toBe("must be 2 to 1000");
    expect(fieldWords({ field: "width", problem: "is wrong", allowed: "" })).toBe("is wrong");
    expect(fieldWords({ field: "program", problem: "no preset is called 'x'", allowed: "family, one_bed" }), "as the form's choices say it").toMatch(/; allowed: family, one bedroom$/);
  });

  it.each([
    ["; left out: 1 of CIRCLE, which is not read", " Left out: 1 of CIRCLE, which is not read."],
    [", whose layers are 'A'", " Its layers are 'A'."], ["; its walls: enclose no room", " Its walls enclose no room."], ["", ""],
  ])("say why a plan has no rooms%s", (why, said) => {
    const field = { field: "rooms", problem: `are none in this file${why}`, allowed: "a room" };
    expect(refusalWords(new ServiceProblem("A field is wrong", "", { fields: [field] })).lines).toEqual([`It holds no rooms.${said} What is needed: a room.`]);
  });
});

describe("the status", () => {
  it("counts a door that two rooms list as one", () => {
    const door = opening({ id: "door_1" });
    const window = opening({ id: "window_1", kind: "window" });
    const rooms = [room("a", [0, 0, 4, 4], { openings: [door, window], furniture: [piece("x"), piece("y")] }), room("b", [0, 4, 4, 4], { openings: [door] })];
    expect(countsOf(scene(rooms), [])).toEqual({ rooms: 2, doors: 1, windows: 1, furniture: 2, decorations: 0, issues: 0 });
  });

  it("counts no rule as broken by what a room lacks that nobody has furnished yet", () => {
    const lacks = (of: string): Issue => ({ rule: "missing_required", severity: "warning", room: of, ids: [], message: `${of} has no bed` });
    const other: Issue = { ...lacks("a"), rule: "door_clear" };
    const rooms = [room("a", [0, 0, 4, 4]), room("b", [0, 4, 4, 4], { furniture: [piece("x")] }), room("c", [4, 0, 4, 4])];
    const home = scene(rooms, { certificate: { rooms: { c: { proven: true } } } });
    expect([...unfurnishedOf(home)]).toEqual(["a"]);
    expect(brokenOf([lacks("a"), other, lacks("b"), lacks("c")], home)).toEqual([other, lacks("b"), lacks("c")]);
  });

  it("offers to furnish a plan whose rooms lack nothing, since none has a known type", () => {
    const rooms = [room("a", [0, 0, 4, 4], { type: "room" }), room("b", [0, 4, 4, 4], { type: "room" })];
    expect(unfurnishedWords([], scene(rooms))).toBe("Not furnished yet");
    expect(unfurnishedWords([], scene(rooms, { certificate: { rooms: { a: { proven: true } } } }))).toBe("");
    expect(unfurnishedWords([], scene([]))).toBe("");
  });

  it("takes the total time, or sums the stages", () => {
    expect(totalMs(12)).toBe(12);
    expect(totalMs({ plan: 1, place: 2 })).toBe(3);
    expect(totalMs({ plan: 1, place: 2, total: 3.5 })).toBe(3.5);
  });
});
