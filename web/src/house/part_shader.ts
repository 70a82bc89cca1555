/**
 * The materials that all parts share. A part's size, colour and finish are its instance's: the vertex shader makes the
 * solid of its size (rounding and taper are metres, never stretched) and lays the pattern on in metres.
 */
import { NoBlending, NormalBlending, type ShaderMaterial, type WebGLProgramParametersWithUniforms } from "three";
import { castingMaterial } from "./casting";
import { sharedMaterial } from "./shared_materials";
import { evenly, lightAtCorners, litMaterial, type LitMaterial } from "./lit";
import { LAMPLIGHT, LAMP_UNIFORMS, lampUniforms, litByLamps } from "./lamps";
import { RULE } from "./part_geometry";
import { patternSpans, patternUniform } from "./patterns";

const SHAPE = /* glsl */ `
attribute vec4 span; // size [m]; rounding [m] of a block, taper of a cylinder
attribute vec2 rule; // how far around; which rule

bool isRule(float wanted) { return abs(rule.y - wanted) < 0.5; }

vec3 partPoint() {
  vec3 size = span.xyz;
  if (rule.y < 2.5) return position * (size - 2.0 * span.w) + normal * span.w;
  if (isRule(${RULE.ball}.0)) return position * size;
  if (isRule(${RULE.capsule}.0)) {
    float r = min(min(size.x, size.z), size.y) * 0.5;
    return vec3(normal.x * size.x * 0.5, position.y * (size.y - 2.0 * r) + normal.y * r, normal.z * size.z * 0.5);
  }
  float near = span.w > 1.0 ? 1.0 / span.w : 1.0;
  float width = mix(near, min(span.w, 1.0), position.y + 0.5);
  return vec3(position.x * width, position.y, position.z * width) * size;
}

vec3 partNormal() {
  vec3 size = max(span.xyz, vec3(1e-5));
  if (rule.y < 2.5 || isRule(${RULE.cap}.0)) return normal;
  if (isRule(${RULE.ball}.0)) return normalize(normal / size);
  if (isRule(${RULE.capsule}.0)) return normalize(normal / vec3(size.x, min(min(size.x, size.z), size.y), size.z));
  float near = span.w > 1.0 ? 1.0 / span.w : 1.0;
  return normalize(vec3(normal.x * 2.0 / size.x, (near - min(span.w, 1.0)) / size.y, normal.z * 2.0 / size.z));
}`;

/** What the vertices of a part hand to its pixels. */
function handedOn(): string {
  return /* glsl */ `
${evenly()} vec4 vTint;
${evenly()} vec4 vFinish;
varying vec2 vWeave;
varying vec2 vMirrored;`;
}

const WEAVE = /* glsl */ `
attribute vec4 tint; // colour, opacity
attribute vec4 finish; // roughness, metalness, glow, pattern
uniform float patternSpans[${patternSpans.length}];

// Where on its pattern a vertex lies [m]: the grain runs along the longer side.
vec2 weave(vec3 at) {
  vec2 flatAt = vec2(at.y, rule.x * 1.5708 * (span.x + span.z));
  vec2 sides = vec2(1.0, 0.0);
  if (rule.y < 0.5) { flatAt = at.zy; sides = span.zy; }
  else if (rule.y < 1.5 || isRule(${RULE.cap}.0)) { flatAt = at.xz; sides = span.xz; }
  else if (rule.y < 2.5) { flatAt = at.xy; sides = span.xy; }
  vec2 shift = fract(sin(vec2(dot(instanceMatrix[3].xyz, vec3(12.99, 78.23, 37.72)), dot(span.xyz, vec3(39.35, 11.14, 83.16)))) * 437.58);
  return (sides.x < sides.y ? flatAt.yx : flatAt) / patternSpans[int(finish.w + 0.5)] + shift;
}

// How high above the horizon a vertex mirrors what is around, and how flatly it is seen.
vec2 mirrored(vec3 facing, vec3 at) {
  vec3 gaze = normalize(at);
  float along = dot(gaze, facing);
  float flatly = 1.0 - abs(along);
  return vec2(dot(gaze - 2.0 * along * facing, viewMatrix[1].xyz), flatly * flatly * flatly);
}`;

const TO_PIXELS = /* glsl */ `
#include <project_vertex>
vTint = tint;
vFinish = finish;
vWeave = weave(transformed);
vMirrored = mirrored(normalize(transformedNormal), mvPosition.xyz);`;

/** Rougher than this metal is no mirror. */
const MIRROR_ROUGHNESS = 0.07;

/** How much of what falls on bare metal it mirrors. */
const METAL = 0.55;

const REFLECTION = /* glsl */ `
if (vFinish.y + vFinish.z > 0.0) {
  // Metal and glass show the sky, brighter above than below: there is no picture of the surroundings to mirror.
  float rise = vMirrored.x;
  float sky = mix(0.18, 0.95, smoothstep(-0.5, 0.8, rise));
  totalEmissiveRadiance += diffuseColor.rgb * (vFinish.z + vFinish.y * sky * 0.6);
  if (vFinish.x < ${MIRROR_ROUGHNESS} && vFinish.y > 0.5) {
    // A mirror has no colour of its own: a bright room, the sky above it, and light lying across in bands.
    float across = vWeave.x + vWeave.y * 0.8;
    float band = smoothstep(0.30, 0.36, fract(across)) * (1.0 - smoothstep(0.56, 0.60, fract(across)))
      + 0.6 * smoothstep(0.66, 0.69, fract(across)) * (1.0 - smoothstep(0.72, 0.75, fract(across)));
    vec3 shown = mix(vec3(0.40, 0.47, 0.52), vec3(0.52, 0.70, 0.86), smoothstep(-0.35, 0.45, rise));
    totalEmissiveRadiance = shown * 0.8 + vec3(0.22 * band + 0.25 * vMirrored.y);
    diffuseColor.rgb *= 0.3;
  }
#ifndef STANDARD
  diffuseColor.rgb *= 1.0 - ${METAL} * vFinish.y;
#endif
}`;

function paint(shader: WebGLProgramParametersWithUniforms): void {
  Object.assign(shader.uniforms, lampUniforms, { patterns: patternUniform });
  shader.uniforms.patternSpans = { value: patternSpans };
  shader.vertexShader = shader.vertexShader
    .replace("#include <common>", `#include <common>\n${SHAPE}${WEAVE}${handedOn()}`)
    .replace("#include <begin_vertex>", "vec3 transformed = partPoint();")
    .replace("#include <beginnormal_vertex>", "vec3 objectNormal = partNormal();")
    .replace("#include <project_vertex>", TO_PIXELS);
  shader.fragmentShader = shader.fragmentShader
    .replace("#include <common>", "#include <common>\nuniform highp sampler2DArray patterns;" + handedOn() + LAMP_UNIFORMS)
    .replace("#include <color_fragment>", "diffuseColor *= vTint;\ndiffuseColor.rgb *= texture(patterns, vec3(vWeave, floor(vFinish.w + 0.5))).r;")
    .replace("#include <roughnessmap_fragment>", "float roughnessFactor = vFinish.x;")
    .replace("#include <metalnessmap_fragment>", `float metalnessFactor = ${METAL} * vFinish.y;`)
    .replace("#include <emissivemap_fragment>", REFLECTION + LAMPLIGHT);
  lightAtCorners(shader);
}

/** What is solid does not blend either: told so, it is drawn with the shader of what is clear. */
function lit(clear: boolean): LitMaterial {
  const material = litByLamps(litMaterial({ transparent: clear, depthWrite: !clear, blending: clear ? NormalBlending : NoBlending }));
  material.onBeforeCompile = paint;
  material.customProgramCacheKey = () => "part";
  return material;
}

interface PartMaterials {
  readonly solid: LitMaterial;
  readonly clear: LitMaterial;
  readonly shadow: ShaderMaterial;
}

/** The materials of all parts, made once for the life of the page. */
export function partMaterials(): PartMaterials {
  return {
    solid: sharedMaterial("part", () => lit(false)),
    clear: sharedMaterial("clear part", () => lit(true)),
    shadow: castingMaterial("part shadow", "partPoint()", SHAPE),
  };
}
