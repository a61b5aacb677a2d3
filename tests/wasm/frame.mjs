// Runs the frame of lib.rs, and holds it to a picture: node frame.mjs MODULE.wasm PICTURE, raw pixels of 3 bytes.
import { readFileSync } from "node:fs";

const [module, picture] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(module));
const expected = readFileSync(picture);
const address = instance.exports.model_scene();
const pixels = new Uint32Array(instance.exports.memory.buffer, address, expected.length / 3);

let differ = 0;
let largest = 0;
pixels.forEach((pixel, i) => {
  const error = Math.max(...[16, 8, 0].map((shift, channel) => Math.abs(((pixel >> shift) & 255) - expected[3 * i + channel])));
  differ += error > 1;
  largest = Math.max(largest, error);
});
console.log(`${differ} of ${pixels.length} pixels differ by more than 1 of 255, at most by ${largest}`);
// A thousandth of the pixels may lie on silhouettes that rounding moves.
process.exit(differ * 1000 > pixels.length ? 1 : 0);
