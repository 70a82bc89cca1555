/** What a pixel of a lit face works out: where a processor draws, not how it faces. */
import { ShaderLib, type Material, type WebGLProgramParametersWithUniforms } from "three";
import { afterEach, describe, expect, it, vi } from "vitest";

/** What a shader does for each vertex or pixel, without what lamps need. */
function main(text: string): string {
  return text.replace(/#ifdef LAMPS[\s\S]*?\n#endif/g, "").split("void main()")[1] ?? "";
}

/** What the shaders of a material do for every vertex and every pixel. */
function shaders(material: Material): { vertex: string; fragment: string } {
  const { vertexShader, fragmentShader } = ShaderLib.lambert;
  const shader = { vertexShader, fragmentShader, uniforms: {} } as unknown as WebGLProgramParametersWithUniforms;
  material.onBeforeCompile(shader, undefined as never);
  return { vertex: main(shader.vertexShader), fragment: main(shader.fragmentShader) };
}

/** The shaders of parts and of walls, made anew. */
async function made(isPlain: boolean): Promise<{ vertex: string; fragment: string }[]> {
  vi.resetModules();
  if (isPlain) (await import("../src/house/lit")).lightPlainly();
  const { partMaterials } = await import("../src/house/part_shader");
  const { faceMaterial } = await import("../src/house/wall_shader");
  return [partMaterials().solid, partMaterials().clear, faceMaterial("wall")].map(shaders);
}

describe("light", () => {
  afterEach(() => { vi.resetModules(); });

  it("is worked out for every pixel by a graphics card", async () => {
    for (const { fragment } of await made(false)) expect(fragment).toMatch(/<normal_fragment_begin>[\s\S]*<lights_fragment_begin>/);
  });

  it("is worked out at the corners of faces by a processor: no pixel asks how it faces", async () => {
    for (const { vertex, fragment } of await made(true)) {
      expect(vertex).toMatch(/vSteep = dot\(/);
      expect(fragment).toContain("vSteep");
      expect(fragment).not.toMatch(/<normal_fragment_begin>|<lights_|vNormal|vViewPosition|reflect\(/);
    }
  });
});
