// WebKitGTK, Safari's engine, in a window on an X server, through WebDriver.

import { spawn } from "node:child_process";
import { WebDriver, freePort, sleep } from "./driver.mjs";

const BROWSER = "/usr/lib/x86_64-linux-gnu/webkit2gtk-4.1/MiniBrowser";

export class WebKit extends WebDriver {
  static async start() {
    const webkit = new WebKit();
    webkit.port = await freePort();
    // Avoids OpenGL in software, where WebKit rarely aborts.
    const env = { ...process.env, WEBKIT_SKIA_ENABLE_CPU_RENDERING: "1" };
    webkit.process = spawn("WebKitWebDriver", [`--port=${webkit.port}`], { stdio: "ignore", env, detached: true });
    const options = { "webkitgtk:browserOptions": { binary: BROWSER, args: ["--automation"] } };
    for (let turn = 0; turn < 300 && !webkit.session; turn++) {
      const answer = await webkit.send("POST", "/session", { capabilities: { alwaysMatch: options } }).catch(({ cause }) => {
        if (!cause) throw new Error("WebKitGTK does not start");
      });
      webkit.session = answer && `/session/${answer.sessionId}`;
      if (!answer) await sleep(100);
    }
    return webkit;
  }

  /** Sends a command; rejects after some seconds without an answer. */
  async send(method, path, body, seconds = 30) {
    const signal = AbortSignal.timeout(seconds * 1000);
    const response = await fetch(`http://127.0.0.1:${this.port}${path}`, { method, body: JSON.stringify(body), signal });
    const { value } = await response.json();
    if (value?.error) throw new Error(`${value.error}: ${value.message}`);
    return value;
  }

  navigate(url) {
    return this.send("POST", `${this.session}/url`, { url });
  }

  script(script) {
    return this.send("POST", `${this.session}/execute/async`, { script, args: [] });
  }

  async click(selector) {
    const element = await this.send("POST", `${this.session}/element`, { using: "css selector", value: selector });
    await this.send("POST", `${this.session}/element/${Object.values(element)[0]}/click`, {});
  }

  async end() {
    await this.send("DELETE", this.session, undefined, 5).catch(() => {});
    // The driver alone would leave a hanging browser behind.
    process.kill(-this.process.pid);
  }
}
