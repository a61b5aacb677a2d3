// Headless Firefox, through its Marionette protocol over a socket.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { WebDriver, freePort, sleep } from "./driver.mjs";

export class Firefox extends WebDriver {
  replies = new Map();
  received = Buffer.alloc(0);
  last = 0;

  /** Starts a browser with preferences. */
  static async start(preferences = {}) {
    const firefox = new Firefox();
    const port = await freePort();
    firefox.profile = mkdtempSync(join(tmpdir(), "eightfold-firefox-"));
    const all = Object.entries({ "media.autoplay.default": 0, "marionette.port": port, ...preferences });
    writeFileSync(join(firefox.profile, "user.js"), all.map(([name, value]) => `user_pref("${name}", ${value});\n`).join(""));
    firefox.process = spawn("firefox-esr", ["--headless", "--no-remote", "--marionette", "--profile", firefox.profile], { stdio: "ignore" });
    for (let turn = 0; turn < 300 && !firefox.socket; turn++) {
      const socket = connect(port, "127.0.0.1");
      const isThere = await new Promise((resolve) => socket.once("connect", () => resolve(true)).once("error", () => resolve(false)));
      if (isThere) firefox.socket = socket.on("data", (data) => firefox.take(data));
      else await sleep(100);
    }
    await firefox.send("NewSession");
    return firefox;
  }

  /** A message is the length of its text, a colon, and a JSON list: kind, number, error, result. */
  take(data) {
    this.received = Buffer.concat([this.received, data]);
    for (let colon = this.received.indexOf(":"); colon > 0; colon = this.received.indexOf(":")) {
      const end = colon + 1 + Number(this.received.subarray(0, colon));
      if (this.received.length < end) return;
      const message = JSON.parse(this.received.subarray(colon + 1, end));
      this.received = this.received.subarray(end);
      if (!Array.isArray(message)) continue;
      const [, number, error, result] = message;
      error ? this.replies.get(number).reject(new Error(error.message)) : this.replies.get(number).resolve(result);
    }
  }

  send(command, parameters = {}) {
    const text = JSON.stringify([0, ++this.last, `WebDriver:${command}`, parameters]);
    this.socket.write(`${Buffer.byteLength(text)}:${text}`);
    return new Promise((resolve, reject) => this.replies.set(this.last, { resolve, reject }));
  }

  navigate(url) {
    return this.send("Navigate", { url });
  }

  async script(script) {
    return (await this.send("ExecuteAsyncScript", { script, args: [], sandbox: null })).value;
  }

  async click(selector) {
    const { value } = await this.send("FindElement", { using: "css selector", value: selector });
    await this.send("ElementClick", { id: Object.values(value)[0] });
  }

  async end() {
    this.process.kill();
    await new Promise((resolve) => this.process.once("exit", resolve));
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 9, retryDelay: 100 });
  }
}
