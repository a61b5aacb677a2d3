// A worker: draws its rows of a frame, pass by pass, with its own instance.

import { Module } from "./module.js";

let module;

/** The picture's pixels, a word each. */
const picture = () => module.view(Uint32Array, module.pixels, module.width * module.height);

const row = (y) => picture().slice(y * module.width, (y + 1) * module.width);

/** Draws a pass. Returns its results, and in the last pass the rows as RGBA. */
function draw({ from, to, pass, before, probes, seed, rows }) {
  const start = performance.now();
  for (const [y, pixels] of rows) picture().set(pixels, y * module.width);
  const passes = module.calls.draw(from, to, pass, before, probes, seed);
  const [first, end, points, rays, probed, squares, fourths] = module.view(Float64Array, module.calls.figures(), 7);
  const done = { passes, first, end, points, rays, probed, squares, fourths };
  const hasRows = first < end;
  if (pass + 1 < passes) {
    if (hasRows) done.edges = [row(first), row(end - 1)];
  } else if (hasRows) {
    module.calls.colour(first, end);
    const bytes = new Uint8ClampedArray(picture().buffer, module.pixels, 4 * module.width * module.height);
    done.bytes = bytes.slice(4 * module.width * first, 4 * module.width * end);
  }
  done.milliseconds = performance.now() - start;
  return done;
}

/** Answers messages in order; the first one has the module. */
let last = Promise.resolve();
onmessage = ({ data }) => (last = last.then(() => answer(data)).catch((error) => setTimeout(() => { throw error; })));

async function answer({ compiled, file, order, number, ...part }) {
  if (compiled) module = await Module.of(compiled);
  if (file) module.read(file);
  if (!order) return;
  if (part.pass === 0) module.begin(order);
  const done = draw(part);
  postMessage({ number, done }, done.bytes ? [done.bytes.buffer] : []);
}
