/** Asks a core.wasm what tests/core/recording.py wrote down, in Node or in a browser: `node replay.js REPORT CORE RECORDING...`. */

const [WROTE, CALLED, BEGAN] = [1, 2, 3];
const MIXER = 2654435761;
const MOST = 10; // differences that are told

/** What words of a memory add up to, each times the odd number of its place. */
function sumOf(words, first, count) {
  let total = 0;
  for (let k = 0; k < count; k++) total = (total + Math.imul(words[first + k], Math.imul(k, MIXER) | 1)) | 0;
  return total;
}

/** Plays a recording; returns how many calls it held, and the differences. */
export async function replay(wasm, recording) {
  const module = await WebAssembly.compile(wasm);
  const view = new DataView(recording.buffer, recording.byteOffset, recording.byteLength);
  const types = new Map(); // which numbers of an export are BigInt, as it takes 64 bits: found out by trying
  const instances = new Map();
  const differences = [];
  let at = 0;
  let calls = 0;
  const word = () => view.getUint32((at += 4) - 4, true);
  const float = () => view.getFloat64((at += 8) - 8, true);
  const ask = (instance, name, given) => {
    const run = instance.exports[name];
    if (types.has(name)) return run(...given.map((value, k) => (types.get(name)[k] ? BigInt(value) : value)));
    for (let mask = 0; ; mask++) {
      const wide = given.map((_, k) => Boolean(mask & (1 << k)));
      types.set(name, wide);
      try {
        return run(...given.map((value, k) => (wide[k] ? BigInt(value) : value)));
      } catch (fault) {
        types.delete(name);
        if (!(fault instanceof TypeError) || mask >= 1 << given.length) throw fault;
      }
    }
  };
  while (at < view.byteLength) {
    const kind = word();
    const number = word();
    if (kind === BEGAN) {
      instances.set(number, new WebAssembly.Instance(module, {}));
      continue;
    }
    const instance = instances.get(number);
    if (kind === WROTE) {
      const first = word();
      const count = word();
      new Uint8Array(instance.exports.memory.buffer, first * 4, count * 4).set(
        new Uint8Array(recording.buffer, recording.byteOffset + at, count * 4),
      );
      at += count * 4;
      continue;
    }
    if (kind !== CALLED) throw new Error(`no such record: ${kind} at ${at}`);
    const length = word();
    const name = new TextDecoder().decode(new Uint8Array(recording.buffer, recording.byteOffset + at, length)).replace(/\0+$/, "");
    at += length;
    const [given, results] = [word(), word()];
    const values = Array.from({ length: given }, float);
    const expected = results ? float() : undefined;
    const answer = ask(instance, name, values);
    const size = word();
    const words = new Int32Array(instance.exports.memory.buffer);
    let total = 0;
    for (let runs = word(); runs > 0; runs--) {
      const first = word();
      total = (Math.imul(total, MIXER) + sumOf(words, first, word())) | 0;
    }
    calls += 1;
    const same = results === 0 || Object.is(Number(answer), expected);
    const sum = word();
    if (!same || words.length !== size || total >>> 0 !== sum) {
      differences.push({ call: calls, name, values, expected, answer: Number(answer), size: words.length, sum: total >>> 0 });
      if (differences.length === MOST) break;
    }
  }
  return { calls, differences };
}

if (globalThis.process?.argv) {
  const { readFileSync, writeFileSync } = await import("node:fs");
  const [report, core, ...recordings] = process.argv.slice(2);
  const wasm = readFileSync(core);
  const answers = [];
  for (const recording of recordings) answers.push(await replay(wasm, readFileSync(recording)));
  writeFileSync(report, JSON.stringify(answers));
}
