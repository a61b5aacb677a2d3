// The editor of a scene file, which the page draws as the viewer types.

const get = (id) => document.getElementById(id);

/** The parts of an error: file, line, column, message. */
const FAULT = /^scene:(\d+):(\d+): ([^]*)$/;

export class Editor {
  /** `module` parses the text; `show` is called if it is valid. */
  constructor(module, show) {
    Object.assign(this, { module, show });
    get("scene-text").addEventListener("input", () => this.take());
    get("scene-name").addEventListener("change", ({ target }) => this.load(target.value).then((isLoaded) => isLoaded && this.take()));
    this.load(get("scene-name").value);
  }

  get text() {
    return get("scene-text").value;
  }

  /** Loads an example. On failure shows the reason and returns false. */
  async load(name) {
    const file = `scenes/${name}.ron`;
    try {
      const response = await fetch(new URL(file, import.meta.url));
      if (!response.ok) throw new Error(`HTTP status is ${response.status}; must be 200`);
      const text = await response.text();
      // Keep a text that came from the address meanwhile.
      if (get("scene-name").value === name && !this.isShared) get("scene-text").value = text;
      return true;
    } catch ({ message }) {
      if (!this.isShared) get("scene-fault").textContent = `${file}: ${message}.`;
      return false;
    } finally {
      this.isShared = false;
    }
  }

  /** Shows the scene, or the error. */
  take() {
    const message = this.module.read(this.text);
    const [, line, column, what] = FAULT.exec(message) ?? [];
    get("scene-fault").textContent = line ? `Line ${line}, column ${column}: ${what}` : message;
    get("scene-text").setAttribute("aria-invalid", message !== "");
    if (!message) this.show();
  }

  /** Returns the text for an address, compressed and in base64url. */
  async packed() {
    const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(this.text));
    const letters = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
    return letters.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  }

  /** Reads the text of an address. */
  async unpack(letters) {
    this.isShared = true;
    try {
      const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
      get("scene-text").value = new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes));
      this.take();
    } catch {
      get("scene-fault").textContent = "The scene in the address is damaged.";
    }
  }
}

/** Transforms bytes. */
async function through(stream, bytes) {
  const transformed = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(transformed).arrayBuffer());
}
