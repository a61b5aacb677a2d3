// Measures the processor time of one thread for frames of the model scene, scene construction included, at each quality: by the native
// program with SSE2, and by WebAssembly with and without SIMD, in turns. Then it measures frames of the show's scenes.
//
//     node speed.mjs SITE PROGRAM
//
// SITE is the page's folder, PROGRAM is target/release/examples/speed.
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { gunzipSync } from "node:zlib";

const [site, program] = process.argv.slice(2);
const [width, height] = [1024, 768];
const FRAMES = 41;
/** The size of the show's frames, and the seconds between them. */
const SHOW = { width: 1280, height: 720, step: 0.25 };

const load = async (name) => (await WebAssembly.instantiate(gunzipSync(readFileSync(join(site, `${name}.bin`))))).instance.exports;

/** Draws a frame with the native program. Returns its milliseconds. */
const native = (() => {
  const { stdin, stdout } = spawn(program, { stdio: ["pipe", "pipe", "inherit"] });
  const lines = createInterface({ input: stdout })[Symbol.asyncIterator]();
  return async (place, time) => {
    stdin.write(`${place} ${time}\n`);
    return Number((await lines.next()).value);
  };
})();

/** The same in a module, of the model scene or of the show. */
const byModule = (exports, setScene = exports.set_model, rows = height) => (place, time) => {
  const before = process.cpuUsage();
  setScene(time);
  if (!exports.set_quality(place, false)) throw new Error(`no quality ${place}`);
  for (let pass = 0, passes = 1; pass < passes; pass++) passes = exports.draw(0, rows, pass, 0, about.probes, pass);
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1000;
};

const median = (times) => times.toSorted((a, b) => a - b)[times.length >> 1];

const modules = await Promise.all(["eightfold", "plain"].map(load));
modules.forEach((exports) => exports.resize(width, height));
const text = new TextDecoder().decode(new Uint8Array(modules[0].memory.buffer, modules[0].about(), 2000));
const { qualities, scenes, length, ...about } = JSON.parse(text.slice(0, text.indexOf("\0")));
const ways = [native, ...modules.map((exports) => byModule(exports))];
const times = qualities.map(() => ways.map(() => []));
// The engine still compiles during the first frames.
for (let frame = -10; frame < FRAMES; frame++) {
  for (const place of qualities.keys()) {
    for (const [way, draw] of ways.entries()) {
      const time = await draw(place, Math.max(frame, 0) / 4);
      if (frame >= 0) times[place][way].push(time);
    }
  }
}
console.log("| quality | native, SSE2 | WebAssembly, SIMD128 | to native | without SIMD | to native |\n| --- | ---: | ---: | ---: | ---: | ---: |");
qualities.forEach((quality, place) => {
  const [own, ...others] = times[place].map(median);
  // The ratio of each frame, as disturbances last longer than a frame.
  const cells = others.map((time, other) => `${time.toFixed(1)} | ${median(times[place][other + 1].map((time, i) => time / times[place][0][i])).toFixed(2)}`);
  console.log(`| ${quality} | ${own.toFixed(1)} | ${cells.join(" | ")} |`);
});

const places = [about.default, qualities.length - 1];
modules[0].resize(SHOW.width, SHOW.height);
const drawShow = byModule(modules[0], modules[0].set_show, SHOW.height);
console.log(`\n| scene | ${places.map((place) => `${qualities[place]} | worst second`).join(" | ")} |\n| --- | ---: | ---: | ---: | ---: |`);
scenes.forEach(({ name, start }, i) => {
  const end = scenes[i + 1]?.start ?? length;
  const times = places.map(() => []);
  for (let time = start; time < end; time += SHOW.step) places.forEach((place, way) => times[way].push(drawShow(place, time)));
  const cells = times.map((times) => {
    const seconds = times.map((_, first) => times.slice(first, first + 1 / SHOW.step)).filter((second) => second.length === 1 / SHOW.step);
    const worst = Math.max(...seconds.map((second) => second.reduce((a, b) => a + b) * SHOW.step));
    return `${median(times).toFixed(1)} | ${worst.toFixed(1)}`;
  });
  console.log(`| ${name} | ${cells.join(" | ")} |`);
});
process.exit();
