// Tests of the page in Chromium: node page.mjs SITE INTRO SAMPLES SCREENSHOTS, the folder of the page, the intro's program, what that
// played, as samples of 4 bytes, and a folder for screenshots. It prints a line for each test, and fails if one does.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser, serve } from "./chromium.mjs";

const [folder, intro, samples, screenshots] = process.argv.slice(2);
const site = await serve(folder);
const isolated = await serve(folder, { "cross-origin-opener-policy": "same-origin", "cross-origin-embedder-policy": "require-corp" });
const browser = new Browser();
const page = await browser.open(site.address);

/** A frame of the page's, as bytes of red, green and blue, by an expression for what draws it. */
const frame = async (order, frames = "eightfold.frames") => Buffer.from(await page.value(`(async () => {
  const { bytesOf } = await import("./frames.js");
  const bytes = bytesOf(await ${frames}.draw(${JSON.stringify(order)})).filter((_, i) => i % 4 < 3);
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
})()`), "base64");

/** The same by the intro. */
function still({ scene: { time }, width, height }, quality) {
  const options = ["--still", time, "--size", `${width}x${height}`, "--isa", "sse2", "--quality", quality];
  const file = execFileSync(intro, options, { maxBuffer: 1e8 });
  return file.subarray(file.length - 3 * width * height);
}

const show = (time, quality, width, height) => ({ scene: { kind: "show", time }, quality, isReference: false, width, height });
const input = (id, value) => page.value(`(() => { const input = document.getElementById("${id}"); input.value = ${JSON.stringify(value)}; input.dispatchEvent(new Event("input", { bubbles: true })); })()`);
const textOf = (id) => page.value(`document.getElementById("${id}").textContent`);

const tests = {
  async "the page loads without a message"() {
    await page.until("document.getElementById('points').textContent.endsWith('%')");
    assert.deepEqual(page.messages, []);
    assert.equal(await textOf("notice"), "");
  },

  async "frames have the bits of --still, by any number of workers"() {
    const { qualities } = await page.value("eightfold.about");
    for (const workers of [1, 2, 5]) {
      await page.value(`import("./frames.js").then(({ Frames }) => { globalThis.others = new Frames(eightfold.frames.compiled, ${workers}, (why) => { throw why; }) })`);
      // With antialiased edges, odd sizes, a caption that counts points, squares of 32, and jagged edges.
      for (const order of [show(62.3, 4, 641, 363), show(34.5, 4, 640, 360), show(0, 4, 320, 200), show(100, 7, 640, 360), show(47, 0, 320, 240)]) {
        const name = qualities[order.quality];
        assert.ok((await frame(order, "others")).equals(still(order, name)), `${workers} workers, ${name}, ${order.scene.time} s`);
      }
      await page.value("others.workers.forEach((worker) => worker.terminate())");
    }
  },

  async "the slider changes the quality and what it takes"() {
    const at = async (quality) => {
      await input("quality", quality);
      await page.until(`!eightfold.isStale() && eightfold.view.quality === ${quality}`);
      return { name: await textOf("quality-name"), points: parseFloat(await textOf("points")) };
    };
    const [exact, fastest] = [await at(0), await at(7)];
    assert.equal(exact.name, "exhaustive");
    assert.equal(fastest.name, "fastest");
    assert.ok(exact.points >= 99 && fastest.points < 40, `${exact.points} % and ${fastest.points} %`);
  },

  async "each overlay shows another picture"() {
    const seen = new Set();
    for (const overlay of ["none", "points", "squares", "error", "split"]) {
      await page.click(`input[value=${overlay}] + span`);
      await page.until(`!eightfold.isStale() && eightfold.view.overlay === "${overlay}"`);
      seen.add(await page.value("document.getElementById('picture').toDataURL()"));
    }
    assert.equal(seen.size, 5);
    await page.click("input[value=none] + span");
  },

  async "a square tells why it was split"() {
    await page.value("eightfold.seek(20)");
    await page.until("!eightfold.isStale()");
    const lines = await page.value("Array.from({ length: 34 }, (_, i) => eightfold.inspect(30 * i + 5, 301))");
    assert.ok(lines.every((line) => /^8×8 (filled|split)/.test(line)), lines.join("\n"));
    assert.ok(lines.some((line) => line.includes("split")) && lines.some((line) => line.includes("filled")), lines.join("\n"));
  },

  async "a click plays, with and without headers of isolation, and the picture keeps to the sound"() {
    for (const { address } of [isolated, site]) {
      await page.go(address);
      assert.equal(await page.value("crossOriginIsolated"), address === isolated.address);
      await page.click("#start");
      await page.until("eightfold.clock.time() > 1");
      assert.ok(await page.value("eightfold.clock.hasSound && eightfold.clock.isPlaying"));
    }
    await page.value("eightfold.seek(64)");
    await page.until("!eightfold.clock.isMoving && eightfold.clock.time() > 64.2");
    assert.ok(await page.value("eightfold.clock.time() < 90"));
    await page.key(" ", "Space");
    await page.until("!eightfold.clock.isPlaying");
    assert.deepEqual(page.messages, []);
  },

  async "every key does what the page says, whatever was clicked before"() {
    await page.go(site.address);
    const { qualities } = await page.value("eightfold.about");
    for (const clicked of ["#scenes button:nth-child(3)", "input[value=points] + span", "#held", "#time", "#quality"]) {
      await page.click(clicked);
      // Space is a checkbox's own.
      const plays = clicked === "#held" ? [] : [true, false];
      for (const isPlaying of plays) {
        await page.key(" ", "Space");
        await page.until(`eightfold.clock.isPlaying === ${isPlaying}`);
      }
      await page.key("3");
      assert.equal(await textOf("quality-name"), qualities[2], clicked);
      const overlay = await page.value("eightfold.view.overlay");
      await page.key("o");
      assert.notEqual(await page.value("eightfold.view.overlay"), overlay, clicked);
      await page.key("m");
      assert.equal(await page.value("document.getElementById('mute').getAttribute('aria-pressed')"), "true", clicked);
      await page.key("m");
    }
    await page.click("#picture");
    await page.until("eightfold.clock.isPlaying");
    await page.key("Escape");
    await page.until("!eightfold.clock.isPlaying");
    await page.value("eightfold.seek(50)");
    await page.key("ArrowRight");
    assert.equal(await page.value("eightfold.clock.time()"), 52);
    await page.key("ArrowLeft");
    assert.equal(await page.value("eightfold.clock.time()"), 50);
    await page.key("f");
    await page.until("document.fullscreenElement?.id === 'stage'");
    await page.key("f");
    await page.until("!document.fullscreenElement");
  },

  async "the sound has the intro's samples"() {
    const seconds = 4;
    const heard = Buffer.from(await page.value(`(async () => {
      const { code: { bytes: code } } = eightfold;
      const context = new OfflineAudioContext(2, 48000 * ${seconds}, 48000);
      await context.audioWorklet.addModule("sound.js");
      const node = new AudioWorkletNode(context, "eightfold", { numberOfInputs: 0, outputChannelCount: [2], processorOptions: { code } });
      node.connect(context.destination);
      const [left, right] = [0, 1].map(((sound) => (side) => sound.getChannelData(side))(await context.startRendering()));
      const samples = new Uint8Array(Float32Array.from({ length: 2 * left.length }, (_, i) => [left, right][i % 2][i >> 1]).buffer);
      let letters = "";
      samples.forEach((byte) => (letters += String.fromCharCode(byte)));
      return btoa(letters);
    })()`), "base64");
    const played = readFileSync(samples).subarray(0, heard.length);
    assert.equal(heard.length, 48000 * seconds * 8);
    assert.ok(played.some((byte) => byte !== 0));
    assert.ok(heard.equals(played));
  },

  async "every example is in the list"() {
    const names = readdirSync(join(folder, "scenes")).map((name) => name.replace(".ron", "")).sort();
    assert.deepEqual(await page.value("[...document.querySelectorAll('#scene-name option')].map(({ text }) => text).sort()"), names);
  },

  async "a faulty scene shows its line and column"() {
    await page.value("document.getElementById('scene-text').scrollIntoView()");
    await page.until("document.getElementById('scene-text').value.includes('spheres')");
    const text = await page.value("document.getElementById('scene-text').value");
    await input("scene-text", text.replace("radius: 1.0", "radius: -1.0"));
    await page.until("document.getElementById('scene-fault').textContent !== ''");
    const line = text.split("\n").findIndex((line) => line.includes("radius: 1.0")) + 1;
    assert.match(await textOf("scene-fault"), new RegExp(`^Line ${line}, column \\d+: spheres\\[0\\].radius is -1`));
    await input("scene-text", text);
    await page.until("document.getElementById('scene-fault').textContent === '' && eightfold.view.source === 'file' && !eightfold.isStale()");
  },

  async "an address brings back what it shared"() {
    await page.value("eightfold.seek(3)");
    await page.value("document.getElementById('share').click()");
    await page.until("location.hash.length > 100");
    const [address, text] = await page.value("[location.href, document.getElementById('scene-text').value]");
    await page.go(address);
    await page.until("eightfold.view.source === 'file' && !eightfold.isStale()");
    assert.equal(await page.value("document.getElementById('scene-text').value"), text);
    assert.ok(Math.abs(await page.value("eightfold.clock.time()") - 3) < 0.1);
    await page.go(site.address);
  },

  async "a worker that dies is told of and replaced"() {
    const before = await frame(show(70, 4, 320, 180));
    const deaths = page.workers.map((worker) => page.value("self.postMessage = () => { throw new Error('as if'); }", worker).catch(() => {}));
    await Promise.all(deaths);
    const after = await frame(show(70, 4, 320, 180));
    assert.ok(after.equals(before));
    assert.match(await textOf("notice"), /^A worker died \(.*as if.*\)\. Another one/);
  },

  async "twenty reloads leave no workers behind"() {
    page.messages.length = 0;
    for (let turn = 0; turn < 20; turn++) await page.go(site.address);
    await page.until("document.getElementById('points').textContent.endsWith('%')");
    // The browser ends them in its own time.
    const wanted = await page.value("eightfold.frames.workers.length + 1");
    const count = async () => (await browser.send("Target.getTargets", { filter: [{ type: "worker" }] })).targetInfos.length;
    for (let turn = 0; turn < 300 && (await count()) !== wanted; turn++) await new Promise((resolve) => setTimeout(resolve, 100));
    assert.equal(await count(), wanted);
    assert.deepEqual(page.messages, []);
  },

  async "from a file it says what is to be done"() {
    await page.go(pathToFileURL(join(folder, "index.html")).href, "document.readyState === 'complete'");
    assert.match(await page.value("document.querySelector('main').innerText"), /^Browsers do not play this page from a file\. Run .* and open http/);
    writeFileSync(join(screenshots, "web-file.png"), await page.screenshot());
  },

  async "it fits a screen and a phone, and rests where less motion is asked for"() {
    await page.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-reduced-motion", value: "reduce" }] });
    for (const [width, height, scale] of [[1440, 900, 1], [390, 844, 2]]) {
      await page.resize(width, height, scale);
      await page.go(site.address);
      await page.until("document.getElementById('points').textContent.endsWith('%') && eightfold.steps.front().length === 7");
      writeFileSync(join(screenshots, `web-${width}x${height}.png`), await page.screenshot(true));
      assert.equal(await page.value("document.getAnimations().length"), 0);
      assert.equal(await page.value("getComputedStyle(document.querySelector('#front .present')).transitionDuration"), "0s");
      assert.ok(!(await page.value("eightfold.clock.isPlaying")));
      assert.ok(await page.value("document.documentElement.scrollWidth <= innerWidth"), `wider than ${width} pixels`);
    }
  },
};

let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  const start = Date.now();
  try {
    await test();
    console.log(`ok      ${name} (${((Date.now() - start) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failed++;
    console.log(`FAILED  ${name}\n${error.stack}`);
  }
}
await browser.end();
site.end();
isolated.end();
process.exit(failed ? 1 : 0);
