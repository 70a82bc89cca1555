/**
 * three as the page asks for it. It is one object that knows everything, so no bundler can tell what is never reached: what is named
 * here is left out of what is built, 24 kB packed. A name that is gone from three ends the build.
 */
import type { Plugin } from "vite";

const SOURCE = /node_modules\/three\/(?:src|examples\/jsm)\/(.*?)(?:\.glsl)?\.js$/;

/** Modules, and all that is ever called of them here: no headset, no picture around the scene, nothing that moves in a .glb. */
const INSTEAD: Readonly<Record<string, string>> = {
  "renderers/webxr/WebXRManager": `export class WebXRManager {
    enabled = false; isPresenting = false;
    addEventListener() {} removeEventListener() {} setAnimationLoop() {} dispose() {} getEnvironmentBlendMode() {}
  }`,
  "renderers/WebGLCubeRenderTarget": "export class WebGLCubeRenderTarget {}",
  "extras/PMREMGenerator": "export class PMREMGenerator {}",
  "animation/AnimationClip": "export class AnimationClip {}",
  "animation/KeyframeTrack": "export class KeyframeTrack {}",
  "math/Interpolant": "export class Interpolant {}",
  "animation/PropertyBinding": "export class PropertyBinding { static sanitizeNodeName(name) { return name; } }",
};

/** Shaders of materials that nothing here is made of, and parts of others that stand behind an #ifdef that is never set. */
const NO_SHADERS = [
  "ShaderLib/(?:meshphong|meshtoon|meshmatcap|meshnormal|points|sprite|linedashed|cube|backgroundCube|equirect|distance|vsm)",
  "ShaderChunk/(?:lights_phong|lights_toon|gradientmap|skin|envmap|cube_uv|lightprobes|alphahash|logdepthbuf|fog|bumpmap|displacementmap|dithering)\\w*",
].map((names) => new RegExp(`^renderers/shaders/${names}$`));

/** Nothing of three's is written down as JSON. */
const TO_JSON = /\n\t(?:to|from)JSON\(.*\) \{\n[^]*?\n\t\}\n/g;

/** Shaders are text, which no minifier shortens: comments, and how lines are set in, say nothing. */
function shader(code: string): string {
  return code.replace(/\/\*(?! glsl)[^]*?\*\/|[\t ]*\/\/.*/g, "").replace(/\s*\n\s*/g, "\n");
}

export function leanThree(): Plugin {
  const missing = new Set([...Object.keys(INSTEAD), ...NO_SHADERS, TO_JSON]);
  return {
    name: "lean three",
    apply: "build",
    enforce: "pre",
    config: () => ({ resolve: { alias: [{ find: /^three$/, replacement: "three/src/Three.js" }] } }),
    transform: {
      filter: { id: SOURCE },
      handler(code, id) {
        const name = SOURCE.exec(id)?.[1] ?? "";
        const instead = INSTEAD[name];
        if (instead !== undefined) {
          missing.delete(name);
          return instead;
        }
        if (!id.endsWith(".glsl.js")) return code.replace(TO_JSON, () => (missing.delete(TO_JSON), "\n"));
        const unused = NO_SHADERS.find((names) => names.test(name));
        if (unused === undefined) return shader(code);
        missing.delete(unused);
        return code.includes("export default") ? "export default ''" : "export const vertex = '', fragment = ''";
      },
    },
    buildEnd(failed) {
      if (failed === undefined && missing.size > 0) this.error(`three has changed: ${[...missing].join(", ")}`);
    },
  };
}
