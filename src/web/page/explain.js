// What explains the method: a picture of each of its steps, and a plot of what speed costs, both made in this browser.

import { bytesOf, decibels, squaredError } from "./frames.js";

/** The second of the model scene that is shown, and the pictures' sizes. */
const TIME = 2;
const STEP = { width: 224, height: 168 };
const MEASURED = { width: 640, height: 360 };

/** How often the time of a quality is taken, of which the least counts. */
const TAKES = 5;

/** The plot's frame: left, right, top, bottom. */
const PLOT = { left: 44, right: 466, top: 12, bottom: 232 };

/** Waits until the browser has time, and nothing plays. */
async function idle(isIdle) {
  do await new Promise((resolve) => setTimeout(resolve, 50));
  while (!isIdle() || document.hidden);
}

/** Explains the method by frames of its own. `quality` and `isIdle` tell the page's quality, and whether nothing plays. */
export function explain({ about, frames, quality, isIdle }) {
  const pictures = [...document.querySelectorAll("#steps canvas")];
  const order = (change) => ({ scene: { kind: "model", time: TIME }, isReference: false, seed: 0, ...change });
  let front = [];
  let isAsked = true;

  async function drawSteps() {
    for (const canvas of pictures) {
      const method = canvas.dataset.method?.split(" ").map(Number);
      const frame = await frames.draw(order({ method, quality: quality(), ...STEP }));
      Object.assign(canvas, STEP);
      canvas.getContext("2d").putImageData(new ImageData(bytesOf(frame), STEP.width), 0, 0);
    }
  }

  /** The least time of a frame, and its bytes. */
  async function take(change) {
    let [milliseconds, bytes] = [Infinity];
    for (let i = 0; i < TAKES; i++) {
      await idle(isIdle);
      const frame = await frames.draw(order({ ...change, ...MEASURED }));
      milliseconds = Math.min(milliseconds, frame.milliseconds);
      bytes = bytesOf(frame);
    }
    return { milliseconds, bytes };
  }

  /** Measures each quality that fills squares against what it would be if every pixel were traced. */
  async function measure() {
    for (let place = 1; place < about.qualities.length; place++) {
      const reference = await take({ quality: place, isReference: true });
      const frame = await take({ quality: place });
      const error = squaredError(frame.bytes, reference.bytes);
      front.push({
        place,
        speed: reference.milliseconds / frame.milliseconds,
        accuracy: decibels(error, MEASURED.width * MEASURED.height),
      });
      plot(front, about, quality());
    }
    document.getElementById("front-note").textContent =
      `Measured just now, by one worker: the model scene at ${MEASURED.width}x${MEASURED.height}, against every pixel traced with the same edges.`;
  }

  /** Draws the steps whenever the quality has changed, as soon as there is time. */
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

  run();
  return {
    setQuality(place) {
      isAsked = true;
      plot(front, about, place);
    },
    front: () => front,
  };
}

/** Plots the front, with the present quality marked. */
function plot(front, about, present) {
  if (front.length < 2) return;
  const { left, right, top, bottom } = PLOT;
  const range = (name, step) => {
    const all = front.map((point) => point[name]);
    return [Math.floor(Math.min(...all) / step) * step, Math.ceil(Math.max(...all) / step) * step];
  };
  const [slow, fast] = range("speed", 1);
  const [coarse, fine] = range("accuracy", 5);
  const x = (speed) => left + ((right - left) * (speed - slow)) / (fast - slow);
  const y = (accuracy) => bottom - ((bottom - top) * (accuracy - coarse)) / (fine - coarse);
  const parts = [];
  for (let speed = slow; speed <= fast; speed++) {
    parts.push(`<line x1="${x(speed)}" x2="${x(speed)}" y1="${top}" y2="${bottom}"/>`);
    parts.push(`<text x="${x(speed)}" y="${bottom + 16}" text-anchor="middle">${speed}</text>`);
  }
  for (let accuracy = coarse; accuracy <= fine; accuracy += 5) {
    parts.push(`<line x1="${left}" x2="${right}" y1="${y(accuracy)}" y2="${y(accuracy)}"/>`);
    parts.push(`<text x="${left - 6}" y="${y(accuracy) + 4}" text-anchor="end">${accuracy}</text>`);
  }
  parts.push(`<text x="${(left + right) / 2}" y="${bottom + 33}" text-anchor="middle">times as fast as every pixel</text>`);
  parts.push(`<text transform="translate(12 ${(top + bottom) / 2}) rotate(-90)" text-anchor="middle">PSNR, dB</text>`);
  parts.push(`<polyline points="${front.map((point) => `${x(point.speed)},${y(point.accuracy)}`).join(" ")}"/>`);
  for (const point of front) parts.push(`<circle r="3" cx="${x(point.speed)}" cy="${y(point.accuracy)}"/>`);
  const here = front.find(({ place }) => place === present);
  if (here) {
    const [cx, cy] = [x(here.speed), y(here.accuracy)];
    const anchor = cx > (left + right) / 2 ? "end" : "start";
    parts.push(`<circle class="present" r="6" cx="${cx}" cy="${cy}"/>`);
    parts.push(`<text class="present" x="${cx + (anchor === "end" ? -10 : 10)}" y="${cy + 18}" text-anchor="${anchor}">${about.qualities[present]}</text>`);
  }
  document.getElementById("front").innerHTML = parts.join("");
}
