// Tests the page in every engine: node engines.mjs chromium|firefox|webkit SITE INTRO [WORD]. SITE is the folder of the page, INTRO the
// program, and WORD selects tests by name; "silent" selects the tests without a sound device.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";
import { Browser } from "./chromium.mjs";
import { run, serve, sleep } from "./driver.mjs";
import { Firefox } from "./firefox.mjs";
import { WebKit } from "./webkit.mjs";

const [engine, folder, intro, word = ""] = process.argv.slice(2);
const site = await serve(folder);
const start = { chromium: () => Browser.page(site.address), firefox: Firefox.start, webkit: WebKit.start }[engine];
let page = await start();

/**
 * Replaces the browser. WebKitGTK 2.50 rarely hangs or aborts when sound stops or starts, and rarely reports a memory access out of bounds
 * in valid code.
 */
async function replace() {
  await page.end();
  page = await start();
  await page.go(site.address);
}

/** Returns the first seconds of the module's soundtrack in mono. */
async function soundtrack(seconds) {
  const { instance: { exports } } = await WebAssembly.instantiate(gunzipSync(readFileSync(join(folder, "eightfold.bin"))));
  const mixed = new Float32Array(seconds * 48000);
  for (let made = 0; made < mixed.length; made += 128) {
    const sides = new Float32Array(exports.memory.buffer, exports.play(128), 256);
    for (let i = 0; i < 128; i++) mixed[made + i] = (sides[2 * i] + sides[2 * i + 1]) / 2;
  }
  return mixed;
}

/**
 * Measures the picture's lead over the sound in seconds, `times` times. The samples identify the position in the soundtrack; they are
 * heard up to Chromium's latency later. Other latencies are unknown: 0 in WebKit, and asking can hang Firefox.
 */
async function leads(mixed, times) {
  await page.value("(eightfold.clock.node.ear ??= eightfold.clock.node.connect(new AnalyserNode(eightfold.clock.context, { fftSize: 256 })), true)");
  const leads = [];
  for (let turn = 0; turn < times; turn++) {
    await sleep(200);
    const [time, latency, ...heard] = await page.value(`(() => {
      const heard = new Float32Array(256);
      const time = eightfold.clock.time();
      eightfold.clock.node.ear.getFloatTimeDomainData(heard);
      return [time, ${engine === "chromium"} ? eightfold.clock.context.outputLatency : 0, ...heard];
    })()`);
    const isThere = (at) => heard.every((sample, i) => Math.abs(sample - mixed[at - 255 + i]) < 1e-5);
    // Find the position nearest to the guess, since the song repeats parts.
    const guess = Math.round((time + latency) * 48000);
    let away = 0;
    while (away < 480000 && !isThere(guess + away) && !isThere(guess - away)) away++;
    assert.ok(away < 480000, `at ${time} s something else is heard`);
    const made = (isThere(guess + away) ? guess + away : guess - away) / 48000;
    leads.push(Math.min(time + latency - made, 0) + Math.max(time - made, 0));
  }
  return leads;
}

const show = (time, quality, width, height) => ({ scene: { kind: "show", time }, quality, isReference: false, width, height });
const label = "document.getElementById('play').getAttribute('aria-label')";

/** Faults of hosts and browsers, each with the page's message; null if the page plays. */
const faults = {
  "a host whose modules the browser unpacks": [{ change: (path) => path.endsWith(".bin") && { more: { "content-encoding": "gzip" } } }, null],
  "a host without the fast module": [{ change: (path) => path === "/eightfold.bin" && { status: 404 } }, /eightfold\.bin: HTTP status is 404; must be 200/],
  "a host with half of the fast module": [{ change: (path, own) => path === "/eightfold.bin" && { bytes: own.subarray(0, own.length / 2) } }, /eightfold\.bin is cut short or damaged/],
  "a host without modules": [{ change: (path) => path.endsWith(".bin") && { status: 404 } }, /can.t be played: eightfold\.bin: HTTP status is 404; must be 200, and plain\.bin: HTTP/],
  "a host with another page in place of modules": [{ change: (path) => path.endsWith(".bin") && { bytes: "<!DOCTYPE html>" } }, /can.t be played: eightfold\.bin is cut short or damaged/],
  "a host without a script": [{ change: (path) => path === "/clock.js" && { status: 404 } }, /can.t be played: .*(module|import)/i],
  "a host without the worker's script": [{ change: (path) => path === "/worker.js" && { status: 404 } }, /worker\.js can't be loaded/],
  "a sandboxed frame": [{ headers: { "content-security-policy": "sandbox allow-scripts" } }, /sandboxed/],
  "a sandboxed frame of a host that lets others read": [{ headers: { "content-security-policy": "sandbox allow-scripts", "access-control-allow-origin": "*" } }, /sandboxed/],
  "a browser that starts no workers": [{ before: "Worker = class { constructor() { throw new Error('as if'); } }" }, /worker.*as if/],
  "a browser without WebAssembly": [{ before: "delete globalThis.WebAssembly" }, /WebAssembly is missing/],
};

const tests = {
  async "the page loads"() {
    await page.go(site.address);
    await page.until("document.getElementById('points').textContent.endsWith('%')");
    assert.equal(await page.textOf("notice"), "");
  },

  async "a frame has the bits of --still"() {
    const still = execFileSync(intro, ["--still", "62.3", "--size", "641x363", "--isa", "sse2"], { maxBuffer: 1e8 });
    const frame = await page.frame(show(62.3, 4, 641, 363));
    assert.ok(frame.equals(still.subarray(still.length - frame.length)));
  },

  async "the slider changes what is traced"() {
    const share = async (quality) => {
      await page.input("quality", quality);
      await page.until(`!eightfold.isStale() && eightfold.view.quality === ${quality}`);
      return parseFloat(await page.textOf("points"));
    };
    const [all, few] = [await share(0), await share(7)];
    assert.ok(all >= 99 && few < 40, `${all} % and ${few} %`);
  },

  async "a faulty scene shows its line and column"() {
    await page.until("document.getElementById('scene-text').value.includes('spheres')");
    const text = await page.value("document.getElementById('scene-text').value");
    await page.input("scene-text", text.replace("radius: 1.0", "radius: -1.0"));
    const line = text.split("\n").findIndex((line) => line.includes("radius: 1.0")) + 1;
    assert.match(await page.textOf("scene-fault"), new RegExp(`^Line ${line}, column \\d+: `));
  },

  async "picture and button follow the sound, whoever stops it"() {
    const mixed = await soundtrack(110);
    await page.go(site.address);
    const together = async (what) => {
      // Take the median: an audio thread that waits for a processor is briefly late.
      const apart = (await leads(mixed, 7)).sort((a, b) => a - b);
      assert.ok(Math.abs(apart[3]) < 0.05, `${what}: ${apart.map((lead) => lead.toFixed(3))} s`);
    };
    const stands = async () => {
      const time = await page.value("eightfold.clock.time()");
      await sleep(700);
      assert.equal(await page.value("eightfold.clock.time()"), time);
      return time;
    };
    // Leave processor time to the sound.
    await page.input("quality", 7);
    await page.click("#start");
    await page.until("eightfold.clock.isPlaying && eightfold.clock.hasSound && eightfold.clock.time() > 6");
    assert.equal(await page.value(label), "Pause");
    await together("from the start");
    await page.value("eightfold.seek(30)");
    await page.until("!eightfold.clock.isMoving && eightfold.clock.time() > 30.2");
    await together("elsewhere");
    await page.click("#play");
    await page.until(`${label} === "Play" && !eightfold.clock.isPlaying`);
    await stands();
    await page.click("#play");
    await page.until(`${label} === "Pause"`);
    await together("after a pause");

    // Suspend and resume the context, as a phone call does.
    await page.value("eightfold.clock.context.suspend()");
    await page.until(`${label} === "Play" && !eightfold.clock.isPlaying`);
    assert.match(await page.textOf("notice"), /stopped the sound/);
    const time = await stands();
    await page.value("eightfold.clock.context.resume()");
    await page.until(`${label} === "Pause" && eightfold.clock.isPlaying && eightfold.clock.time() > ${time + 0.3}`);
    assert.equal(await page.textOf("notice"), "");
    await together("after a call");
    await page.value("eightfold.clock.context.suspend()");
    await page.until(`${label} === "Play"`);
    await page.click("#play");
    await page.until(`${label} === "Pause"`);
    await together("after a call that the viewer ended");
    // While paused, the page suspends a context that the browser resumes.
    await page.click("#play");
    await page.until("eightfold.clock.context.state === 'suspended'");
    await page.value("eightfold.clock.context.resume()");
    await page.until("eightfold.clock.context.state === 'suspended'");
    assert.equal(await page.value(label), "Play");
    // Simulate a device that stops.
    await page.click("#play");
    await page.until(`${label} === "Pause" && !eightfold.clock.isMoving`);
    await page.value("Object.defineProperty(eightfold.clock.context, 'currentTime', { get: () => 7, configurable: true }), true");
    const last = await page.value("eightfold.clock.time()");
    await page.until(`eightfold.clock.time() > ${last + 1} && !eightfold.clock.hasSound`);
    assert.match(await page.textOf("notice"), /^Sound is off: /);
    assert.equal(await page.value(label), "Pause");
    await page.value("delete eightfold.clock.context.currentTime");
    await page.until("eightfold.clock.hasSound && !eightfold.clock.isMoving");
    await together("after a device stood still");
    // A seek to an integer without limit fails in the synthesizer.
    await page.value("(globalThis.failed = eightfold.clock.node, failed.port.postMessage(10n ** 12n), true)");
    await page.until("eightfold.clock.node !== failed && eightfold.clock.hasSound && !eightfold.clock.isMoving");
    await together("after a failure of the synthesizer");
  },

  async "the show plays without a synthesizer that fails at once"() {
    let isBroken = true;
    const host = await serve(folder, {}, (path, own) => isBroken && path === "/sound.js" && { bytes: String(own).replace("super();", "super(); throw Error();") });
    try {
      await page.go(host.address);
      await page.click("#start");
      await page.until("eightfold.clock.isPlaying && eightfold.clock.time() > 1 && !eightfold.clock.hasSound");
      assert.equal(await page.textOf("notice"), "Sound is off: its synthesizer failed.");
      assert.equal(await page.value(label), "Pause");
      // Play opens the sound again.
      isBroken = false;
      await page.click("#play");
      await page.until(`${label} === "Play"`);
      await page.click("#play");
      await page.until("eightfold.clock.isPlaying && eightfold.clock.hasSound && !eightfold.clock.isMoving");
      assert.equal(await page.textOf("notice"), "");
    } finally {
      host.end();
    }
  },
};

const silent = {
  async "the page plays without a sound device, with a message"() {
    await page.go(site.address);
    await page.click("#start");
    await page.until("eightfold.clock.isPlaying && eightfold.clock.time() > 1");
    assert.match(await page.textOf("notice"), /^Sound is off: /);
    assert.equal(await page.value(label), "Pause");
    await page.click("#play");
    await page.until(`${label} === "Play"`);
  },
};

for (const [name, [{ headers, change, before }, sentence]] of Object.entries(faults)) {
  tests[`${name} is ${sentence ? "reported" : "accepted"}`] = async () => {
    const inject = (path, own) => (path === "/index.html" || path === "/" ? { bytes: String(own).replace("<head>", `<head><script>${before}</script>`) } : {});
    const host = await serve(folder, headers, before ? inject : change);
    try {
      if (sentence === null) {
        await page.go(host.address);
        assert.equal(await page.value("eightfold.code.name"), "eightfold.bin");
      } else {
        await page.go(host.address, "document.getElementById('notice') && !/Loading|^$/.test(document.getElementById('notice').textContent)");
        assert.match(await page.textOf("notice"), sentence);
        // The message stays unless the show plays.
        if (!(await page.value("document.getElementById('machine').textContent"))) {
          await sleep(1000);
          assert.match(await page.textOf("notice"), sentence);
        }
      }
    } finally {
      host.end();
    }
  };
}

const code = await run(word === "silent" ? silent : tests, word === "silent" ? "" : word, ` in ${engine}`, engine === "webkit" ? replace : undefined);
await page.end();
process.exit(code);
