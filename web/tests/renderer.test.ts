/** What the renderer changes in three's shaders for machines without a graphics card. */
import { ShaderChunk } from "three";
import { describe, expect, it } from "vitest";
import { shadedOnce } from "../src/view/renderer";

/** The directional light's own function, which comes first. */
function asked(chunk: string): number {
  const from = chunk.indexOf("float getShadow( sampler2DShadow shadowMap");
  const body = chunk.slice(from, chunk.indexOf("return mix(", from));
  return body.split("texture( shadowMap").length - 1;
}

describe("shadows where a processor draws", () => {
  it("are asked for at one place of the map instead of five", () => {
    expect(asked(ShaderChunk.shadowmap_pars_fragment)).toBe(5);
    expect(asked(shadedOnce(ShaderChunk.shadowmap_pars_fragment))).toBe(1);
  });
});
