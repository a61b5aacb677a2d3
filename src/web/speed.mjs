// Measures the time of one thread for frames of the model scene by WebAssembly, of each quality: node speed.mjs SITE. It is processor
// time, which other programs on the machine do not lengthen, and counts making the scene. Frames of all qualities take turns.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";

const [width, height] = [1024, 768];
const FRAMES = 41;

const load = async (name) => (await WebAssembly.instantiate(gunzipSync(readFileSync(join(process.argv[2], `${name}.bin`))))).instance.exports;

/** The milliseconds of a frame. */
function draw(exports, place, time) {
  const before = process.cpuUsage();
  exports.set_model(time);
  exports.set_quality(place, false);
  for (let pass = 0, passes = 1; pass < passes; pass++) {
    exports.draw(0, height, pass, 0, pass);
    passes = new Float64Array(exports.memory.buffer, exports.figures(), 1)[0];
  }
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1000;
}

const median = (times) => times.sort((a, b) => a - b)[times.length >> 1];

const names = ["eightfold", "plain"];
const modules = await Promise.all(names.map(load));
modules.forEach((exports) => exports.resize(width, height));
const text = new TextDecoder().decode(new Uint8Array(modules[0].memory.buffer, modules[0].about(), 2000));
const { qualities } = JSON.parse(text.slice(0, text.indexOf("\0")));
const times = qualities.map(() => modules.map(() => []));
// The first frames are drawn while the engine still compiles.
for (let frame = -10; frame < FRAMES; frame++) {
  qualities.forEach((_, place) => modules.forEach((exports, module) => {
    const time = draw(exports, place, Math.max(frame, 0) / 4);
    if (frame >= 0) times[place][module].push(time);
  }));
}
console.log(`| quality | ${names.join(" | ")} |\n| --- | ---: | ---: |`);
qualities.forEach((quality, place) => console.log(`| ${quality} | ${times[place].map((times) => median(times).toFixed(2)).join(" | ")} |`));
