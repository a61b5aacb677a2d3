// The show's time: the sound's, or the computer's without sound.

/** Milliseconds in which a device has to start or resume. */
const PATIENCE = 2000;

/** The maximum latency of sound in seconds: wireless headphones have a third of a second. */
const LATENCY = 1;

/**
 * Whether to ask the browser for the audible time. Firefox 153 on Linux holds a lock while it asks PulseAudio, which may wait for a sample
 * that waits for the same lock: a deadlock.
 */
const CAN_BE_ASKED = !/Linux.*Firefox/.test(navigator.userAgent);

export class Clock {
  /** Called when the sound stops, resumes, is lost or returns without an action of this page. */
  onChange = () => {};

  /** `code` are the module's bytes for the sound thread; `rate` is its sampling rate. */
  constructor(code, rate) {
    this.code = code;
    this.rate = rate;
    /** Whether the viewer wants the show to play, and whether its sound is starting. */
    this.isWanted = false;
    this.isStarting = false;
    /** The show's time at a time of the source, both in seconds. */
    this.from = { show: 0, source: 0 };
    /** The show's time while it is paused, even if the sound `isMoving`. */
    this.still = 0;
    this.isMoving = false;
    this.hasSound = false;
    /** Why there is no sound, after it opened. */
    this.why = "";
    /** The latest time of audible sound, in seconds. */
    this.heard = 0;
    /** The context's time, and when it last changed, in milliseconds. */
    this.last = { time: 0, since: 0 };
  }

  /** Whether time advances. A browser may stop the sound, for a call or another tab: then time stops too. */
  get isPlaying() {
    return this.isWanted && !(this.hasSound && this.context.state !== "running");
  }

  /** Opens the sound once, and again after it was lost. Browsers require a click or a key first. Rejects without a device. */
  open() {
    if (this.context && !this.hasSound) this.close();
    return (this.opening ??= this.begin().catch((error) => {
      this.opening = undefined;
      throw error;
    }));
  }

  async begin() {
    if (!globalThis.isSecureContext) throw new Error("page address must be https or localhost");
    const context = new AudioContext({ sampleRate: this.rate, latencyHint: "playback" });
    await context.audioWorklet.addModule(new URL("sound.js", import.meta.url));
    const volume = context.createGain();
    volume.connect(context.destination);
    context.onstatechange = () => this.follow();
    Object.assign(this, { context, volume, hasSound: true, heard: 0, why: "its device is missing" });
    this.start();
  }

  /** Starts the synthesizer on the audio thread. One that fails is replaced if it has played; otherwise the sound is closed. */
  start() {
    const node = new AudioWorkletNode(this.context, "eightfold", {
      numberOfInputs: 0,
      outputChannelCount: [2],
      processorOptions: { code: this.code },
    });
    let hasPlayed = false;
    node.port.onmessage = ({ data }) => {
      hasPlayed = true;
      // Ignore the answer to an earlier seek.
      if (!this.hasSound || data.position !== this.wanted) return;
      this.from = { show: data.position / this.rate, source: data.context };
      this.isMoving = false;
    };
    node.onprocessorerror = () => {
      node.disconnect();
      if (hasPlayed) return this.start();
      const show = this.position();
      this.close();
      this.why = "its synthesizer failed";
      this.seek(show);
      this.follow();
    };
    node.connect(this.volume);
    this.node = node;
    this.seek(this.time());
  }

  close() {
    this.context.onstatechange = null;
    this.context.close();
    Object.assign(this, { context: undefined, opening: undefined, hasSound: false });
  }

  /** The source's time of the sample that is audible now. */
  source() {
    if (!this.hasSound) return performance.now() / 1000;
    const { currentTime, state } = this.context;
    if (state !== "running") return this.heard;
    const { contextTime, performanceTime } = (CAN_BE_ASKED && this.context.getOutputTimestamp?.()) || {};
    const present = performance.now();
    const heard = contextTime + (present - performanceTime) / 1000;
    // WebKit returns times in the future or in other units, Chromium an old one after the context was suspended.
    const isTrue = contextTime > 0 && performanceTime < present + 10 && heard > currentTime - LATENCY && heard < currentTime;
    this.heard = Math.max(this.heard, isTrue ? heard : currentTime);
    return this.heard;
  }

  /** The show's time, in seconds. */
  time() {
    if (this.context && this.isWanted && !this.isStarting) this.watch();
    return this.position();
  }

  /** Follows the computer's clock while the sound is stuck. */
  watch() {
    const { currentTime, state } = this.context;
    const present = performance.now();
    const hasMoved = currentTime !== this.last.time;
    if (hasMoved || state !== "running") this.last = { time: currentTime, since: present };
    const isThere = this.hasSound ? present - this.last.since < PATIENCE : hasMoved;
    if (isThere === this.hasSound) return;
    const show = this.position();
    this.hasSound = isThere;
    this.why = "its device has stopped";
    this.seek(show);
    this.onChange();
  }

  position() {
    const isStill = this.isMoving || this.isStarting || !this.isWanted;
    return isStill ? this.still : Math.max(this.from.show, this.from.show + this.source() - this.from.source);
  }

  /** Resumes. Browsers do not report a missing device: the show then continues without sound. */
  async play() {
    this.still = this.time();
    this.isWanted = this.isStarting = true;
    const hadSound = this.hasSound;
    if (this.context) this.hasSound = await this.resume();
    this.isStarting = false;
    if (!this.isWanted) return this.context?.suspend();
    // Paused sound resumes at its position.
    if (!hadSound || !this.hasSound) this.seek(this.still);
  }

  /** Resumes the context. Returns whether it runs within some time. */
  async resume() {
    const { context } = this;
    const start = context.currentTime;
    // This fails while another program uses the device.
    context.resume().catch(() => {});
    for (let waited = 0; context === this.context && context.currentTime === start && waited < PATIENCE; waited += 20) {
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    this.last = { time: context.currentTime, since: performance.now() };
    return context === this.context && context.currentTime > start;
  }

  pause() {
    this.still = this.time();
    this.isWanted = false;
    this.context?.suspend();
  }

  /** Follows a context that stops or runs without an action of this page. */
  follow() {
    if (this.isStarting) return;
    if (this.isWanted) this.onChange();
    else if (this.context?.state === "running") this.context.suspend();
  }

  seek(show) {
    this.still = show;
    this.from = { show, source: this.source() };
    this.isMoving = this.hasSound;
    this.wanted = Math.round(show * this.rate);
    if (this.hasSound) this.node.port.postMessage(this.wanted);
  }

  set isMuted(isMuted) {
    if (this.volume) this.volume.gain.value = isMuted ? 0 : 1;
  }
}
