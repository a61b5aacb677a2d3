// The time of the show: that of the sound that is heard, or where there is none, of the computer's clock.

/** Milliseconds in which a device has to begin. */
const PATIENCE = 2000;

export class Clock {
  /** `code` are the module's bytes, for the thread of the sound; `rate` is its samples a second. */
  constructor(code, rate) {
    this.code = code;
    this.rate = rate;
    this.isPlaying = false;
    /** The show's time at a time of the source, both in seconds. While `isMoving` the sound is on its way there. */
    this.from = { show: 0, source: 0 };
    this.isMoving = false;
    this.hasSound = false;
  }

  /** Opens the sound: only after a click or a key, as browsers have it. Fails where there is none. */
  async open() {
    const context = new AudioContext({ sampleRate: this.rate, latencyHint: "playback" });
    await context.audioWorklet.addModule(new URL("sound.js", import.meta.url));
    const node = new AudioWorkletNode(context, "eightfold", {
      numberOfInputs: 0,
      outputChannelCount: [2],
      processorOptions: { code: this.code },
    });
    node.port.onmessage = ({ data }) => {
      this.from = { show: data.position / this.rate, source: data.context };
      this.isMoving = false;
    };
    this.volume = context.createGain();
    node.connect(this.volume).connect(context.destination);
    Object.assign(this, { context, node, hasSound: true });
    this.seek(this.time());
  }

  /** The time of the source: of what is heard by now. */
  source() {
    if (!this.hasSound) return performance.now() / 1000;
    const { contextTime, performanceTime } = this.context.getOutputTimestamp();
    return contextTime > 0 ? contextTime + (performance.now() - performanceTime) / 1000 : this.context.currentTime;
  }

  /** The show's time, in seconds. */
  time() {
    const isStill = this.isMoving || !this.isPlaying;
    return isStill ? this.from.show : Math.max(this.from.show, this.from.show + this.source() - this.from.source);
  }

  /** Goes on. Where the browser has no device for sound, which it does not say, it goes on without any. */
  async play() {
    if (this.hasSound) {
      const { context } = this;
      const start = context.currentTime;
      context.resume();
      for (let waited = 0; context.currentTime === start && waited < PATIENCE; waited += 20) {
        await new Promise((resolve) => setTimeout(resolve, 20));
      }
      this.hasSound = context.currentTime > start;
    }
    this.isPlaying = true;
    this.seek(this.from.show);
  }

  pause() {
    this.from.show = this.time();
    this.isPlaying = false;
    this.context?.suspend();
  }

  /** Goes to a time of the show. */
  seek(show) {
    this.from = { show, source: this.source() };
    this.isMoving = this.hasSound;
    if (this.hasSound) this.node.port.postMessage(Math.round(show * this.rate));
  }

  /** Has the sound be heard, or not. */
  set isMuted(isMuted) {
    if (this.volume) this.volume.gain.value = isMuted ? 0 : 1;
  }
}
