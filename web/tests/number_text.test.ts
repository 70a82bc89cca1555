import { describe, expect, it } from "vitest";
import { asNumber } from "../src/panel/number_text";

describe("a number field", () => {
  it.each(["0", "-3", "2.5", ".5", "1e21", "1E-7", "007", "-0.25", "1.7976931348623157e+308"])("takes %s as it is", (text) => {
    expect(asNumber(text)).toBe(text);
  });

  it.each(["", "NaN", "Infinity", "-", "+1", "1.", "0x10", "1,5", "wide", "1 2", "1e999", "9".repeat(400)])("is left empty for %s", (text) => {
    expect(asNumber(text)).toBe("");
  });
});
