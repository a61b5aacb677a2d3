// Shared by the drivers of browsers: a file server, the test runner, and WebDriver.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm" };

export const sleep = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

export async function freePort() {
  const server = createServer();
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const { port } = server.address();
  await new Promise((resolve) => server.close(resolve));
  return port;
}

/**
 * Serves a folder with additional headers. `change` can replace the status, add headers or replace the bytes of a path. Returns the
 * address, and a function that ends the server.
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

/**
 * Runs the tests whose names contain a word, and prints a line for each. With `replace`, a failed test runs once more in another
 * browser. Returns the exit code.
 */
export async function run(tests, word, by = "", replace) {
  let [code, count, repeated] = [0, 0, 0];
  for (const [name, test] of Object.entries(tests).filter(([name]) => name.includes(word))) {
    const start = Date.now();
    const attempt = () => test().then(() => null, (error) => error);
    let [error, again] = [await attempt(), ""];
    if (error && replace) {
      console.log(`AGAIN   ${name}${by}: ${error.message}`);
      again = `, only when run again after: ${error.message.split("\n")[0]}`;
      repeated++;
      await replace();
      error = await attempt();
    }
    count++;
    if (error) {
      code = 1;
      console.log(`FAILED  ${name}${by}\n${error.stack}`);
    } else {
      console.log(`ok      ${name}${by} (${((Date.now() - start) / 1000).toFixed(1)} s)${again}`);
    }
  }
  console.log(`${count} tests${by}, ${repeated} of them run again after a failure`);
  return code;
}

/** Returns whether the chosen overlay and scene differ in colour from the others. Runs in a page. */
export const hasMarks = () =>
  [["#overlays :checked + span", "#overlays :not(:checked) + span"], ["#scenes [aria-current=true]", "#scenes [aria-current=false]"]].every((pair) => {
    const [chosen, other] = pair.map((selector) => getComputedStyle(document.querySelector(selector)));
    return ["color", "backgroundColor"].every((name) => chosen[name] !== other[name]);
  });

/** A browser's page, which has `value(expression)`. */
export class Driver {
  /** Waits until an expression is true. */
  async until(expression, seconds = 60) {
    for (let turn = 0; turn < 10 * seconds; turn++) {
      if (await this.value(expression)) return;
      await sleep(100);
    }
    const clock = await this.value("JSON.stringify(globalThis.eightfold?.clock, (key, value) => (key && typeof value === 'object' ? undefined : value))");
    throw new Error(`not within ${seconds} s: ${expression}; the clock is ${clock}`);
  }

  textOf(id) {
    return this.value(`document.getElementById("${id}").textContent`);
  }

  /** Sets a field as a user does. */
  input(id, value) {
    return this.value(`(() => { const input = document.getElementById("${id}"); input.value = ${JSON.stringify(value)}; input.dispatchEvent(new Event("input", { bubbles: true })); })()`);
  }

  /** Returns a frame as RGB bytes. `frames` is an expression for the object that draws it. */
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

/** A page through WebDriver: `navigate(url)`, and `script(text)` for asynchronous scripts. */
export class WebDriver extends Driver {
  /** Loads an address, and waits for the page or another condition. */
  async go(address, condition = "globalThis.eightfold?.view") {
    await this.navigate("about:blank");
    await this.navigate(address);
    await this.until(`!!(${condition})`);
  }

  /** Evaluates an expression or a promise. */
  async value(expression) {
    const value = await this.script(`
      const done = arguments[arguments.length - 1];
      Promise.resolve().then(() => window.eval(${JSON.stringify(expression)})).then(done, (error) => done({ failed: String(error) }));`);
    if (value?.failed) throw new Error(value.failed);
    return value;
  }
}
