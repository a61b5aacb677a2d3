// The soundtrack, on the browser's audio thread, by the intro's synthesizer.

/** Blocks to synthesize for each requested one while seeking; nothing is heard meanwhile. */
const HURRY = 100;

registerProcessor("eightfold", class extends AudioWorkletProcessor {
  constructor({ processorOptions: { code } }) {
    super();
    this.wasm = new WebAssembly.Instance(new WebAssembly.Module(code)).exports;
    /** The samples made, and the samples to make before any is heard. */
    this.made = 0;
    this.wanted = 0;
    this.isThere = false;
    this.port.onmessage = ({ data }) => this.seek(data);
  }

  seek(position) {
    this.isThere = false;
    this.wanted = position;
    if (position < this.made) {
      this.wasm.restart_sound();
      this.made = 0;
    }
  }

  /** Returns the next samples, left and right alternating. */
  next(count) {
    this.made += count;
    const address = this.wasm.play(count);
    return new Float32Array(this.wasm.memory.buffer, address, 2 * count);
  }

  process(_, [[left, right]]) {
    for (let block = 0; block < HURRY && this.made < this.wanted; block++) {
      this.next(Math.min(left.length, this.wanted - this.made));
    }
    if (this.made < this.wanted) return true;
    if (!this.isThere) {
      this.isThere = true;
      this.port.postMessage({ position: this.made, context: currentTime });
    }
    const samples = this.next(left.length);
    for (let i = 0; i < left.length; i++) {
      left[i] = samples[2 * i];
      right[i] = samples[2 * i + 1];
    }
    return true;
  }
});
