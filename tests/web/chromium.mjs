// Headless Chromium, through the DevTools protocol over a pipe.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { Driver } from "./driver.mjs";

/** Starts a browser with additional options. */
export class Browser {
  constructor(more = []) {
    this.folder = mkdtempSync(join(tmpdir(), "eightfold-web-"));
    const options = ["--headless=new", "--no-sandbox", "--remote-debugging-pipe", "--disable-gpu", "--no-first-run", "--disable-features=BackForwardCache", `--user-data-dir=${this.folder}`, ...more, "about:blank"];
    this.process = spawn("chromium", options, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.replies = new Map();
    this.listeners = [];
    let text = "";
    this.process.stdio[4].on("data", (data) => {
      const messages = (text + data).split("\0");
      text = messages.pop();
      messages.forEach((message) => this.take(JSON.parse(message)));
    });
  }

  take(message) {
    const reply = this.replies.get(message.id);
    if (!reply) return this.listeners.forEach((listener) => listener(message));
    this.replies.delete(message.id);
    message.error ? reply.reject(new Error(message.error.message)) : reply.resolve(message.result);
  }

  /** Sends a command to a page's session, or to the browser. */
  send(method, params = {}, sessionId = undefined) {
    const id = (this.last ?? 0) + 1;
    this.last = id;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + "\0");
    return new Promise((resolve, reject) => this.replies.set(id, { resolve, reject }));
  }

  async open(address, width = 1440, height = 900) {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const page = new Page(this, sessionId);
    for (const domain of ["Page", "Runtime", "Log"]) await page.send(`${domain}.enable`);
    await page.send("Target.setAutoAttach", { autoAttach: true, waitForDebuggerOnStart: false, flatten: true });
    await page.resize(width, height);
    await page.go(address);
    return page;
  }

  static page(address) {
    return new Browser().open(address);
  }

  async end() {
    const ended = new Promise((resolve) => this.process.once("exit", resolve));
    this.process.kill();
    await ended;
    // Chromium's child processes write into the folder until they end.
    for (let turn = 0; turn < 100; turn++) {
      try {
        return rmSync(this.folder, { recursive: true, force: true });
      } catch {
        await new Promise((resolve) => setTimeout(resolve, 100));
      }
    }
  }
}

class Page extends Driver {
  constructor(browser, session) {
    super();
    Object.assign(this, { browser, session, messages: [], workers: [] });
    browser.listeners.push(({ method, params, sessionId }) => {
      if (method === "Target.attachedToTarget" && sessionId === session) this.workers.push(params.sessionId);
      if (sessionId !== session) return;
      if (method === "Runtime.consoleAPICalled") this.messages.push(params.args.map(({ value, description }) => value ?? description).join(" "));
      if (method === "Runtime.exceptionThrown") this.messages.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
      if (method === "Log.entryAdded") this.messages.push(`${params.entry.text} ${params.entry.url ?? ""}`);
    });
  }

  send(method, params, session = this.session) {
    return this.browser.send(method, params, session);
  }

  resize(width, height, scale = 1) {
    return this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: scale, mobile: width < 500 });
  }

  /** Loads an address, and waits for the page or another condition. */
  async go(address, condition = "globalThis.eightfold?.view") {
    await this.send("Page.navigate", { url: "about:blank" });
    await this.send("Page.navigate", { url: address });
    await this.until(condition);
  }

  /** Evaluates an expression or a promise in the page or in a worker. */
  async value(expression, session) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true }, session);
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  end() {
    return this.browser.end();
  }

  async click(selector) {
    const [x, y] = await this.value(`(() => { const element = document.querySelector(${JSON.stringify(selector)}); element.scrollIntoView({ block: "nearest" }); const box = element.getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; })()`);
    for (const type of ["mousePressed", "mouseReleased"]) await this.mouse(type, x, y);
  }

  /** Sends mousePressed, mouseReleased, or mouseMoved with the button up or down. */
  mouse(type, x, y, isDown = type !== "mouseMoved") {
    return this.send("Input.dispatchMouseEvent", { type, x, y, button: isDown ? "left" : "none", buttons: isDown ? 1 : 0, clickCount: type === "mouseMoved" ? 0 : 1 });
  }

  /** Presses a key, repeats it `repeats` times, and releases it. */
  async key(key, code = key, hasShift = false, repeats = 0) {
    const text = key === "Enter" ? "\r" : key.length === 1 ? key : undefined;
    const event = { key, code, text, modifiers: hasShift ? 8 : 0 };
    for (let press = 0; press <= repeats; press++) {
      await this.send("Input.dispatchKeyEvent", { type: "keyDown", ...event, autoRepeat: press > 0 });
    }
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", ...event });
  }

  /** Returns a PNG screenshot of the viewport or the whole page. */
  async screenshot(isWhole = false) {
    const { cssContentSize } = await this.send("Page.getLayoutMetrics");
    const clip = isWhole ? { x: 0, y: 0, width: cssContentSize.width, height: cssContentSize.height, scale: 1 } : undefined;
    const { data } = await this.send("Page.captureScreenshot", { format: "png", captureBeyondViewport: isWhole, clip });
    return Buffer.from(data, "base64");
  }
}
