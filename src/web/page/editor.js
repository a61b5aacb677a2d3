// The editor of a scene file, which the page draws as the viewer types.

const get = (id) => document.getElementById(id);

/** The parts of an error: file, line, column, message. */
const FAULT = /^scene:(\d+):(\d+): ([^]*)$/;

export class Editor {
  /** `module` parses the text; `show` is called if it is valid. */
  constructor(module, show) {
    Object.assign(this, { module, show });
    get("scene-text").addEventListener("input", () => this.take());
    get("mistake").addEventListener("click", () => this.select());
    get("scene-name").addEventListener("change", ({ target }) => this.load(target.value).then((isLoaded) => isLoaded && this.take()));
    this.load(get("scene-name").value);
  }

  get text() {
    return get("scene-text").value;
  }

  /** Whether a mistake is shown over the picture of the last valid scene. */
  get hasMistake() {
    return !get("mistake").hidden;
  }

  set hasMistake(hasMistake) {
    get("mistake").hidden = !hasMistake;
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
    this.line = Number(line ?? 1);
    this.complain(line ? `Line ${line}, column ${column}: ${what}` : message);
    get("scene-text").setAttribute("aria-invalid", message !== "");
    if (message) return;
    this.valid = this.text;
    this.show();
  }

  /** Shows a mistake below the text and over the picture. */
  complain(sentence) {
    get("scene-fault").textContent = get("mistake").textContent = sentence;
    this.hasMistake = sentence !== "";
  }

  /** Selects the line of the mistake. */
  select() {
    const lines = this.text.split("\n");
    const from = lines.slice(0, this.line - 1).join("\n").length + (this.line > 1);
    get("scene-text").focus();
    get("scene-text").setSelectionRange(from, from + (lines[this.line - 1]?.length ?? 0));
    // Browsers do not scroll to a selection.
    get("scene-text").scrollTop = (get("scene-text").scrollHeight * (this.line - 5)) / lines.length;
  }

  /** Returns the text for an address, compressed and in base64url. After a text with a mistake follow a zero and the last valid one. */
  async packed() {
    const texts = this.hasMistake && this.valid ? [this.text, this.valid] : [this.text];
    const joined = texts.map((text) => text.replaceAll("\0", "\ufffd")).join("\0");
    const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(joined));
    const letters = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
    return letters.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  }

  /** Reads the text of an address. */
  async unpack(letters) {
    this.isShared = true;
    try {
      const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
      const texts = new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes)).split("\0");
      for (const text of texts.reverse()) {
        get("scene-text").value = text;
        this.take();
      }
    } catch {
      this.complain("The scene in the address is damaged.");
    }
  }
}

/** Transforms bytes. */
async function through(stream, bytes) {
  const transformed = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(transformed).arrayBuffer());
}
