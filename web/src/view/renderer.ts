/** The renderer as the machine can afford it: without a graphics card edges of things stay hard, those of shadows nearly so, what is round has fewer faces, and nothing has highlights. */
import { PCFShadowMap, ShaderChunk, WebGLRenderer } from "three";
import { lightPlainly } from "../house/lit";
import { makeCoarsely } from "../house/part_geometry";
import { ServiceProblem } from "../service";

/** What draws with a processor says so by name. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
/** Said in place of a name, which is then told on demand. */
const MASKED = /webkit/i;

/** Whether a processor does the work of a graphics card. */
function isSoftware(gl: WebGLRenderingContext | WebGL2RenderingContext): boolean {
  const name = String(gl.getParameter(gl.RENDERER));
  const known = MASKED.test(name) ? gl.getExtension("WEBGL_debug_renderer_info") : null;
  return SOFTWARE.test(known ? String(gl.getParameter(known.UNMASKED_RENDERER_WEBGL)) : name);
}

/** A shadow's edge is asked for at five places, which softens it. */
const SOFT = /shadow = \(\s*texture\( shadowMap, vec3\( shadowCoord\.xy \+ vogelDiskSample\([^;]*\) \* 0\.2;/;

/** The shader's part for shadows with one place asked for, between four of the map: edges are lines, not steps. */
export function shadedOnce(chunk: string): string {
  return chunk.replace(SOFT, "shadow = texture( shadowMap, shadowCoord.xyz );");
}

/** How bright a colour is shown, by powers. */
const BY_POWERS = "pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 )";
/** By roots, which a processor draws sooner than powers: nowhere 0.4 of 255 off. */
const BY_ROOTS = "0.585122381 * sqrt( value.rgb ) + 0.783140355 * sqrt( sqrt( value.rgb ) ) - 0.368262736 * sqrt( sqrt( sqrt( value.rgb ) ) )";

/** The shader's part for colours with roots in place of powers. */
export function shownByRoots(chunk: string): string {
  return chunk.replace(BY_POWERS, BY_ROOTS);
}

const NO_WEBGL = new ServiceProblem("This browser draws nothing in 3D", "WebGL 2 is missing or switched off, and the page cannot do without it. Switch it on in the browser's settings, or take another browser.");

export const CARD_LOST = new ServiceProblem("The graphics card was taken away", "The house is drawn again as soon as it is back, which mostly happens by itself. Nothing is lost; to try again loads the page anew.");

/** Throws a ServiceProblem where the browser draws nothing. */
function made(isFine: boolean): WebGLRenderer {
  try {
    const renderer = new WebGLRenderer({ alpha: true, antialias: isFine, powerPreference: "low-power" });
    renderer.shadowMap.type = PCFShadowMap;
    return renderer;
  } catch {
    throw NO_WEBGL;
  }
}

/** Where a processor draws, smooth edges and soft shadows would cost more than all else: they are left out, and nothing is made twice. */
export function rendererForMachine(): WebGLRenderer {
  const plain = made(false);
  if (isSoftware(plain.getContext())) {
    lightPlainly();
    makeCoarsely();
    ShaderChunk.shadowmap_pars_fragment = shadedOnce(ShaderChunk.shadowmap_pars_fragment);
    ShaderChunk.colorspace_pars_fragment = shownByRoots(ShaderChunk.colorspace_pars_fragment);
    return plain;
  }
  plain.dispose();
  plain.forceContextLoss();
  return made(true);
}
