/** Floor patterns made in code, in greys: the floor's colour multiplies them. Made once for the life of the page. */
import { CanvasTexture, RepeatWrapping, SRGBColorSpace, type Texture } from "three";

const SIZE = 512;
/** How much floor one texture covers [m]; floors take their metres as texture coordinates. */
export const TEXTURE_SPAN = 2.4;

type Painter = (canvas: CanvasRenderingContext2D, draw: () => number) => void;

/** A small seeded stream, so that a floor looks the same every time. */
function stream(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
}

function grey(value: number): string {
  const channel = Math.round(Math.max(0, Math.min(1, value)) * 255);
  return `rgb(${channel} ${channel} ${channel})`;
}

function planks(rows: number, gap: number): Painter {
  return (canvas, draw) => {
    const height = SIZE / rows;
    for (let row = 0; row < rows; row += 1) {
      const shift = draw() * SIZE;
      for (const half of [0, 1]) {
        const left = (shift + (half * SIZE) / 2) % SIZE;
        canvas.fillStyle = grey(0.86 + draw() * 0.14);
        for (const x of [left, left - SIZE]) canvas.fillRect(x, row * height, SIZE / 2, height);
        canvas.fillStyle = grey(0.62);
        canvas.fillRect(left, row * height, 1.5, height);
      }
      canvas.fillStyle = grey(gap > 2 ? 0.35 : 0.68);
      canvas.fillRect(0, row * height, SIZE, gap);
    }
  };
}

function tiles(across: number, joint: number, spread: number): Painter {
  return (canvas, draw) => {
    const size = SIZE / across;
    canvas.fillStyle = grey(0.7);
    canvas.fillRect(0, 0, SIZE, SIZE);
    for (let i = 0; i < across * across; i += 1) {
      canvas.fillStyle = grey(1 - draw() * spread);
      canvas.fillRect((i % across) * size + joint / 2, Math.floor(i / across) * size + joint / 2, size - joint, size - joint);
    }
  };
}

function speckles(count: number, low: number, high: number, length: number): Painter {
  return (canvas, draw) => {
    canvas.fillStyle = grey((low + high) / 2);
    canvas.fillRect(0, 0, SIZE, SIZE);
    for (let i = 0; i < count; i += 1) {
      canvas.fillStyle = grey(low + draw() * (high - low));
      canvas.fillRect(draw() * SIZE, draw() * SIZE, 1.5 + draw() * 1.5, 1.5 + draw() * length);
    }
  };
}

const PAINTERS: Readonly<Record<string, Painter>> = {
  wood: planks(16, 1.5),
  deck: planks(16, 4),
  tile: tiles(6, 3, 0.05),
  stone: tiles(4, 6, 0.2),
  concrete: speckles(9000, 0.9, 1, 2),
  grass: speckles(16000, 0.7, 1.05, 9),
};

/** The flooring types that have a texture. */
export const FLOOR_TYPES: readonly string[] = Object.keys(PAINTERS);

const made = new Map<string, Texture>();

/** The texture of a flooring type, or null for a type that is not known: it is drawn plain. */
export function floorTexture(type: string): Texture | null {
  const painter = PAINTERS[type];
  if (!painter) return null;
  const known = made.get(type);
  if (known) return known;
  const canvas = document.createElement("canvas");
  canvas.width = SIZE;
  canvas.height = SIZE;
  const context = canvas.getContext("2d");
  if (!context) return null;
  painter(context, stream(type.length * 7919));
  const texture = new CanvasTexture(canvas);
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 8;
  made.set(type, texture);
  return texture;
}
