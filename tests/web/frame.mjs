// Compares an exhaustive frame of the model scene with a picture of 640x360 RGB pixels: node frame.mjs MODULE.bin PICTURE
import { readFileSync } from "node:fs";
import { gunzipSync } from "node:zlib";

const [module, picture] = process.argv.slice(2);
const { instance: { exports } } = await WebAssembly.instantiate(gunzipSync(readFileSync(module)));
const expected = readFileSync(picture);
const [width, height] = [640, 360];
const address = exports.resize(width, height);
exports.set_model(2);
exports.set_quality(0, false);
exports.draw(0, height, 0, 0, 0, 0);
const pixels = new Uint32Array(exports.memory.buffer, address, width * height);

let differ = 0;
let largest = 0;
pixels.forEach((pixel, i) => {
  const error = Math.max(...[16, 8, 0].map((shift, channel) => Math.abs(((pixel >> shift) & 255) - expected[3 * i + channel])));
  differ += error > 1;
  largest = Math.max(largest, error);
});
console.log(`${differ} of ${pixels.length} pixels differ by more than 1 of 255, at most by ${largest}`);
// Rounding moves silhouettes in up to a thousandth of the pixels.
process.exit(differ * 1000 > pixels.length ? 1 : 0);
