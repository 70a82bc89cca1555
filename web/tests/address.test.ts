import { describe, expect, it } from "vitest";
import { drawing, randomRequest } from "./random_requests";
import { anotherSeed, DEFAULTS, FIRST, numberOrText, queryFromRequest, requestFromQuery, unreadIn } from "../src/address";

describe("the address", () => {
  it("when bare asks for the defaults, spine and outdoor on", () => {
    expect(requestFromQuery("")).toEqual(FIRST);
    expect(requestFromQuery("?seed=42")).toEqual(DEFAULTS);
    expect(DEFAULTS).toMatchObject({ use_spine: true, outdoor: true, width: 20, depth: 15, min_room_size: 3, max_depth: 5 });
  });

  it("gives back every request written to it", () => {
    for (const request of [DEFAULTS, { ...DEFAULTS, seed: 2 ** 53 - 1, width: 12.5, use_spine: false, outdoor: false }]) {
      expect(requestFromQuery(queryFromRequest(request))).toEqual(request);
    }
  });

  it("gives back any request, also read from a link that was copied", () => {
    const draw = drawing(20261121);
    for (let i = 0; i < 500; i += 1) {
      const request = randomRequest(draw);
      const query = queryFromRequest(request);
      expect(requestFromQuery(query)).toEqual(request);
      expect(requestFromQuery(new URL(`http://127.0.0.1/${query}`).search)).toEqual(request);
      expect(queryFromRequest(requestFromQuery(query))).toBe(query);
    }
  });

  it("reads the camelCase spelling as the other", () => {
    const [snake, camel] = ["?min_room_size=2.5&max_depth=3&use_spine=0&robot_width=0.5", "?minRoomSize=2.5&maxDepth=3&useSpine=0&robotWidth=0.5"];
    expect(requestFromQuery(camel)).toEqual(requestFromQuery(snake));
    expect(requestFromQuery("?forceTypes.3=kitchen").force_types).toEqual({ 3: "kitchen" });
  });

  it("passes on what is no number, for the service to judge", () => {
    expect(requestFromQuery("?width=wide&seed=-1")).toMatchObject({ width: "wide", seed: -1 });
    expect(requestFromQuery(queryFromRequest({ ...DEFAULTS, width: "<b>" })).width).toBe("<b>");
    expect(numberOrText("")).toBe("");
    expect(numberOrText("Infinity")).toBe("Infinity");
    expect(numberOrText(" 3.5 ")).toBe(3.5);
  });

  it("takes an outline as a word or by its corners, which say how large the house is", () => {
    expect(requestFromQuery("?program=family&outline=L")).toEqual({ seed: 42, outdoor: true, program: "family", outline: "L" });
    expect(requestFromQuery("?program=family&outline=any")).toEqual({ seed: 42, outdoor: true, program: "family" });
    const cut = requestFromQuery("?seed=3&outline=0,0+9,0+9,5.5+5,5.5+5,9+0,9");
    expect(cut.outline).toEqual([[0, 0], [9, 0], [9, 5.5], [5, 5.5], [5, 9], [0, 9]]);
    expect(requestFromQuery("?seed=3&outline=0,0%2B9,0%2B9,5.5%2B5,5.5%2B5,9%2B0,9"), "as others write the address anew").toEqual(cut);
    expect([cut.width, cut.depth, cut.min_room_size]).toEqual([undefined, undefined, 3]);
    expect(requestFromQuery(queryFromRequest(cut))).toEqual(cut);
    expect(requestFromQuery("?outline=0,0+9,wide").outline).toBe("0,0 9,wide");
  });

  it("ignores what it does not know, and tells it apart for who asks", () => {
    expect(requestFromQuery("?colour=red&__proto__=x")).toEqual(FIRST);
    expect(JSON.stringify(unreadIn("?colour=red&__proto__=x&seed=4&force_types.3=kitchen&forceTypes.4=office&minRoomSize=3&programs.x=1"))).toBe(
      '{"colour":"red","__proto__":"x","programs.x":"1"}');
    expect(unreadIn(queryFromRequest({ ...DEFAULTS, ...FIRST, outline: "L", style: "japandi", access: "wheelchair", force_types: { 3: "kitchen" } }))).toEqual({});
  });
});

describe("another seed", () => {
  it("is a small whole number and never the same", () => {
    expect(anotherSeed(1, () => 0.5)).toBe(500000);
    expect(anotherSeed(500000, () => 0.5)).toBe(500001);
    expect(anotherSeed(999999, () => 0.9999999)).toBe(0);
  });
});
