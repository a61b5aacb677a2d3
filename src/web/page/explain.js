// Explains the method: a picture of each step, and a plot of the cost of speed, both made in this browser.

import { bytesOf, decibels, squaredError } from "./frames.js";
import { isMeasurable, now } from "./times.js";

/** The time in the model scene, in seconds, and the pictures' sizes. */
const TIME = 2;
const STEP = { width: 224, height: 168 };
const MEASURED = { width: 640, height: 360 };

/**
 * A frame's time is the minimum of some takes, as other programs disturb it least. Takes end when three differ by at most 5 %, or when
 * their sum in milliseconds is long: after two takes with a clock of coarse steps.
 */
const TAKES = 20;
const AGREEING = 3;
const AGREEMENT = 1.05;
const LONG = 1500;

/** The maximum number of frames in a take. */
const MOST = 1000;

/** The maximum number of intervals on an axis. */
const TICKS = 8;

/** The plot's frame: left, right, top, bottom. */
const PLOT = { left: 34, right: 310, top: 8, bottom: 152 };

/** Waits until the browser is idle and the show paused. */
async function idle(isIdle) {
  do await new Promise((resolve) => setTimeout(resolve, 50));
  while (!isIdle() || document.hidden);
}

/**
 * Explains the method by frames of its own. `quality`, `isIdle` and `isQuiet` return the page's quality, whether the show is paused, and
 * whether probing has ended.
 */
export function explain({ about, frames, quality, isIdle, isQuiet }) {
  const pictures = [...document.querySelectorAll("#steps canvas")];
  const order = (change) => ({ scene: { kind: "model", time: TIME }, isReference: false, seed: 0, ...change });
  const front = [];
  let isAsked = true;
  let isOver = false;

  async function drawSteps() {
    for (const canvas of pictures) {
      const method = canvas.dataset.method?.split(" ").map(Number);
      const frame = await frames.draw(order({ method, quality: quality(), ...STEP }));
      Object.assign(canvas, STEP);
      canvas.getContext("2d").putImageData(new ImageData(bytesOf(frame), STEP.width), 0, 0);
    }
  }

  /** Draws the steps when the browser is idle and the quality has changed. */
  async function follow() {
    await idle(isIdle);
    if (!isAsked) return;
    isAsked = false;
    await drawSteps();
  }

  /** Waits until the workers are idle. */
  async function rest() {
    do await follow();
    while (isAsked || !isIdle() || !isQuiet());
  }

  /** Draws a frame when the workers are idle. */
  async function draw(change) {
    await rest();
    return frames.draw(order({ ...change, ...MEASURED }));
  }

  /** Adds a take of a frame's time in milliseconds, the mean of the number of frames that the clock requires. */
  async function take(timing) {
    await rest();
    const start = now();
    let spent = 0;
    let count = 0;
    for (; !isMeasurable(spent); count++) {
      if (count === MOST) throw new Error("the browser's clock is too coarse");
      await frames.draw(order({ ...timing.change, ...MEASURED }));
      spent = now() - start;
    }
    // The show did not start meanwhile.
    if (!isIdle()) return;
    timing.takes = [...timing.takes, spent / count].sort((a, b) => a - b);
    timing.spent += spent;
  }

  /** Measures each quality that fills squares against tracing every pixel, in turns. The first frames, in new code, are not timed. */
  async function measure() {
    const points = [];
    let last;
    for (let quality = 1; quality < about.qualities.length; quality++) {
      const changes = [true, false].map((isReference) => ({ quality, isReference }));
      const [exact, own] = [await draw(changes[0]), await draw(changes[1])].map(bytesOf);
      const [slow, fast] = changes.map((change) => ({ change, takes: [], spent: 0 }));
      // Qualities with the same reference share its time.
      if (!last || squaredError(exact, last.exact) > 0) last = { exact, slow };
      points.push({ place: quality, accuracy: decibels(squaredError(own, exact), MEASURED.width * MEASURED.height), timings: [last.slow, fast] });
    }
    const timings = [...new Set(points.flatMap(({ timings }) => timings))];
    const isSure = ({ takes, spent }) =>
      (takes.length > 1 && spent > LONG) || takes[AGREEING - 1] <= AGREEMENT * takes[0] || takes.length === TAKES;
    for (let open = timings; open.length > 0; open = open.filter((timing) => !isSure(timing))) {
      for (const timing of open) await take(timing);
    }
    for (const point of points) {
      const [slow, fast] = point.timings.map(({ takes }) => takes[0]);
      front.push({ ...point, speed: slow / fast });
    }
    plot(front, about, quality());
    get("front-note").textContent =
      `Just measured, by one worker: the second scene at ${MEASURED.width}x${MEASURED.height}, against every pixel traced with the same edges.`;
  }

  async function run() {
    await measure();
    for (;;) await follow();
  }

  run().catch((error) => {
    isOver = true;
    get("front-note").textContent = `The measurement failed: ${error.why ?? error.message}.`;
  });
  return {
    setQuality(place) {
      isAsked = true;
      mark(front, about, place);
    },
    front: () => front,
    /** Whether steps or measurements remain to be drawn. */
    isBusy: () => !isOver && (isAsked || front.length === 0),
  };
}

const get = (id) => document.getElementById(id);

/** Returns the ticks of an axis around finite numbers, at multiples of a power of two times `step`. */
function ticks(numbers, step) {
  const [least, most] = [Math.min(...numbers), Math.max(...numbers)];
  const wide = step * 2 ** Math.max(Math.ceil(Math.log2((most - least) / step / TICKS)), 0);
  const first = Math.floor(least / wide);
  return Array.from({ length: Math.max(Math.ceil(most / wide) - first, 1) + 1 }, (_, i) => (first + i) * wide);
}

/** Returns the axes' ticks, and the functions that place a point. An infinite accuracy, without error, is at the upper edge. */
function layout(front) {
  const { left, right, top, bottom } = PLOT;
  const speeds = ticks([1, ...front.map(({ speed }) => speed)], 1);
  const accuracies = ticks([50, ...front.map(({ accuracy }) => accuracy).filter(Number.isFinite)], 5);
  const share = (value, values) => Math.min((value - values[0]) / (values.at(-1) - values[0]), 1);
  const x = (speed) => left + (right - left) * share(speed, speeds);
  const y = (accuracy) => bottom - (bottom - top) * share(accuracy, accuracies);
  return { speeds, accuracies, x, y };
}

/** Plots the front, and marks the current quality. */
function plot(front, about, present) {
  const { left, right, top, bottom } = PLOT;
  const { speeds, accuracies, x, y } = layout(front);
  const parts = [];
  for (const speed of speeds) {
    parts.push(`<line x1="${x(speed)}" x2="${x(speed)}" y1="${top}" y2="${bottom}"/>`);
    parts.push(`<text x="${x(speed)}" y="${bottom + 15}" text-anchor="middle">${speed}</text>`);
  }
  for (const accuracy of accuracies) {
    parts.push(`<line x1="${left}" x2="${right}" y1="${y(accuracy)}" y2="${y(accuracy)}"/>`);
    parts.push(`<text x="${left - 5}" y="${y(accuracy) + 4}" text-anchor="end">${accuracy}</text>`);
  }
  parts.push(`<text x="${(left + right) / 2}" y="${bottom + 33}" text-anchor="middle">times as fast as every pixel</text>`);
  parts.push(`<text transform="translate(10 ${(top + bottom) / 2}) rotate(-90)" text-anchor="middle">dB to every pixel traced</text>`);
  parts.push(`<polyline points="${front.map(({ speed, accuracy }) => `${x(speed)},${y(accuracy)}`).join(" ")}"/>`);
  for (const { speed, accuracy } of front) parts.push(`<circle r="3" cx="${x(speed)}" cy="${y(accuracy)}"/>`);
  get("front-axes").innerHTML = parts.join("");
  mark(front, about, present);
}

/** Moves the mark to a quality. Tracing every pixel has no error, and is at the plot's upper edge. */
function mark(front, about, place) {
  if (front.length + 1 < about.qualities.length) return;
  const { x, y } = layout(front);
  const { speed, accuracy } = front.find((point) => point.place === place) ?? { speed: 1, accuracy: Infinity };
  const isRight = x(speed) > (PLOT.left + PLOT.right) / 2;
  const mark = get("present");
  mark.removeAttribute("hidden");
  mark.style.transform = `translate(${x(speed)}px, ${y(accuracy)}px)`;
  const name = mark.querySelector("text");
  name.textContent = about.qualities[place] + (place === 0 ? ", without error" : "");
  name.setAttribute("x", isRight ? -8 : 8);
  // Above the front, within the plot.
  name.setAttribute("y", place === 0 ? 16 : -8);
  name.setAttribute("text-anchor", isRight ? "end" : "start");
}
