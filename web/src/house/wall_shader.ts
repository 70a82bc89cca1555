/** The materials of walls and of what is flat as they are: colour, pattern and roughness are their vertices'. From afar a pattern fades into its mean. */
import { NoBlending, NormalBlending, type MeshStandardMaterialParameters, type WebGLProgramParametersWithUniforms } from "three";
import { sharedMaterial } from "./shared_materials";
import { lightAtCorners, litMaterial, type LitMaterial } from "./lit";
import { LAMPLIGHT, LAMP_UNIFORMS, lampUniforms, litByLamps } from "./lamps";
import { layerOf, MORTAR, patternUniform } from "./patterns";

const WOVEN = /* glsl */ `
{
  // Where a pattern's square is few pixels wide its lines would flicker.
  vec2 wide = fwidth(vWeave.xy);
  float far = smoothstep(0.04, 0.25, max(wide.x, wide.y));
  vec3 at = vec3(vWeave.xy, floor(vWeave.z + 0.5));
  float grey = texture(patterns, at).r;
  if (far > 0.0) grey = mix(grey, textureLod(patterns, at, 16.0).r, far);
  diffuseColor.rgb *= grey;
  float mortar = abs(at.z - ${layerOf("brick")}.0) < 0.5 ? smoothstep(${MORTAR}, 1.0, grey) : 0.0;
  diffuseColor.rgb = mix(diffuseColor.rgb, vec3(0.42, 0.38, 0.34), mortar * 0.7);
}`;

function weave(shader: WebGLProgramParametersWithUniforms): void {
  Object.assign(shader.uniforms, lampUniforms, { patterns: patternUniform });
  shader.vertexShader = shader.vertexShader
    .replace("#include <common>", "#include <common>\nattribute vec4 weave;\nvarying vec4 vWeave;")
    .replace("#include <project_vertex>", "vWeave = weave;\n#include <project_vertex>");
  shader.fragmentShader = shader.fragmentShader
    .replace("#include <common>", "#include <common>\nuniform highp sampler2DArray patterns;\nvarying vec4 vWeave;" + LAMP_UNIFORMS)
    .replace("#include <emissivemap_fragment>", LAMPLIGHT)
    .replace("#include <color_fragment>", `#include <color_fragment>\n${WOVEN}`)
    .replace("#include <roughnessmap_fragment>", "float roughnessFactor = vWeave.w;");
  lightAtCorners(shader);
}

/** A material that all share which ask for it by this name; what vertices do not say is plain and rough. All are drawn with one shader. */
export function faceMaterial(name: string, look: MeshStandardMaterialParameters = {}): LitMaterial {
  return sharedMaterial(name, () => {
    const material = litByLamps(litMaterial({ vertexColors: true, blending: look.transparent ? NormalBlending : NoBlending, ...look }));
    material.onBeforeCompile = weave;
    material.customProgramCacheKey = () => "face";
    return material;
  });
}
