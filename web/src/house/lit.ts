/**
 * What light falls on. Where a processor draws, it is without highlights, and what falls on a face is worked out at its
 * corners: for every pixel it would cost a third of a frame, and from outside next to nothing of it is seen.
 */
import { MeshLambertMaterial, MeshStandardMaterial, type MeshStandardMaterialParameters, type WebGLProgramParametersWithUniforms } from "three";

export type LitMaterial = MeshLambertMaterial | MeshStandardMaterial;

let isPlain = false;

/** From now on highlights are left out; to be called before anything is built. */
export function lightPlainly(): void {
  isPlain = true;
}

export function litMaterial({ roughness = 1, ...look }: MeshStandardMaterialParameters): LitMaterial {
  return isPlain ? new MeshLambertMaterial(look) : new MeshStandardMaterial({ roughness, ...look });
}

/** How steeply the sun falls, the shadow apart, and all other light. Both are spread over a face from its corners. */
const FALLING = /* glsl */ `
varying float vSteep;
varying vec3 vOtherLight;`;

const AT_CORNERS = /* glsl */ `
vec3 facing = normalize(transformedNormal);
vSteep = dot(facing, directionalLights[0].direction);
vOtherLight = ambientLightColor + getHemisphereLightIrradiance(hemisphereLights[0], facing);
for (int i = 1; i < NUM_DIR_LIGHTS; i++) vOtherLight += directionalLights[i].color * max(0.0, dot(facing, directionalLights[i].direction));
#include <shadowmap_vertex>`;

const BETWEEN = /* glsl */ `
float steep = max(0.0, vSteep);
#ifdef USE_SHADOWMAP
if (receiveShadow) {
  DirectionalLightShadow shade = directionalLightShadows[0];
  steep *= getShadow(directionalShadowMap[0], shade.shadowMapSize, shade.shadowIntensity, shade.shadowBias, shade.shadowRadius, vDirectionalShadowCoord[0]);
}
#endif
reflectedLight.directDiffuse = BRDF_Lambert(diffuseColor.rgb) * (directionalLights[0].color * steep + vOtherLight);`;

/** Only lamps ask how a pixel faces. */
const FACING = "#ifdef LAMPS\n#include <normal_fragment_begin>\n#endif";

/** Where a processor draws, lights a material's shader at the corners of faces. */
export function lightAtCorners(shader: WebGLProgramParametersWithUniforms): void {
  if (!isPlain) return;
  shader.vertexShader = shader.vertexShader
    .replace("#include <normal_pars_vertex>", `#include <normal_pars_vertex>\n#include <lights_pars_begin>${FALLING}`)
    .replace("#include <shadowmap_vertex>", AT_CORNERS);
  shader.fragmentShader = shader.fragmentShader
    .replace("#include <normal_pars_fragment>", `#include <normal_pars_fragment>${FALLING}`)
    .replace("#include <normal_fragment_begin>", FACING)
    .replace("#include <lights_lambert_fragment>", "")
    .replace("#include <lights_fragment_begin>", BETWEEN)
    .replace("#include <lights_fragment_maps>", "")
    .replace("#include <lights_fragment_end>", "");
}

/** How a shader hands on what is the same all over a face: a processor need not spread it. */
export function evenly(): string {
  return isPlain ? "flat varying" : "varying";
}
