/**
 * What things cast their shadows with. A shadow is how far things are from the sun, which is written anyway: no pixel
 * works out a colour, and none is written.
 */
import { ShaderMaterial } from "three";
import { sharedMaterial } from "./shared_materials";

/** The material of this name; `point` is where a vertex lies, by what `head` brings. */
export function castingMaterial(name: string, point = "position", head = ""): ShaderMaterial {
  return sharedMaterial(name, () => new ShaderMaterial({
    vertexShader: `${head}
void main() {
  vec4 placed = vec4(${point}, 1.0);
#ifdef USE_INSTANCING
  placed = instanceMatrix * placed;
#endif
  gl_Position = projectionMatrix * modelViewMatrix * placed;
}`,
    fragmentShader: "void main() {}",
    colorWrite: false,
  }));
}
