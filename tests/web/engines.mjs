// Tests the page in every engine: node engines.mjs chromium|firefox|webkit SITE INTRO [WORD]. SITE is the folder of the page, INTRO the
// program, and WORD selects tests by name; "silent" selects the tests without a sound device.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";
import { Browser } from "./chromium.mjs";
import { hasMarks, run, serve, sleep } from "./driver.mjs";
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
  "a host without a script": [{ change: (path) => path === "/clock.js" && { status: 404 } }, /can.t be played: module clock\.js: HTTP status is 404; must be 200/],
  "a host that serves scripts as text": [{ change: (path) => path.endsWith(".js") && { more: { "content-type": "text/plain" } } }, /can.t be played: module page\.js: content type is text\/plain; must be text\/javascript/],
  "a host without the worker's script": [{ change: (path) => path === "/worker.js" && { status: 404 } }, /worker\.js can't be loaded/],
  "a sandboxed frame": [{ headers: { "content-security-policy": "sandbox allow-scripts" } }, /sandboxed/],
  "a sandboxed frame of a host that lets others read": [{ headers: { "content-security-policy": "sandbox allow-scripts", "access-control-allow-origin": "*" } }, /sandboxed/],
  "a browser that starts no workers": [{ before: "Worker = class { constructor() { throw new Error('as if'); } }" }, /worker.*as if/],
  "a browser without WebAssembly": [{ before: "delete globalThis.WebAssembly" }, /WebAssembly is missing/],
};

/** Serves the page with a change of the texts of its files. */
const serveChanged = (change) => serve(folder, {}, (path, own) => ({ bytes: change(path === "/" ? "/index.html" : path, String(own)) || own }));

/** Asserts that figures and the plot are finite, and that the plot is small. */
async function assertFinite() {
  await page.until("eightfold.steps.front().length === 7 || document.getElementById('front-note').textContent.includes('failed')", 180);
  const speeds = await page.value("eightfold.steps.front().map(({ speed }) => speed)");
  assert.ok(speeds.length === 7 && speeds.every((speed) => speed > 0 && speed < 1000), `${speeds}, ${await page.textOf("front-note")}`);
  const parts = await page.value("document.getElementById('front-axes').childElementCount");
  assert.ok(parts > 10 && parts < 60, `${parts} parts`);
  const isTimed = "/^[1-9]/.test(document.getElementById('milliseconds').textContent)";
  await page.until(isTimed);
  await page.click("input[value=split] + span");
  await page.until("/, [\\d.]+ times as fast$/.test(document.getElementById('right-side').textContent)");
  await page.click("input[value=none] + span");
  await page.click("#play");
  await page.until("eightfold.clock.isPlaying && Number(document.getElementById('rate').textContent) > 0");
  await page.until(isTimed);
  await page.click("#play");
}

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

  async "a mistake is shown over the last valid scene, also from its address"() {
    const mistake = "document.getElementById('mistake')";
    const isSeen = () => page.value(`(() => { scrollTo(0, 0); const { x, y, bottom } = ${mistake}.getBoundingClientRect(); return ${mistake}.checkVisibility() && bottom < innerHeight && document.elementFromPoint(x + 20, y + 9) === ${mistake}; })()`);
    const picture = async (source) => {
      await page.until(`eightfold.view.source === "${source}" && !eightfold.isStale()`);
      return page.value("document.getElementById('picture').toDataURL()");
    };
    const share = async () => {
      await page.value("document.getElementById('share').click()");
      await page.until("location.hash.includes('scene=')");
      return page.value("location.href");
    };
    await page.go(site.address);
    await page.until("document.getElementById('scene-text').value.includes('spheres')");
    const text = (await page.value("document.getElementById('scene-text').value")).replace("(-2.2, 1.0, 0.0)", "(-2.0, 1.3, 0.0)");
    const wrong = text.replace("radius: 1.0", "radius: -1.0");
    const line = wrong.split("\n").findIndex((line) => line.includes("-1.0")) + 1;
    // Without a valid scene, the show is behind the mistake.
    await page.input("scene-text", wrong);
    assert.ok(await isSeen());
    await page.go(await share());
    await page.until(`!${mistake}.hidden`);
    assert.match(await page.value(`${mistake}.textContent`), new RegExp(`^Line ${line}, column \\d+: `));
    assert.ok(await isSeen());
    assert.equal(await page.value("eightfold.view.source"), "show");
    await page.input("scene-text", text);
    const valid = await picture("file");
    assert.ok(!(await isSeen()));
    await page.input("scene-text", wrong);
    assert.ok(await isSeen());
    assert.equal(await picture("file"), valid);
    await page.value("history.replaceState(null, '', '#')");
    await page.go(await share());
    assert.equal(await picture("file"), valid);
    assert.equal(await page.value("document.getElementById('scene-text').value"), wrong);
    assert.match(await page.value(`${mistake}.textContent`), new RegExp(`^Line ${line}, column \\d+: `));
    assert.ok(await isSeen());
    // A click selects the line.
    await page.click("#mistake");
    const [selected, focused] = await page.value("(({ value, selectionStart, selectionEnd }) => [value.slice(selectionStart, selectionEnd), document.activeElement.id])(document.getElementById('scene-text'))");
    assert.deepEqual([selected, focused], [wrong.split("\n")[line - 1], "scene-text"]);
    await page.click("#back");
    assert.ok(!(await isSeen()));
    // A damaged address is reported in the same place.
    await page.go(`${site.address}#scene=AAAA`);
    await page.until(`!${mistake}.hidden`);
    assert.equal(await page.value(`${mistake}.textContent`), "The scene in the address is damaged.");
    assert.ok(await isSeen());
  },

  async "a paused picture refines to finest, unless the viewer chose a quality"() {
    await page.go(site.address);
    const { qualities } = await page.value("eightfold.about");
    const named = async (name) => {
      assert.equal(await page.textOf("quality-name"), name);
      assert.equal(await page.value("document.getElementById('quality').getAttribute('aria-valuetext')"), name);
    };
    await page.until("!eightfold.isStale()");
    await named("finest");
    // Slow frames make the governor select the fastest quality.
    await page.value("(globalThis.fast = eightfold.frames.draw, eightfold.frames.draw = async function (order) { await new Promise((resolve) => setTimeout(resolve, 60)); return fast.call(this, order); }, true)");
    await page.click("#start");
    await page.until(`eightfold.view.quality === ${qualities.length - 1}`);
    await named("fastest");
    await page.value("delete eightfold.frames.draw");
    await page.click("#play");
    await page.until("!eightfold.clock.isPlaying && !eightfold.isStale()");
    await named("finest");
    const differing = await page.value(`(async () => {
      const { bytesOf } = await import(new URL("frames.js", location));
      const { width, height } = document.getElementById("picture");
      const order = { scene: { kind: "show", time: eightfold.shown(), isResting: true }, quality: 1, isReference: false, width, height };
      const own = bytesOf(await eightfold.frames.draw(order));
      const shown = document.getElementById("picture").getContext("2d").getImageData(0, 0, width, height).data;
      return shown.filter((byte, i) => byte !== own[i]).length;
    })()`);
    assert.equal(differing, 0);
    // A shared picture refines, too, unless its quality was chosen.
    await page.value("document.getElementById('share').click()");
    await page.until("location.hash.includes('t=')");
    assert.ok(!(await page.value("location.hash.includes('quality')")));
    await page.input("quality", qualities.length - 1);
    await page.until("!eightfold.isStale()");
    await sleep(500);
    await named("fastest");
    await page.value("(history.replaceState(null, '', '#'), document.getElementById('share').click())");
    await page.until("location.hash.includes('quality=fastest')");
  },

  async "figures wait for warm frames and for an interval below 2 dB"() {
    // The first frames of each worker take longer.
    const wait = 3000;
    const spin = `if (pass === 0 && (globalThis.drawn = (globalThis.drawn ?? 0) + 1) < 3) for (const end = Date.now() + ${wait}; Date.now() < end; );`;
    const host = await serveChanged((path, own) => path === "/worker.js" && own.replace("const start = performance.now();", `$& ${spin}`));
    try {
      await page.go(host.address);
      await page.value(`(() => {
        globalThis.seen = { accuracy: [], milliseconds: [], rate: [] };
        for (const id in seen) new MutationObserver(() => seen[id].push(document.getElementById(id).textContent)).observe(document.getElementById(id), { childList: true, characterData: true });
      })()`);
      await page.until("seen.accuracy.some((text) => text.includes('±'))");
      await page.click("#start");
      await page.until("eightfold.clock.isPlaying && seen.rate.some((text) => text !== '–')");
      await page.click("#play");
      await page.until("!eightfold.clock.isPlaying && !eightfold.isStale() && document.getElementById('accuracy').textContent.includes('±')");
      const { accuracy, milliseconds, rate } = await page.value("seen");
      const wide = accuracy.filter((text) => text !== "–" && text !== "no error found" && !(Number(/^[\d.]+ ± ([\d.]+) dB$/.exec(text)?.[1]) <= 2));
      assert.deepEqual(wide, []);
      const times = milliseconds.filter((text) => text !== "–").map(Number);
      assert.ok(times.length > 0 && times.every((time) => time > 0 && time < wait), `${milliseconds}`);
      assert.ok(rate.every((text) => text === "–" || Number(text) <= 100), `${rate}`);
    } finally {
      host.end();
    }
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

if (engine === "firefox") {
  tests["it is whole where fingerprinting is resisted, by a clock with steps of 100 ms, and colours are forced"] = async () => {
    const usual = page;
    page = await Firefox.start({
      "privacy.resistFingerprinting": true,
      "privacy.resistFingerprinting.reduceTimerPrecision.microseconds": 100000,
      "browser.display.document_color_use": 2,
    });
    try {
      await page.go(site.address);
      assert.ok(await page.value(`matchMedia("(forced-colors: active)").matches && (${hasMarks})()`));
      await assertFinite();
    } finally {
      await page.end();
      page = usual;
    }
  };
}

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
