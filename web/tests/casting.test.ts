/** What casts shadows: no pixel works out a colour, and things cast them where they stand. */
import { ShaderMaterial, type BufferGeometry, type Mesh } from "three";
import { describe, expect, it } from "vitest";
import { Walls } from "../src/house/wall_meshes";
import { partMaterials } from "../src/house/part_shader";
import { cutAll } from "../src/house/wall_cut";

function casts(material: unknown): ShaderMaterial {
  expect(material).toBeInstanceOf(ShaderMaterial);
  return material as ShaderMaterial;
}

describe("what casts a shadow", () => {
  it("writes how far it is from the sun, and no colour", () => {
    const walls = new Walls({ runs: [], openings: [], storeys: new Map(), rooms: [] }).meshes(cutAll(1)).children[0] as Mesh<BufferGeometry>;
    for (const one of [partMaterials().shadow, walls.customDepthMaterial].map(casts)) {
      expect(one.colorWrite).toBe(false);
      expect(one.fragmentShader.replace(/\s/g, "")).toBe("voidmain(){}");
    }
  });

  it("is as large as what is seen of it", () => {
    expect(partMaterials().shadow.vertexShader).toContain("vec4(partPoint(), 1.0)");
    expect(partMaterials().shadow.vertexShader).toMatch(/instanceMatrix \* placed/);
  });
});
