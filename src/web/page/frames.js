// Frames, drawn by several workers. Each has its own rows; its neighbours send the adjacent rows that antialiasing needs.

import { isMeasurable, now } from "./times.js";

/** Rows of a band, the minimum share of a worker. */
export const BAND = 32;

/** The first frames of new workers, which take up to four times as long: scripts and modules are still compiled. */
const COLD = 3;

export class Frames {
  /** Milliseconds without an answer after which a worker counts as dead. */
  patience = 20_000;

  /** The number of workers that died. */
  deaths = 0;

  /** Starts workers with a compiled module. `complain` gets a sentence from the second death on. */
  constructor(compiled, count, complain) {
    this.compiled = compiled;
    this.complain = complain;
    this.number = 0;
    /** The expected cost of each band, for each kind of frame. */
    this.costs = new Map();
    /** The last frame. */
    this.last = Promise.resolve();
    this.workers = Array.from({ length: count }, () => this.start());
  }

  open() {
    try {
      return new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    } catch ({ message }) {
      throw new Error(`workers can't be started: ${message}`);
    }
  }

  start() {
    const worker = this.open();
    // A worker whose script is missing fails before its first task, without a message.
    worker.onerror = (event) => {
      event.preventDefault();
      const frame = self.origin === "null" ? " in a sandboxed frame" : "";
      worker.why = event.message ?? `worker.js can't be loaded${frame}`;
      worker.fail?.();
    };
    worker.postMessage({ compiled: this.compiled, file: this.file });
    return worker;
  }

  /** Draws frames of a valid scene file from now on. */
  setFile(file) {
    this.file = file;
    this.workers.forEach((worker) => worker.postMessage({ file }));
  }

  /** Makes a worker draw its part of a pass. Fails if it dies. */
  ask(worker, message) {
    return new Promise((resolve, reject) => {
      worker.fail = () => {
        clearTimeout(limit);
        reject({ worker, why: worker.why ?? "it does not answer" });
      };
      const limit = setTimeout(worker.fail, this.patience);
      worker.onmessage = ({ data }) => {
        if (data.number !== message.number) return;
        clearTimeout(limit);
        resolve(data.done);
      };
      if (worker.why) return worker.fail();
      worker.postMessage(message);
    });
  }

  /**
   * Draws a frame after the previous ones. Returns its parts, each with its first row and bytes, its figures, its milliseconds, and whether
   * they are longer than usual (`isCold`). If a worker dies, another one is started, and the frame is drawn again.
   */
  draw(order) {
    const frame = this.last.then(() => this.attempts(order));
    this.last = frame.catch(() => {});
    return frame;
  }

  async attempts(order) {
    for (let attempt = 0; ; attempt++) {
      try {
        return await this.attempt(order);
      } catch (dead) {
        if (!dead.worker || attempt >= this.workers.length) throw dead;
        dead.worker.terminate();
        this.workers = this.workers.map((worker) => (worker === dead.worker ? this.start() : worker));
        const sentence = `A worker died (${dead.why}). Another one has taken its place.`;
        console.warn(sentence);
        // WebKit rarely reports a memory access out of bounds in valid code; another worker draws the frame.
        if (++this.deaths > 1) this.complain(sentence);
      }
    }
  }

  async attempt(order) {
    const start = now();
    const number = ++this.number;
    const costs = this.costsOf(order);
    const cuts = divide(costs, this.workers.length).map((band) => Math.min(band * BAND, order.height));
    const sum = { points: 0, rays: 0, probed: 0, squares: 0, fourths: 0 };
    let shares = this.workers.map(() => ({ rows: [], spent: 0, cast: 0 }));
    for (let pass = 0, passes = 1; pass < passes; pass++) {
      const before = sum.points;
      const messages = this.workers.map((worker, i) =>
        this.ask(worker, {
          number, pass, before, order, seed: order.seed ?? number, probes: order.probes,
          from: cuts[i], to: cuts[i + 1], rows: shares[i].rows,
        }));
      const done = await Promise.all(messages);
      shares = done.map((own, i) => ({ ...own, rows: [], spent: shares[i].spent + own.milliseconds, cast: shares[i].cast + own.rays }));
      for (const share of shares) for (const name in sum) sum[name] += share[name];
      passes = shares[0].passes;
      exchange(shares.filter((share) => share.edges));
    }
    learn(costs, shares);
    return { ...sum, order, parts: shares.filter((share) => share.bytes), milliseconds: now() - start, isCold: number <= COLD };
  }

  costsOf({ scene, quality, isReference, width, height }) {
    const kind = `${scene.kind} ${quality} ${isReference} ${width}x${height}`;
    if (!this.costs.has(kind)) this.costs.set(kind, new Float64Array(Math.ceil(height / BAND)).fill(1));
    return this.costs.get(kind);
  }
}

/** Sends neighbouring workers each other's adjacent rows. */
function exchange(shares) {
  shares.slice(1).forEach((below, i) => {
    const above = shares[i];
    above.rows.push([below.first, below.edges[0]]);
    below.rows.push([above.end - 1, above.edges[1]]);
  });
}

/** Divides bands into parts of equal expected cost. Returns the first band of each, and the end. */
function divide(costs, count) {
  const total = costs.reduce((sum, cost) => sum + cost, 0);
  const cuts = [0];
  let sum = 0;
  costs.forEach((cost, band) => {
    while (cuts.length < count && sum + cost / 2 >= (total * cuts.length) / count) cuts.push(band);
    sum += cost;
  });
  while (cuts.length <= count) cuts.push(costs.length);
  return cuts;
}

/**
 * Updates the expected costs of bands: a mean of all frames, each weighing half as much as the next. Costs are milliseconds, or rays if
 * the clock is too coarse.
 */
function learn(costs, shares) {
  const drawn = shares.filter(({ first, end }) => first < end);
  const unit = drawn.every(({ spent }) => isMeasurable(spent)) ? "spent" : "cast";
  for (const { first, end, [unit]: cost } of drawn) {
    const bands = (end - first) / BAND;
    for (let band = Math.floor(first / BAND); band < Math.ceil(end / BAND); band++) {
      costs[band] = (costs[band] + cost / bands) / 2;
    }
  }
}

/** Returns a frame as one array of bytes. */
export function bytesOf({ order, parts }) {
  const bytes = new Uint8ClampedArray(order.width * order.height * 4);
  for (const part of parts) bytes.set(part.bytes, part.first * order.width * 4);
  return bytes;
}

/** Returns the peak signal-to-noise ratio in dB, from the sum of squared errors of some pixels with three channels. */
export const decibels = (squares, pixels) => 10 * Math.log10((255 * 255 * 3 * pixels) / squares);

/** Returns the sum of squared errors of all channels between two frames. */
export function squaredError(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += (a[i] - b[i]) ** 2;
  return sum;
}
