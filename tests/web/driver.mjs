// What the drivers of browsers share, and a server of files for them.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm" };

export const sleep = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** A port that nobody listens on. */
export async function freePort() {
  const server = createServer();
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const { port } = server.address();
  await new Promise((resolve) => server.close(resolve));
  return port;
}

/**
 * Serves a folder, with more headers. `change` may return another status, more headers or other bytes for a path. Returns its address,
 * and how to end it.
 */
export async function serve(folder, headers = {}, change = () => ({})) {
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url, "http://localhost").pathname);
    try {
      const file = join(folder, path.endsWith("/") ? path + "index.html" : path);
      const own = readFileSync(file);
      const { status = 200, bytes = own, more = {} } = change(path, own) ?? {};
      response.writeHead(status, { "content-type": TYPES[extname(file)] ?? "text/plain", ...headers, ...more }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, end: () => server.close() };
}

/** Runs tests whose names contain a word, and prints a line for each. Returns the exit code. */
export async function run(tests, word, by = "") {
  let code = 0;
  for (const [name, test] of Object.entries(tests).filter(([name]) => name.includes(word))) {
    const start = Date.now();
    try {
      await test();
      console.log(`ok      ${name}${by} (${((Date.now() - start) / 1000).toFixed(1)} s)`);
    } catch (error) {
      code = 1;
      console.log(`FAILED  ${name}${by}\n${error.stack}`);
    }
  }
  return code;
}

/** A browser's page, which has `value(expression)`. */
export class Driver {
  /** Waits until an expression is true. */
  async until(expression) {
    for (let turn = 0; turn < 600; turn++) {
      if (await this.value(expression)) return;
      await sleep(100);
    }
    throw new Error(`not within a minute: ${expression}`);
  }

  textOf(id) {
    return this.value(`document.getElementById("${id}").textContent`);
  }

  /** Sets a field as if somebody had. */
  input(id, value) {
    return this.value(`(() => { const input = document.getElementById("${id}"); input.value = ${JSON.stringify(value)}; input.dispatchEvent(new Event("input", { bubbles: true })); })()`);
  }

  /** A frame of the page's, as bytes of red, green and blue, by an expression for what draws it. */
  async frame(order, frames = "eightfold.frames") {
    return Buffer.from(await this.value(`(async () => {
      const { bytesOf } = await import(new URL("frames.js", location));
      const bytes = bytesOf(await ${frames}.draw(${JSON.stringify(order)})).filter((_, i) => i % 4 < 3);
      let letters = "";
      bytes.forEach((byte) => (letters += String.fromCharCode(byte)));
      return btoa(letters);
    })()`), "base64");
  }
}

/** One by WebDriver's commands: `navigate(url)`, and `script(text)` for an asynchronous script. */
export class WebDriver extends Driver {
  /** Loads an address, until the page is at work, or something else is so. */
  async go(address, condition = "globalThis.eightfold?.view") {
    await this.navigate("about:blank");
    await this.navigate(address);
    await this.until(`!!(${condition})`);
  }

  /** The value of an expression, which may be a promise. */
  async value(expression) {
    const value = await this.script(`
      const done = arguments[arguments.length - 1];
      Promise.resolve().then(() => window.eval(${JSON.stringify(expression)})).then(done, (error) => done({ failed: String(error) }));`);
    if (value?.failed) throw new Error(value.failed);
    return value;
  }
}
