// The figures of the frames that are shown.

import { Mean, now } from "./times.js";

/** Probes of each frame of a resting picture. They end when the half width of the interval, in dB, is below the margin. */
export const PROBES = 8192;
const MARGIN = 0.3;

/** The half width, in dB, below which an accuracy is shown, and below which older probes lose weight. */
const SHOWN = 2;
const SURE = 1.5;

/** The least milliseconds of a frame time's mean. */
const TIMED = 100;

/** The maximum number of frames in a rate: a clock that stands still has no second. */
const MOST = 1000;

export class Figures {
  /** When frames of the last second were shown, and one before it. */
  shown = [];

  /** The time from a frame's start until it was shown, of the latest frames. */
  busy = new Mean();

  /** The sums of the probes of frames with the same key. */
  probes = { key: "", probed: 0, squares: 0, fourths: 0 };

  /** The times of frames with the same key, and of their references. */
  timed = { key: "", frame: new Mean(TIMED), reference: new Mean(TIMED) };

  /** `calls` are the module's; `pixels` returns the pixels of a resting picture, or infinity. */
  constructor(calls, pixels) {
    Object.assign(this, { calls, pixels });
  }

  /** Records when a frame is shown. */
  show() {
    const { shown } = this;
    shown.push(now());
    while (shown.at(-1) - shown[1] >= 1000 && shown.length > 2) shown.shift();
    if (shown.length > MOST) shown.shift();
  }

  /** Returns the frames a second, once a second has passed. */
  get rate() {
    const { shown } = this;
    const span = shown.at(-1) - shown[0];
    return span >= 1000 ? Math.round((1000 * (shown.length - 1)) / span) : "–";
  }

  /** Adds a frame's times, unless it is the first of a picture or of a worker. A new key resets the means. */
  time(key, { milliseconds, reference, isCold }) {
    if (key !== this.timed.key) {
      this.timed = { key, frame: new Mean(TIMED), reference: new Mean(TIMED) };
    } else if (!isCold) {
      this.timed.frame.add(milliseconds);
      if (reference) this.timed.reference.add(reference.milliseconds);
    }
  }

  get milliseconds() {
    const { value } = this.timed.frame;
    return value > 0 ? value.toFixed(1) : "–";
  }

  /** Returns how many times as fast as its reference a frame is, or nothing. */
  get gain() {
    const gain = this.timed.reference.value / this.timed.frame.value;
    return gain > 0 ? `, ${gain.toFixed(1)} times as fast` : "";
  }

  /** Adds a frame's probes. A new key resets the sums. */
  probe(key, { order, probed, squares, fourths }) {
    if (key !== this.probes.key) this.probes = { key, probed: 0, squares: 0, fourths: 0 };
    this.probes.probed += probed;
    this.probes.squares += squares;
    this.probes.fourths += fourths;
    // Some overlays have no probes, and an exhaustive frame has no error.
    this.probes.isFinal = probed === 0 || order.quality === 0;
  }

  /** Gives older probes less weight, if they are enough. */
  age() {
    if (!(this.figure("margin") < SURE)) return;
    for (const sum of ["probed", "squares", "fourths"]) this.probes[sum] /= 1.2;
  }

  /** Returns a figure of the probes from the module: `psnr`, or `margin`, the half width of its interval, in dB. */
  figure(name) {
    const { probed, squares, fourths } = this.probes;
    return this.calls[name](probed, squares, fourths, this.pixels());
  }

  /** Returns the accuracy; a dash if its interval is too wide. */
  get accuracy() {
    const { probed, squares, isFinal } = this.probes;
    if (squares > 0 && this.figure("margin") < SHOWN) return `${this.figure("psnr").toFixed(1)} ± ${this.figure("margin").toFixed(1)} dB`;
    return squares === 0 && (probed >= PROBES || (isFinal && probed > 0)) ? "no error found" : "–";
  }

  /** Whether further times of a resting picture are of no use. */
  get isTimed() {
    const { isFinal, frame, reference } = this.timed;
    return isFinal || (frame.isFinal && (reference.times.length === 0 || reference.isFinal));
  }

  /** Whether all figures of a resting picture are shown. */
  get isKnown() {
    return this.isTimed && (this.probes.isFinal || this.accuracy !== "–");
  }

  /** Whether a resting picture is timed and has enough probes, at most one for each pixel. */
  get isSettled() {
    const { probed, squares, isFinal } = this.probes;
    return this.isTimed && (isFinal || probed >= this.pixels() || (squares > 0 && this.figure("margin") < MARGIN));
  }

  /** Ends times and probes: no frame can be drawn. */
  end() {
    this.probes.isFinal = this.timed.isFinal = true;
  }
}
