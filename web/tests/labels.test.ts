import { describe, expect, it } from "vitest";
import { areaWithin, clearest, keptInside, layOut, onLine } from "../src/view/label_layout";

const wish = (x: number, y: number, importance: number) => ({ x, y, width: 80, height: 20, importance });

describe("label layout", () => {
  it("leaves labels that are apart where they wish to be", () => {
    expect(layOut([wish(0, 0, 1), wish(200, 0, 2)])).toEqual([{ x: 0, y: 0 }, { x: 200, y: 0 }]);
  });

  it("nudges the less important of two that would cover each other", () => {
    const [small, large] = layOut([wish(10, 5, 1), wish(0, 0, 2)]);
    expect(large).toEqual({ x: 0, y: 0 });
    expect(Math.abs((small?.y ?? 0) - 0)).toBeGreaterThanOrEqual(20);
  });

  it("never lets two labels cover each other, and drops those with no place", () => {
    const wishes = Array.from({ length: 20 }, (_, i) => wish(i, 0, i));
    const placed = layOut(wishes).flatMap((place) => place ?? []);
    expect(placed.length).toBeGreaterThan(4);
    expect(placed.length).toBeLessThan(20);
    for (const [i, a] of placed.entries()) {
      for (const b of placed.slice(i + 1)) expect(Math.abs(a.x - b.x) >= 80 || Math.abs(a.y - b.y) >= 20).toBe(true);
    }
  });
});

describe("a layout beside what lies over the canvas", () => {
  const bar = { x: 100, y: 25, width: 200, height: 42 };

  it("moves labels out from under it, or leaves them out", () => {
    const [under, below, beside] = layOut([wish(60, 30, 1), wish(60, 90, 1), wish(300, 30, 1)], [bar]);
    expect(under?.y).toBeGreaterThanOrEqual(25 + 21 + 10);
    expect([below, beside]).toEqual([{ x: 60, y: 90 }, { x: 300, y: 30 }]);
    expect(layOut([wish(60, 30, 1)], [{ ...bar, height: 400 }])).toEqual([null]);
  });

  it("takes what is shown in any case further than others, clear of all that lies there", () => {
    const wall = { ...bar, y: 30, height: 90 };
    expect(layOut([wish(60, 30, 1)], [wall])).toEqual([null]);
    const [place] = layOut([{ ...wish(60, 30, 1), stays: true }], [wall]);
    expect(Math.abs((place?.y ?? 30) - 30)).toBeGreaterThanOrEqual(45 + 10);
  });
});

describe("a layout on a small canvas", () => {
  const canvas = { width: 320, height: 90 };
  const within = ({ x, y }: { x: number; y: number }, width: number, height: number): boolean =>
    x - width / 2 >= 0 && x + width / 2 <= canvas.width && y - height / 2 >= 0 && y + height / 2 <= canvas.height;

  it("takes what is shown in any case beside what lies from top to bottom, and nothing off the canvas", () => {
    const column = { x: 160, y: 45, width: 10, height: 90 };
    const [place] = layOut([{ ...wish(160, 45, 1), stays: true }], [column], canvas);
    expect(Math.abs((place?.x ?? 160) - 160)).toBeGreaterThanOrEqual(45);
    const crowd = Array.from({ length: 12 }, (_, i) => wish(40 + i * 20, 10, i));
    const placed = layOut(crowd, [], canvas).flatMap((one) => one ?? []);
    expect(placed.length).toBeGreaterThan(3);
    for (const one of placed) expect(within(one, 80, 20), JSON.stringify(one)).toBe(true);
  });

  it("has the words of a line on it, clear of what lies at its edge", () => {
    const bar = { x: 160, y: 75, width: 320, height: 30 };
    const place = onLine([{ x: 160, y: 50 }, { x: 160, y: 88 }], 1, { width: 90, height: 18 }, [bar], canvas);
    expect(within(place, 90, 18)).toBe(true);
    expect(place.y + 9).toBeLessThanOrEqual(60);
  });
});

describe("what corners enclose", () => {
  it("is as large whichever way they run, also where they turn inwards", () => {
    const corner = (x: number, y: number) => ({ x, y });
    const angle = [corner(0, 0), corner(4, 0), corner(4, 1), corner(1, 1), corner(1, 3), corner(0, 3)];
    expect(areaWithin(angle)).toBe(6);
    expect(areaWithin([...angle].reverse())).toBe(6);
    expect(areaWithin([])).toBe(0);
  });
});

describe("a label at the edge", () => {
  it("is moved onto the canvas, others stay", () => {
    const canvas = { width: 400, height: 300 };
    expect(keptInside(wish(200, 150, 1), canvas)).toEqual({ x: 200, y: 150 });
    for (const at of [wish(1, 1, 1), wish(399, 299, 1)]) {
      const { x, y } = keptInside(at, canvas);
      expect(x - 40 >= 0 && x + 40 <= 400 && y - 10 >= 0 && y + 10 <= 300).toBe(true);
    }
  });
});

describe("a layout of many labels", () => {
  it("leaves none of 150 covered, keeping the more important", () => {
    const wishes = Array.from({ length: 150 }, (_, i) => wish((i * 97) % 900, (i * 61) % 600, i));
    const places = layOut(wishes);
    expect(places.at(-1)).toEqual({ x: wishes.at(-1)?.x, y: wishes.at(-1)?.y });
    const placed = places.flatMap((place) => place ?? []);
    expect(placed.length).toBeGreaterThan(80);
    for (const [i, a] of placed.entries()) {
      for (const b of placed.slice(i + 1)) expect(Math.abs(a.x - b.x) >= 80 || Math.abs(a.y - b.y) >= 20).toBe(true);
    }
  });
});

describe("a name that may be in several places", () => {
  const label = { width: 60, height: 20 };
  const places = [{ x: 100, y: 100 }, { x: 160, y: 100 }, { x: 100, y: 40 }];
  const sofa = { x: 100, y: 110, width: 40, height: 30 };

  it("takes the nearest that covers nothing, the least covered where all cover something", () => {
    expect(clearest(label, places, [])).toBe(places[0]);
    expect(clearest(label, places, [sofa])).toBe(places[1]);
    expect(clearest(label, places, [sofa, { x: 150, y: 100, width: 300, height: 300 }])).toBe(places[1]);
    expect(clearest(label, [], [sofa])).toBeUndefined();
  });

  it("stays where it was while no other place is better", () => {
    expect(clearest(label, places, [], places[2])).toBe(places[2]);
    expect(clearest(label, places, [sofa], places[0])).toBe(places[1]);
  });
});

describe("the words of a line", () => {
  const line = [{ x: 100, y: 100 }, { x: 100, y: 300 }] as const;
  const extent = { width: 50, height: 18 };
  const handle = (y: number) => ({ x: 100, y, width: 28, height: 28 });

  it("are at their place, or near it on the line where something lies there", () => {
    expect(onLine(line, 0.5, extent, [])).toEqual({ x: 100, y: 200 });
    const moved = onLine(line, 0.5, extent, [handle(200)]);
    expect([moved.x, Math.abs(moved.y - 200) >= 23]).toEqual([100, true]);
    for (const at of [0, 1]) {
      const { y } = onLine(line, at, extent, [handle(100 + at * 200)]);
      expect(y > 100 && y < 300, `${at}`).toBe(true);
    }
  });

  it("are beside a line of which all is covered, or stay where everything is", () => {
    const short = [{ x: 100, y: 200 }, { x: 100, y: 230 }] as const;
    const beside = onLine(short, 0.5, extent, [handle(200), handle(230)]);
    expect(Math.abs(beside.x - 100)).toBeGreaterThanOrEqual(39);
    expect(beside.y).toBe(215);
    expect(onLine(short, 0.5, extent, [{ x: 100, y: 200, width: 900, height: 900 }])).toEqual({ x: 100, y: 215 });
  });
});
