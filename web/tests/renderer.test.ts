/** What the renderer changes in three's shaders for machines without a graphics card. */
import { ShaderChunk } from "three";
import { describe, expect, it } from "vitest";
import { shadedOnce, shownByRoots } from "../src/view/renderer";

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

/** What a shader's part shows for a brightness from 0 to 1, worked out as the part says it. */
function shown(chunk: string, brightness: number): number {
  const said = /vec4 sRGBTransferOETF\( in vec4 value \) \{\s*return vec4\( mix\( (.*), value\.rgb \* 12\.92/.exec(chunk)?.[1] ?? "";
  const script = said.replace(/vec3\( ([\d.]+) \)/g, "$1").replaceAll("value.rgb", "x").replace(/\b(pow|sqrt)\(/g, "Math.$1(");
  return (new Function("x", `return ${script}`) as (x: number) => number)(brightness);
}

describe("colours where a processor draws", () => {
  it("are as bright as elsewhere, without powers", () => {
    const [powers, roots] = [ShaderChunk.colorspace_pars_fragment, shownByRoots(ShaderChunk.colorspace_pars_fragment)];
    expect(roots.match(/pow\(/g)?.length).toBe((powers.match(/pow\(/g)?.length ?? 0) - 1);
    for (let x = 0.0032; x <= 1; x += 0.001) {
      const exact = 1.055 * x ** (1 / 2.4) - 0.055;
      expect(Math.abs(shown(powers, x) - exact) * 255).toBeLessThan(0.1);
      expect(Math.abs(shown(roots, x) - exact) * 255).toBeLessThan(0.5);
    }
  });
});
