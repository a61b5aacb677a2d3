// Times by the browser's clock, whose step can be 100 ms: some browsers coarsen it against fingerprinting.

/** The steps of the clock in a usable time, whose error is then at most a tenth. */
const STEPS = 10;

/** The maximum number of times in a mean: a clock that needs more is too coarse. */
const MOST = 1000;

let last = performance.now();

/** The smallest difference between two readings, in milliseconds: an upper bound on the clock's step. */
let step = Infinity;

/** Returns the clock's time in milliseconds. */
export function now() {
  const time = performance.now();
  if (time > last) step = Math.min(step, time - last);
  last = time;
  return time;
}

/** Returns whether a time in milliseconds has enough steps of the clock. */
export const isMeasurable = (milliseconds) => milliseconds >= STEPS * step;

/** A mean of the latest times: the fewest that have `least` milliseconds and that the clock can measure. */
export class Mean {
  times = [];
  sum = 0;

  constructor(least = 0) {
    this.least = least;
  }

  isEnough(sum) {
    return sum >= this.least && isMeasurable(sum);
  }

  add(milliseconds) {
    this.times.push(milliseconds);
    this.sum += milliseconds;
    while (this.isEnough(this.sum - this.times[0]) || this.times.length > MOST) this.sum -= this.times.shift();
  }

  /** Whether further times are of no use: it has a value, or the clock is too coarse. */
  get isFinal() {
    return this.value > 0 || this.times.length === MOST;
  }

  /** The mean in milliseconds; NaN for too short a time. */
  get value() {
    return this.isEnough(this.sum) ? this.sum / this.times.length : NaN;
  }
}
