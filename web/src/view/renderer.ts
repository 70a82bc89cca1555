/** The renderer as the machine can afford it: without a graphics card edges of things and of shadows stay hard, and nothing has highlights. */
import { BasicShadowMap, PCFShadowMap, WebGLRenderer } from "three";
import { lightPlainly } from "../house/lit";

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

function made(isFine: boolean): WebGLRenderer {
  const renderer = new WebGLRenderer({ alpha: true, antialias: isFine, powerPreference: "low-power" });
  renderer.shadowMap.type = isFine ? PCFShadowMap : BasicShadowMap;
  return renderer;
}

/** Where a processor draws, smooth edges and soft shadows would cost more than all else: they are left out, and nothing is made twice. */
export function rendererForMachine(): WebGLRenderer {
  const plain = made(false);
  if (isSoftware(plain.getContext())) {
    lightPlainly();
    return plain;
  }
  plain.dispose();
  plain.forceContextLoss();
  return made(true);
}
