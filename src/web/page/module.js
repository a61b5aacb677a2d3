// An instance of the module, with texts in its memory.

export class Module {
  /** Instantiates a compiled module. */
  static async of(compiled) {
    const module = new Module();
    module.calls = (await WebAssembly.instantiate(compiled)).exports;
    return module;
  }

  /** A view of memory, invalid once the memory grows. */
  view(Kind, address, count) {
    return new Kind(this.calls.memory.buffer, address, count);
  }

  /** Returns a zero-terminated text. */
  text(address) {
    const bytes = this.view(Uint8Array, address);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  /** Parses a scene file. Returns an error, or an empty text. */
  read(text) {
    const bytes = new TextEncoder().encode(text);
    this.view(Uint8Array, this.calls.room(bytes.length), bytes.length).set(bytes);
    return this.text(this.calls.read_file());
  }

  begin({ scene, method, quality, isReference, width, height }) {
    if (this.width !== width || this.height !== height) {
      Object.assign(this, { width, height, pixels: this.calls.resize(width, height) });
    }
    this.calls[`set_${scene.kind}`](scene.time, scene.isResting);
    if (method) this.calls.set_method(...method);
    if (!this.calls.set_quality(quality, isReference)) throw new Error(`no quality ${quality}`);
  }
}
