// Explains the method: a picture of each step, and a plot of the cost of speed, both made in this browser.

import { bytesOf, decibels, squaredError } from "./frames.js";

/** The time in the model scene, in seconds, and the pictures' sizes. */
const TIME = 2;
const STEP = { width: 224, height: 168 };
const MEASURED = { width: 640, height: 360 };

/** The number of timings of each quality; the minimum counts, as other programs disturb it least. */
const TAKES = 9;

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

  /** Draws a frame when the workers are idle. */
  async function draw(change) {
    await idle(() => isIdle() && isQuiet());
    const frame = await frames.draw(order({ ...change, ...MEASURED }));
    return { milliseconds: frame.milliseconds, bytes: bytesOf(frame) };
  }

  /** Measures each quality that fills squares against tracing every pixel, in turns. */
  async function measure() {
    const points = about.qualities.slice(1).map((_, i) => ({ place: i + 1, slow: Infinity, fast: Infinity }));
    for (let take = 0; take < TAKES; take++) {
      for (const point of points) {
        const reference = await draw({ quality: point.place, isReference: true });
        const frame = await draw({ quality: point.place });
        point.slow = Math.min(point.slow, reference.milliseconds);
        point.fast = Math.min(point.fast, frame.milliseconds);
        point.speed = point.slow / point.fast;
        point.accuracy = decibels(squaredError(frame.bytes, reference.bytes), MEASURED.width * MEASURED.height);
        plot(points.filter(({ speed }) => speed), about, quality());
      }
    }
    front.push(...points);
    mark(front, about, quality());
    get("front-note").textContent =
      `Just measured, by one worker: the second scene at ${MEASURED.width}x${MEASURED.height}, against every pixel traced with the same edges.`;
  }

  /** Draws the steps when the quality has changed, as soon as there is time. */
  async function run() {
    for (;;) {
      await idle(isIdle);
      if (isAsked) {
        isAsked = false;
        await drawSteps();
      } else if (front.length === 0) {
        await measure();
      }
    }
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

/** Returns the range of numbers, rounded outwards to multiples of `step`. */
const range = (numbers, step) => [Math.floor(Math.min(...numbers) / step) * step, Math.ceil(Math.max(...numbers) / step) * step];

/** Returns the ranges of the axes, and the functions that place a point. */
function layout(front) {
  const { left, right, top, bottom } = PLOT;
  const speeds = range([1, ...front.map(({ speed }) => speed)], 1);
  const accuracies = range(front.map(({ accuracy }) => accuracy), 5);
  const x = (speed) => left + ((right - left) * (speed - speeds[0])) / (speeds[1] - speeds[0]);
  const y = (accuracy) => bottom - ((bottom - top) * (accuracy - accuracies[0])) / (accuracies[1] - accuracies[0]);
  return { speeds, accuracies, x, y };
}

/** Plots the front, and marks the current quality. */
function plot(front, about, present) {
  const { left, right, top, bottom } = PLOT;
  const { speeds, accuracies, x, y } = layout(front);
  const parts = [];
  for (let speed = speeds[0]; speed <= speeds[1]; speed++) {
    parts.push(`<line x1="${x(speed)}" x2="${x(speed)}" y1="${top}" y2="${bottom}"/>`);
    parts.push(`<text x="${x(speed)}" y="${bottom + 15}" text-anchor="middle">${speed}</text>`);
  }
  for (let accuracy = accuracies[0]; accuracy <= accuracies[1]; accuracy += 5) {
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
  const { accuracies, x, y } = layout(front);
  const { speed, accuracy } = front.find((point) => point.place === place) ?? { speed: 1, accuracy: accuracies[1] };
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
