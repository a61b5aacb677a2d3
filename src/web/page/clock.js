// The time of the show: the sound's, or the computer's where there is no sound.

/** Milliseconds in which a device has to begin, or to go on. */
const PATIENCE = 2000;

/** The longest time in seconds from making a sample to hearing it: wireless headphones need a third of it. */
const LATENCY = 1;

/**
 * Whether a browser may be asked for the time that is heard. Firefox 153 on Linux holds a lock while it asks PulseAudio, which may wait for
 * a sample that waits for that lock: then the page hangs for ever.
 */
const CAN_BE_ASKED = !/Linux.*Firefox/.test(navigator.userAgent);

export class Clock {
  /** Is called when the sound stops, goes on, is lost or is there again without this page's doing. */
  onChange = () => {};

  /** `code` are the module's bytes, for the thread of the sound; `rate` is its samples a second. */
  constructor(code, rate) {
    this.code = code;
    this.rate = rate;
    /** Whether somebody wants the show to play, and whether the sound is being started for it. */
    this.isWanted = false;
    this.isStarting = false;
    /** The show's time at a time of the source, both in seconds. */
    this.from = { show: 0, source: 0 };
    /** The show's time while it stands, as it does while the sound `isMoving` there. */
    this.still = 0;
    this.isMoving = false;
    this.hasSound = false;
    /** The latest time of the sound that was heard, in seconds. */
    this.heard = 0;
    /** The context's time, and the millisecond since which it is the same. */
    this.seen = { time: 0, since: 0 };
  }

  /** Whether the time goes on. A browser may stop the sound, for a call or another tab: then the time stops with it. */
  get isPlaying() {
    return this.isWanted && !(this.hasSound && this.context.state !== "running");
  }

  /** Opens the sound, once: only after a click or a key, as browsers have it. Fails where there is none. */
  open() {
    return (this.opening ??= this.begin().catch((error) => {
      this.opening = undefined;
      throw error;
    }));
  }

  async begin() {
    if (!globalThis.isSecureContext) throw new Error("browsers play it on https and localhost only");
    const context = new AudioContext({ sampleRate: this.rate, latencyHint: "playback" });
    await context.audioWorklet.addModule(new URL("sound.js", import.meta.url));
    const node = new AudioWorkletNode(context, "eightfold", {
      numberOfInputs: 0,
      outputChannelCount: [2],
      processorOptions: { code: this.code },
    });
    node.port.onmessage = ({ data }) => {
      // Unless it was sent elsewhere meanwhile.
      if (!this.hasSound || data.position !== this.wanted) return;
      this.from = { show: data.position / this.rate, source: data.context };
      this.isMoving = false;
    };
    this.volume = context.createGain();
    node.connect(this.volume).connect(context.destination);
    context.onstatechange = () => this.follow();
    Object.assign(this, { context, node, hasSound: true });
    this.seek(this.time());
  }

  /** The time of the source: of the sample that is heard now. */
  source() {
    if (!this.hasSound) return performance.now() / 1000;
    const { currentTime, state } = this.context;
    if (state !== "running") return this.heard;
    const { contextTime, performanceTime } = (CAN_BE_ASKED && this.context.getOutputTimestamp?.()) || {};
    const present = performance.now();
    const heard = contextTime + (present - performanceTime) / 1000;
    // WebKit gives times in the future, or in other units, and Chromium an old one after the context was suspended.
    const isTrue = contextTime > 0 && performanceTime < present + 10 && heard > currentTime - LATENCY && heard < currentTime;
    this.heard = Math.max(this.heard, isTrue ? heard : currentTime);
    return this.heard;
  }

  /** The show's time, in seconds. */
  time() {
    if (this.context && this.isWanted && !this.isStarting) this.watch();
    return this.position();
  }

  /** Goes on without a sound that stands still though it runs, and with it once it moves again. */
  watch() {
    const { currentTime, state } = this.context;
    const present = performance.now();
    const hasMoved = currentTime !== this.seen.time;
    if (hasMoved || state !== "running") this.seen = { time: currentTime, since: present };
    const isThere = this.hasSound ? present - this.seen.since < PATIENCE : hasMoved;
    if (isThere === this.hasSound) return;
    const show = this.position();
    this.hasSound = isThere;
    this.seek(show);
    this.onChange();
  }

  position() {
    const isStill = this.isMoving || this.isStarting || !this.isWanted;
    return isStill ? this.still : Math.max(this.from.show, this.from.show + this.source() - this.from.source);
  }

  /** Goes on. Where the browser has no device for sound, which it does not say, it goes on without any. */
  async play() {
    this.still = this.time();
    this.isWanted = this.isStarting = true;
    const hadSound = this.hasSound;
    if (this.context) this.hasSound = await this.resume();
    this.isStarting = false;
    if (!this.isWanted) return this.context?.suspend();
    // A sound that was stopped goes on where it was.
    if (!hadSound || !this.hasSound) this.seek(this.still);
  }

  /** Has the context run. Returns whether it does within some time. */
  async resume() {
    const { context } = this;
    const start = context.currentTime;
    // It fails while something else has the device.
    context.resume().catch(() => {});
    for (let waited = 0; context.currentTime === start && waited < PATIENCE; waited += 20) {
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    this.seen = { time: context.currentTime, since: performance.now() };
    return context.currentTime > start;
  }

  pause() {
    this.still = this.time();
    this.isWanted = false;
    this.context?.suspend();
  }

  /** Keeps to a context that was stopped, or runs, without this page's doing. */
  follow() {
    if (this.isStarting) return;
    if (this.isWanted) this.onChange();
    else if (this.context.state === "running") this.context.suspend();
  }

  /** Goes to a time of the show. */
  seek(show) {
    this.still = show;
    this.from = { show, source: this.source() };
    this.isMoving = this.hasSound;
    this.wanted = Math.round(show * this.rate);
    if (this.hasSound) this.node.port.postMessage(this.wanted);
  }

  /** Has the sound be heard, or not. */
  set isMuted(isMuted) {
    if (this.volume) this.volume.gain.value = isMuted ? 0 : 1;
  }
}
