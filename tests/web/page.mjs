// Tests the page in Chromium: node page.mjs SITE INTRO SAMPLES SCREENSHOTS [WORD]. SITE is the folder of the page, INTRO the program,
// SAMPLES its sound as floats, and WORD selects tests by name.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./chromium.mjs";
import { hasMarks, run, serve, sleep } from "./driver.mjs";

const [folder, intro, samples, screenshots, word = ""] = process.argv.slice(2);
const site = await serve(folder);
const isolated = await serve(folder, { "cross-origin-opener-policy": "same-origin", "cross-origin-embedder-policy": "require-corp" });
const browser = new Browser();
const page = await browser.open(site.address);

/** Returns a frame of the intro. */
function still({ scene: { time }, width, height }, quality) {
  const options = ["--still", time, "--size", `${width}x${height}`, "--isa", "sse2", "--quality", quality];
  const file = execFileSync(intro, options, { maxBuffer: 1e8 });
  return file.subarray(file.length - 3 * width * height);
}

const show = (time, quality, width, height) => ({ scene: { kind: "show", time }, quality, isReference: false, width, height });
const input = (id, value) => page.input(id, value);
/** Returns the bytes of a picture, in the page. */
const pixelsOf = `((image) => {
  const context = new OffscreenCanvas(image.width, image.height).getContext("2d", { willReadFrequently: true });
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, image.width, image.height).data;
})`;
const textOf = (id) => page.textOf(id);

/**
 * Returns the WCAG contrast of each visible text. Behind transparent backgrounds, it assumes the worse of black and white. Runs in the
 * page.
 */
function contrastsOf() {
  const numbers = (colour) => colour.match(/[\d.]+/g).map(Number);
  const luminance = (colour) => {
    const [r, g, b] = colour.map((value) => (value <= 10.3 ? value / 3294.6 : ((value / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const behind = (element, picture) => {
    const [r, g, b, alpha = 1] = numbers(getComputedStyle(element).backgroundColor);
    if (alpha === 1) return [r, g, b];
    const below = element.id === "screen" || !element.parentElement ? [picture, picture, picture] : behind(element.parentElement, picture);
    return [r, g, b].map((value, i) => alpha * value + (1 - alpha) * below[i]);
  };
  const contrast = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  const hasText = ({ childNodes }) => [...childNodes].some(({ nodeType, data }) => nodeType === Node.TEXT_NODE && data.trim());
  return [...document.querySelectorAll("body *")].filter((element) => hasText(element) && element.checkVisibility()).map((element) => {
    const { color, fill } = getComputedStyle(element);
    const own = luminance(numbers(element instanceof SVGElement ? fill : color).slice(0, 3));
    return { text: element.textContent.trim().slice(0, 40), contrast: Math.min(...[0, 255].map((picture) => contrast(own, luminance(behind(element, picture))))) };
  });
}

const tests = {
  async "the page loads without a message"() {
    await page.until("document.getElementById('points').textContent.endsWith('%')");
    assert.deepEqual(page.messages, []);
    assert.equal(await textOf("notice"), "");
  },

  async "frames have the bits of --still, with any number of workers"() {
    const { qualities } = await page.value("eightfold.about");
    // The frames have antialiased edges, odd sizes, a caption with counts, squares of 32, and jagged edges.
    const orders = [show(62.3, 4, 641, 363), show(37.5, 4, 640, 360), show(0, 4, 320, 200), show(100, 7, 640, 360), show(47, 0, 320, 240)];
    const expected = orders.map((order) => still(order, qualities[order.quality]));
    for (const workers of [1, 2, 5]) {
      await page.value(`import("./frames.js").then(({ Frames }) => { globalThis.others = new Frames(eightfold.frames.compiled, ${workers}, (why) => { throw why; }) })`);
      for (const [i, order] of orders.entries()) {
        const name = qualities[order.quality];
        assert.ok((await page.frame(order, "others")).equals(expected[i]), `${workers} workers, ${name}, ${order.scene.time} s`);
      }
      await page.value("others.workers.forEach((worker) => worker.terminate())");
    }
  },

  async "the slider changes the quality and the points"() {
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

  async "each overlay shows a different picture"() {
    const seen = new Set();
    for (const overlay of ["none", "points", "squares", "error", "split"]) {
      await page.click(`input[value=${overlay}] + span`);
      await page.until(`!eightfold.isStale() && eightfold.view.overlay === "${overlay}"`);
      seen.add(await page.value("document.getElementById('picture').toDataURL()"));
    }
    assert.equal(seen.size, 5);
    await page.click("input[value=none] + span");
  },

  async "a split picture is exhaustive left of its handle, and has the slider's quality on the right"() {
    await page.value("eightfold.seek(20)");
    await input("quality", 6);
    await page.click("input[value=split] + span");
    const { x, y, width } = await page.value("(({ x, y, width }) => ({ x, y, width }))(document.getElementById('screen').getBoundingClientRect())");
    // Drag to a quarter of the width, and step by a key.
    await page.mouse("mousePressed", x + width / 2, y + 100);
    await page.mouse("mouseMoved", x + width / 4, y + 100, true);
    await page.mouse("mouseReleased", x + width / 4, y + 100);
    assert.ok(Math.abs((await page.value("eightfold.view.handle")) - 0.25) < 0.01);
    await page.value("document.getElementById('handle').focus()");
    await page.key("ArrowRight");
    await page.until("!eightfold.isStale() && eightfold.view.handle > 0.26");
    const [left, right, apart] = await page.value(`(async () => {
      const { bytesOf } = await import("./frames.js");
      const { width, height } = document.getElementById("picture");
      const order = { scene: { kind: "show", time: eightfold.clock.time() }, quality: 6, width, height };
      const exact = bytesOf(await eightfold.frames.draw({ ...order, isReference: true }));
      const own = bytesOf(await eightfold.frames.draw({ ...order, isReference: false }));
      const shown = ${pixelsOf}(document.getElementById("picture"));
      const differ = (bytes, from, to) => shown.filter((byte, i) => (i >> 2) % width >= from && (i >> 2) % width < to && byte !== bytes[i]).length;
      const handle = Math.round(eightfold.view.handle * width);
      return [differ(exact, 0, handle), differ(own, handle, width), differ(own, 0, handle)];
    })()`);
    assert.equal(left, 0);
    assert.equal(right, 0);
    assert.ok(apart > 0);
    await page.click("input[value=none] + span");
  },

  async "a pointer on a square shows why it was split, with a loupe"() {
    await page.value("eightfold.seek(20)");
    await input("quality", 4);
    await page.until("!eightfold.isStale()");
    const places = await page.value("Array.from({ length: 34 }, (_, i) => eightfold.inspect(30 * i + 5, 301))");
    for (const { squares, points } of places) {
      assert.match(squares[0].what, /^(filled|split)/);
      // Each square contains the next, and the first corner of the largest is traced.
      squares.slice(1).forEach(({ x, y, w, h }, i) => assert.ok(x >= squares[i].x && y >= squares[i].y && w <= squares[i].w && h <= squares[i].h));
      const [{ x, y }] = squares;
      assert.ok(points.some((point) => point[0] === x && point[1] === y), `(${x}, ${y})`);
    }
    const last = places.map(({ squares }) => squares.at(-1).what);
    assert.ok(places.some(({ squares }) => squares[0].what.startsWith("split")) && last.some((what) => what.startsWith("filled")));

    const split = places.findIndex(({ squares }) => squares.length > 1);
    const [x, y] = await page.value(`(() => {
      const canvas = document.getElementById("picture");
      const [box, scale] = [canvas.getBoundingClientRect(), canvas.clientWidth / canvas.width];
      return [box.x + (30 * ${split} + 5.5) * scale, box.y + 301.5 * scale];
    })()`);
    await page.mouse("mouseMoved", x, y);
    await page.until("!document.getElementById('verdict').hidden");
    const said = await page.value("document.querySelector('#verdict p').textContent");
    const sentences = ({ squares }) => squares.map(({ w, h, what }) => `${w}×${h} ${what}`).join("\n");
    // Browsers round a pointer's place.
    const [column, row] = await page.value(`(() => {
      const canvas = document.getElementById("picture");
      return ["offsetX", "offsetY"].map((offset) => Math.floor((eightfold.view.place[offset] * canvas.width) / canvas.clientWidth));
    })()`);
    assert.ok(Math.abs(column - 30 * split - 5) <= 2 && Math.abs(row - 301) <= 2, `(${column}, ${row})`);
    assert.equal(said, sentences(await page.value(`eightfold.inspect(${column}, ${row})`)));
    writeFileSync(join(screenshots, "web-verdict.png"), await page.screenshot());
    // The loupe shows pixels, white points, and the last square in colour.
    const colours = await page.value(`(() => {
      return new Set(new Uint32Array(${pixelsOf}(document.getElementById("loupe")).buffer)).size;
    })()`);
    assert.ok(colours > 20, `${colours} colours`);
    // A key moves the loupe by a square.
    await page.key("ArrowRight", "ArrowRight", true);
    const beside = await page.value(`eightfold.inspect(${column + 8}, ${row})`);
    const shown = "document.querySelector('#verdict p').textContent";
    await page.until(`${shown} === ${JSON.stringify(sentences(beside))}`);
    assert.equal(await page.value("eightfold.clock.time()"), 20);
    // A repeated move keeps the loupe where a key has moved it.
    await page.mouse("mouseMoved", x, y);
    await sleep(300);
    assert.equal(await page.value(shown), sentences(beside));
    await page.mouse("mouseMoved", 1, 1);
    await page.until("document.getElementById('verdict').hidden");
  },

  async "Save PNG saves what is shown"() {
    const saved = mkdtempSync(join(tmpdir(), "eightfold-saved-"));
    await browser.send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: saved });
    await page.value("eightfold.seek(20)");
    await page.until("!eightfold.isStale()");
    await page.click("#save");
    const names = () => readdirSync(saved).filter((name) => name.endsWith(".png"));
    for (let turn = 0; turn < 300 && names().length === 0; turn++) await new Promise((resolve) => setTimeout(resolve, 100));
    assert.deepEqual(names(), ["eightfold-20.00.png"]);
    const letters = readFileSync(join(saved, names()[0])).toString("base64");
    rmSync(saved, { recursive: true });
    const [wide, shown, differ] = await page.value(`(async () => {
      const image = await createImageBitmap(await (await fetch("data:image/png;base64,${letters}")).blob());
      const picture = document.getElementById("picture");
      const [saved, shown] = [image, picture].map(${pixelsOf});
      return [image.width, picture.width, saved.filter((byte, i) => byte !== shown[i]).length];
    })()`);
    assert.deepEqual([wide, differ], [shown, 0]);
  },

  async "a resting picture is whole, and measured until its interval is below 0.3 dB"() {
    // Seek to the start of a scene, which is coarse while the show plays, by the scene's name and by the scrubber.
    const ways = [
      ["document.querySelector('#scenes button:nth-child(4)').click()", 7],
      ["eightfold.seek(0)", 4],
      ["eightfold.seek(90.1)", 4],
      ["eightfold.seek(2.4)", 1],
    ];
    // A small picture has fewer pixels to measure.
    await page.resize(640, 480);
    await page.go(site.address);
    for (const [way, quality] of ways) {
      await page.value("eightfold.seek(40)");
      await input("quality", quality);
      await page.until("!eightfold.isStale() && eightfold.isSettled()");
      const before = await textOf("accuracy");
      await page.value(way);
      await page.until("!eightfold.isStale() && document.getElementById('accuracy').textContent.includes('±')");
      const [, first, margin] = /^(\d+\.\d) ± (\d+\.\d) dB$/.exec(await textOf("accuracy")) ?? [];
      await page.until("eightfold.isSettled()");
      const text = await textOf("accuracy");
      const [, told, interval] = /^(\d+\.\d) ± (\d+\.\d) dB$/.exec(text) ?? [];
      assert.ok(told, `${way}: ${text}`);
      assert.ok(Number(interval) <= 0.3 && Number(margin) >= Number(interval), `${way}: ±${margin}, then ±${interval}, after ${before}`);
      const [apart, truth] = await page.value(`(async () => {
        const { bytesOf, decibels, squaredError } = await import("./frames.js");
        const { width, height } = document.getElementById("picture");
        const order = { scene: { kind: "show", time: eightfold.clock.time(), isResting: true }, quality: ${quality}, width, height };
        const [exact, own] = [await eightfold.frames.draw({ ...order, isReference: true }), await eightfold.frames.draw(order)].map(bytesOf);
        const shown = ${pixelsOf}(document.getElementById("picture"));
        return [shown.filter((byte, i) => byte !== own[i]).length, decibels(squaredError(own, exact), width * height)];
      })()`);
      assert.equal(apart, 0, way);
      // The coarse picture would have 25 dB.
      assert.ok(truth > 38 && Math.abs(told - truth) < 0.6, `${way}: ${text}, but it is ${truth.toFixed(2)} dB; at first ${first} ± ${margin}`);
    }
    // Changes of the sound keep the probes, changes of the picture discard them.
    const kept = await page.value("eightfold.probes().probed");
    await page.key("m");
    await page.until("!eightfold.isStale()");
    await page.key("m");
    await page.until("!eightfold.isStale()");
    assert.ok((await page.value("eightfold.probes().probed")) >= kept);
    await input("quality", 5);
    await page.until("!eightfold.isStale()");
    assert.ok((await page.value("eightfold.probes().probed")) < kept);
    // Exhaustive pictures and overlays have no error to measure.
    await input("quality", 0);
    await page.until("!eightfold.isStale() && eightfold.isSettled()");
    assert.equal(await textOf("accuracy"), "no error found");
    await input("quality", 4);
    await page.click("input[value=points] + span");
    await page.until("!eightfold.isStale() && eightfold.isSettled()");
    await page.click("input[value=none] + span");
    await page.resize(1440, 900);
  },

  async "the poster and its file are named after their scene"() {
    await page.go(site.address);
    const { scenes, length } = await page.value("eightfold.about");
    const shown = await page.value("eightfold.shown()");
    const clock = (seconds) => `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, "0")}`;
    assert.equal(await textOf("position"), `${clock(shown)} / ${clock(length)}`);
    const name = scenes.findLast(({ start }) => start <= shown).name;
    assert.equal(await textOf("scene"), name);
    assert.equal(await page.value("document.querySelector('#scenes [aria-current=true]').textContent"), name);
    assert.equal(await page.value("Number(document.getElementById('time').value)"), shown);
    await page.click("#share");
    assert.match(await page.value("location.hash"), new RegExp(`t=${shown.toFixed(2)}`));
    await page.go(site.address);
    // The start button plays the show from its start.
    await page.click("#start");
    await page.until("eightfold.clock.isPlaying");
    assert.ok((await page.value("eightfold.clock.time()")) < 5);
    await page.until("/^\\d+\\.\\d ± \\d+\\.\\d dB$/.test(document.getElementById('accuracy').textContent)");
    await page.key(" ", "Space");
  },

  async "the governor lowers the quality for slow frames, then the size, and raises them for fast ones"() {
    await page.go(site.address);
    const { qualities } = await page.value("eightfold.about");
    // Simulate frames that take `pause` milliseconds.
    await page.value(`eightfold.frames.draw = async (order) => {
      await new Promise((resolve) => setTimeout(resolve, globalThis.pause));
      return { order, parts: [], points: 0, rays: 0, probed: 0, squares: 0, milliseconds: globalThis.pause };
    }`);
    await page.value("globalThis.pause = 60");
    await page.key(" ", "Space");
    await page.until(`eightfold.view.quality === ${qualities.length - 1}`);
    assert.equal(await textOf("quality-name"), "fastest");
    const sizes = "document.getElementById('size').textContent";
    await page.until(`${sizes} === "528×297"`);
    await page.value("globalThis.pause = 0");
    await page.until(`eightfold.view.quality === 1 && ${sizes} === "1040×585"`);
    // The governor keeps a quality that the viewer chose.
    await page.value("globalThis.pause = 60");
    await page.key("2");
    await sleep(1500);
    assert.equal(await page.value("eightfold.view.quality"), 1);
    assert.ok(!(await page.value("document.getElementById('held').checked")));
    await page.key(" ", "Space");
  },

  async "a click plays, with and without isolation headers, and the picture follows the sound"() {
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
      // Space toggles a focused checkbox.
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
    await page.key("f");
    await page.until("document.fullscreenElement");
    await page.key("Escape");
    await page.until("!document.fullscreenElement");
  },

  async "keys work by position on other keyboard layouts"() {
    await page.go(site.address);
    const { qualities } = await page.value("eightfold.about");
    // Press keys of Russian, Greek and French layouts, and of a Japanese input method.
    for (const key of ["щ", "ο", "Process"]) {
      const overlay = await page.value("eightfold.view.overlay");
      await page.key(key, "KeyO");
      assert.notEqual(await page.value("eightfold.view.overlay"), overlay, key);
    }
    await page.key("ь", "KeyM");
    assert.equal(await page.value("document.getElementById('mute').getAttribute('aria-pressed')"), "true");
    await page.key("а", "KeyF");
    await page.until("document.fullscreenElement?.id === 'stage'");
    await page.key("а", "KeyF");
    await page.until("!document.fullscreenElement");
    await page.key('"', "Digit3");
    assert.equal(await textOf("quality-name"), qualities[2]);
    // Latin letters have their meaning at any position.
    await page.key("m", "Semicolon");
    assert.equal(await page.value("document.getElementById('mute').getAttribute('aria-pressed')"), "false");
    await page.key("p", "KeyM");
    assert.equal(await page.value("document.getElementById('mute').getAttribute('aria-pressed')"), "false");
  },

  async "a held key toggles once, and repeats moves"() {
    await page.go(site.address);
    const { overlay } = await page.value("eightfold.view");
    await page.key("o", "KeyO", false, 5);
    assert.equal(await page.value("eightfold.view.overlay"), "points", `after ${overlay}`);
    await page.key("m", "KeyM", false, 5);
    assert.equal(await page.value("document.getElementById('mute').getAttribute('aria-pressed')"), "true");
    await page.key("f", "KeyF", false, 5);
    await page.until("document.fullscreenElement?.id === 'stage'");
    await page.key("f", "KeyF");
    await page.until("!document.fullscreenElement");
    await page.key(" ", "Space", false, 5);
    await page.until("eightfold.clock.isPlaying");
    await page.key(" ", "Space", false, 4);
    await page.until("!eightfold.clock.isPlaying");
    await page.value("document.getElementById('mute').focus()");
    await page.key("Enter", "Enter", false, 4);
    assert.equal(await page.value("document.getElementById('mute').getAttribute('aria-pressed')"), "false");
    await page.value("document.activeElement.blur()");
    await page.value("eightfold.seek(50)");
    await page.key("ArrowRight", "ArrowRight", false, 3);
    assert.equal(await page.value("eightfold.clock.time()"), 58);
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
    assert.match(await textOf("scene-fault"), new RegExp(`^Line ${line}, column \\d+: spheres\\[0\\].radius is -1; must be `));
    const names = "const names = document.getElementById('scene-name'); names.append(new Option('gone')); names.value = 'gone';";
    await page.value(`(() => { ${names} names.dispatchEvent(new Event("change")); })()`);
    await page.until("document.getElementById('scene-fault').textContent === 'scenes/gone.ron: HTTP status is 404; must be 200.'");
    await input("scene-text", text);
    await page.until("document.getElementById('scene-fault').textContent === '' && eightfold.view.source === 'file' && !eightfold.isStale()");
  },

  async "an address restores the shared view"() {
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

  async "a dead worker is replaced, and the second reported"() {
    const before = await page.frame(show(70, 4, 320, 180));
    for (const worker of [...page.workers]) {
      await page.value("self.postMessage = () => { throw new Error('as if'); }", worker).catch(() => {});
      assert.ok((await page.frame(show(70, 4, 320, 180))).equals(before));
      const isAgain = (await page.value("eightfold.frames.deaths")) > 1;
      assert.match(await textOf("notice"), isAgain ? /^A worker died \(.*as if.*\)\. Another one/ : /^$/);
    }
    // A terminated worker sends no message.
    await page.value("Object.assign(eightfold.frames, { patience: 3000 }).workers[0].terminate()");
    assert.ok((await page.frame(show(70, 4, 320, 180))).equals(before));
    assert.match(await textOf("notice"), /^A worker died \(it does not answer\)\. Another one/);
  },

  async "twenty reloads leave no workers, documents or listeners behind"() {
    const kept = async () => {
      await page.until("document.getElementById('points').textContent.endsWith('%')");
      await page.send("HeapProfiler.collectGarbage");
      return page.send("Memory.getDOMCounters");
    };
    await page.go(site.address);
    const before = await kept();
    page.messages.length = 0;
    for (let turn = 0; turn < 20; turn++) await page.go(site.address);
    await page.until("document.getElementById('points').textContent.endsWith('%')");
    // The browser ends the old workers later.
    const wanted = await page.value("eightfold.frames.workers.length + 1");
    const count = async () => (await browser.send("Target.getTargets", { filter: [{ type: "worker" }] })).targetInfos.length;
    for (let turn = 0; turn < 300 && (await count()) !== wanted; turn++) await new Promise((resolve) => setTimeout(resolve, 100));
    assert.equal(await count(), wanted);
    const after = await kept();
    assert.equal(after.documents, before.documents);
    // The page adds and removes a few nodes, far fewer than a leaked page would.
    for (const kind of ["nodes", "jsEventListeners"]) assert.ok(after[kind] < 1.5 * before[kind], `${kind}: ${before[kind]}, then ${after[kind]}`);
    assert.deepEqual(page.messages, []);
  },

  async "opened from a file, it names the solution"() {
    await page.go(pathToFileURL(join(folder, "index.html")).href, "document.readyState === 'complete'");
    assert.match(await page.value("document.querySelector('main').innerText"), /^Browsers do not play this page from a file\. Run .* and open http/);
    writeFileSync(join(screenshots, "web-file.png"), await page.screenshot());
  },

  async "without SIMD the plain module draws the same bits"() {
    await page.go(site.address);
    const plain = new Browser(["--js-flags=--no-enable-sse4-1"]);
    const simple = await plain.open(site.address);
    assert.equal(await simple.value("eightfold.code.name"), "plain.bin");
    assert.match(await simple.value("document.getElementById('machine').textContent"), /without SIMD/);
    const order = show(62.3, 4, 320, 180);
    assert.ok((await simple.frame(order)).equals(await page.frame(order)));
    assert.deepEqual(simple.messages, []);
    await plain.end();
  },

  async "texts have enough contrast"() {
    await page.go(site.address);
    await page.click("input[value=split] + span");
    await page.value("document.getElementById('notice').textContent = 'A notice'");
    await page.until("eightfold.steps.front().length === 7");
    const contrasts = await page.value(`(${contrastsOf})()`);
    assert.ok(contrasts.length > 60, `${contrasts.length} texts`);
    const faint = contrasts.filter(({ contrast }) => contrast < 4.5).map(({ text, contrast }) => `${text}: ${contrast.toFixed(2)}`);
    assert.deepEqual(faint, []);
  },

  async "the mark on the front moves with the slider"() {
    const place = () => page.value("document.getElementById('present').style.transform + document.querySelector('#present text').textContent");
    const places = [];
    // The front of the page before: to measure it takes half a minute.
    await page.until("eightfold.steps.front().length === 7");
    for (const quality of [0, 1, 4, 7]) {
      await input("quality", quality);
      places.push(await place());
    }
    assert.equal(new Set(places).size, 4, places.join("\n"));
    assert.ok(places[0].includes("exhaustive") && places[3].includes("fastest"));
  },

  async "in forced colours the chosen overlay and scene differ from the others"() {
    await page.send("Emulation.setEmulatedMedia", { features: [{ name: "forced-colors", value: "active" }] });
    await page.go(site.address);
    assert.ok(await page.value(`(${hasMarks})()`));
    await page.click("input[value=split] + span");
    await page.until("!eightfold.isStale()");
    writeFileSync(join(screenshots, "web-forced-colours.png"), await page.screenshot(true));
    await page.send("Emulation.setEmulatedMedia", { features: [] });
  },

  async "it fits a screen and a phone, and rests for reduced motion"() {
    await page.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-reduced-motion", value: "reduce" }] });
    for (const [width, height, scale] of [[1440, 900, 1], [390, 844, 2]]) {
      await page.resize(width, height, scale);
      await page.go(site.address);
      await page.until("document.getElementById('points').textContent.endsWith('%')");
      writeFileSync(join(screenshots, `web-${width}x${height}.png`), await page.screenshot(true));
      assert.equal(await page.value("document.getAnimations().length"), 0);
      assert.equal(await page.value("getComputedStyle(document.getElementById('present')).transitionDuration"), "0s");
      assert.ok(!(await page.value("eightfold.clock.isPlaying")));
      assert.ok(await page.value(`document.documentElement.scrollWidth <= ${width}`), `wider than ${width} pixels`);
    }
    await page.send("Emulation.setEmulatedMedia", { features: [] });
  },

  async "a phone has the full page in its width, large buttons, and no hints for keys and pointers"() {
    await page.send("Emulation.setTouchEmulationEnabled", { enabled: true, maxTouchPoints: 5 });
    for (const [width, height] of [[300, 600], [320, 568], [390, 844], [800, 1280]]) {
      await page.resize(width, height, 2);
      await page.go(site.address);
      // The empty plot has a text.
      assert.ok(await page.value("document.querySelector('#front text').textContent.length > 0"));
      await page.until("document.getElementById('accuracy').textContent.includes('±')");
      // The plot scales, so the narrowest page shows whether it fits.
      if (width === 300) await page.until("eightfold.steps.front().length === 7");
      writeFileSync(join(screenshots, `web-${width}x${height}-touch.png`), await page.screenshot(true));
      const wide = await page.value(`[...document.querySelectorAll("body *")].filter((element) => element.checkVisibility() && element.getBoundingClientRect().right > ${width} + 0.5).map(({ id, tagName }) => id || tagName)`);
      assert.deepEqual(wide, [], `wider than ${width} pixels`);
      assert.equal(await page.value("innerWidth"), width);
      const small = await page.value(`[...document.querySelectorAll("button, select, input, #overlays span")].filter((element) => element.checkVisibility({ opacityProperty: true })).map((element) => [element.id || element.textContent, element.closest(".check")?.getBoundingClientRect() ?? element.getBoundingClientRect()]).filter(([, { width, height }]) => width < 44 || height < 44).map(([name, { width, height }]) => \`\${name} \${width}x\${height}\`)`);
      assert.deepEqual(small, []);
      const hints = await page.value("[...document.querySelectorAll('p')].filter((text) => text.checkVisibility()).map(({ innerText }) => innerText).filter((text) => /\\bkeys?\\b|space|shift|arrow|point at/i.test(text))");
      assert.deepEqual(hints, []);
    }
    await page.send("Emulation.setTouchEmulationEnabled", { enabled: false });
  },

  async "figures fit their cells"() {
    for (const width of [1440, 1200, 1100, 1000, 800, 600, 500, 390, 360, 320, 300]) {
      await page.resize(width, 844);
      const wide = await page.value(`(() => {
        const texts = { rate: "60", milliseconds: "1234.5", points: "100.0 %", rays: "12,345,678", size: "1280×720", accuracy: "49.2 ± 10.4 dB" };
        for (const id in texts) document.getElementById(id).textContent = texts[id];
        return Object.keys(texts).filter((id) => { const cell = document.getElementById(id); return cell.scrollWidth > cell.clientWidth; });
      })()`);
      assert.deepEqual(wide, [], `${width} pixels`);
    }
  },
};

const code = await run(tests, word);
await browser.end();
site.end();
isolated.end();
process.exit(code);
