// Frames, drawn by several workers. Each has rows of its own; the rows beside them, which smoothing takes, it gets from its neighbours.

/** Rows of a band, the least that a worker is given. */
export const BAND = 32;

export class Frames {
  /** Milliseconds after which a worker that has not answered is taken for dead. */
  patience = 20_000;

  /** Starts workers with a compiled module. `complain` is told in a sentence when one of them dies. */
  constructor(compiled, count, complain) {
    this.compiled = compiled;
    this.complain = complain;
    this.number = 0;
    /** For each kind of frame, the milliseconds that each band is expected to take. */
    this.costs = new Map();
    /** The frame that is drawn at last. */
    this.last = Promise.resolve();
    this.workers = Array.from({ length: count }, () => this.start());
  }

  open() {
    try {
      return new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    } catch ({ message }) {
      throw new Error(`the browser starts no workers here: ${message}`);
    }
  }

  start() {
    const worker = this.open();
    // One whose script is missing fails before it is asked, and without a message.
    worker.onerror = (event) => {
      event.preventDefault();
      const frame = self.origin === "null" ? " in a sandboxed frame" : "";
      worker.why = event.message ?? `worker.js can't be loaded${frame}`;
      worker.fail?.();
    };
    worker.postMessage({ compiled: this.compiled, file: this.file });
    return worker;
  }

  /** Has frames of a scene file drawn, which has been found to have no mistake. */
  setFile(file) {
    this.file = file;
    this.workers.forEach((worker) => worker.postMessage({ file }));
  }

  /** Has a worker draw its part of a pass. Fails when it dies. */
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
   * Draws a frame, once those before are drawn: its parts, each with the first of its rows and their bytes, its figures, and the
   * milliseconds that it took. Where a worker dies another one is started, and the frame is drawn again.
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
        this.complain(`A worker died (${dead.why}). Another one has taken its place.`);
      }
    }
  }

  async attempt(order) {
    const start = performance.now();
    const number = ++this.number;
    const costs = this.costsOf(order);
    const cuts = divide(costs, this.workers.length).map((band) => Math.min(band * BAND, order.height));
    const sum = { points: 0, rays: 0, probed: 0, squares: 0, fourths: 0 };
    let shares = this.workers.map(() => ({ rows: [] }));
    for (let pass = 0, passes = 1; pass < passes; pass++) {
      const before = sum.points;
      const messages = this.workers.map((worker, i) =>
        this.ask(worker, {
          number, pass, before, order, seed: order.seed ?? number, probes: order.probes,
          from: cuts[i], to: cuts[i + 1], rows: shares[i].rows,
        }));
      const done = await Promise.all(messages);
      shares = done.map((own, i) => ({ ...own, rows: [], milliseconds: own.milliseconds + (shares[i].milliseconds ?? 0) }));
      for (const share of shares) for (const name in sum) sum[name] += share[name];
      passes = shares[0].passes;
      exchange(shares.filter((share) => share.edges));
    }
    learn(costs, shares);
    return { ...sum, order, parts: shares.filter((share) => share.bytes), milliseconds: performance.now() - start };
  }

  costsOf({ scene, quality, isReference, width, height }) {
    const kind = `${scene.kind} ${quality} ${isReference} ${width}x${height}`;
    if (!this.costs.has(kind)) this.costs.set(kind, new Float64Array(Math.ceil(height / BAND)).fill(1));
    return this.costs.get(kind);
  }
}

/** Gives workers whose rows follow each other the row above their own, and the one below. */
function exchange(shares) {
  shares.slice(1).forEach((below, i) => {
    const above = shares[i];
    above.rows.push([below.first, below.edges[0]]);
    below.rows.push([above.end - 1, above.edges[1]]);
  });
}

/** Where bands are cut into so many parts that are expected to take as long as each other: the first band of each, and the end. */
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

/** Takes in how long workers took for their bands: the mean of the last frames, each of which counts half as much as the next one. */
function learn(costs, shares) {
  for (const { first, end, milliseconds } of shares) {
    const bands = (end - first) / BAND;
    for (let band = Math.floor(first / BAND); band < Math.ceil(end / BAND); band++) {
      costs[band] = (costs[band] + milliseconds / bands) / 2;
    }
  }
}

/** A frame as one array of bytes. */
export function bytesOf({ order, parts }) {
  const bytes = new Uint8ClampedArray(order.width * order.height * 4);
  for (const part of parts) bytes.set(part.bytes, part.first * order.width * 4);
  return bytes;
}

/** The peak signal-to-noise ratio in dB, by a sum of squared errors of so many pixels with three channels. */
export const decibels = (squares, pixels) => 10 * Math.log10((255 * 255 * 3 * pixels) / squares);

/** The squared errors of all channels between two frames. */
export function squaredError(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += (a[i] - b[i]) ** 2;
  return sum;
}
