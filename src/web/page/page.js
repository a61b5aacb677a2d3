// The page: plays the show, and shows what its dials do.

import { Clock } from "./clock.js";
import { explain } from "./explain.js";
import { Editor } from "./editor.js";
import { BAND, Frames, bytesOf } from "./frames.js";
import { Module } from "./module.js";

const get = (id) => document.getElementById(id);

/** The widest picture in the page, and in fullscreen: height follows at 16:9. */
const WIDEST = { page: 1280, fullscreen: 1920 };

/** The frames a second that are held, by the quality and, where the fastest one does not do, by the width: whole or a part of it. */
const HELD = 60;
const WIDTHS = [1, 0.75, 0.5];

/** Frames in a row that have to be late before they get smaller, and that have to be of the default quality before they get larger. */
const LATE = 30;
const EARLY = 120;

/** The second whose picture stands behind the button before anything is played. */
const POSTER = 85;

/** Probes of each frame with which a resting picture is measured on, and the half width of the interval in dB that is enough. */
const PROBES = 8192;
const MARGIN = 0.3;

/** How much brighter an error is shown than it is. */
const ERROR_SCALE = 8;

/** The side of what the loupe shows, in pixels of the picture. */
const LOUPE = 24;

/** What an overlay does with the picture: the brightness of points, of squares and of the picture, and coarse squares. */
const METHODS = { points: [1, 0, 0.25, 0], squares: [0, 0.35, 0.65, 0] };

/** The forms of the button that plays. */
const SHAPES = { play: "M7 4v16l13-8z", pause: "M6 4h4v16H6zM14 4h4v16h-4z" };

/** A module with one instruction of SIMD. */
const SIMD = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11);

const missing = ["WebAssembly", "DecompressionStream", "Worker"].filter((name) => !(name in globalThis));
if (missing.length > 0) throw new Error(`this browser has no ${missing.join(", no ")}`);
const hasSimd = WebAssembly.validate(SIMD);
const faults = [];
const code = (hasSimd && (await tryToLoad("eightfold.bin"))) || (await tryToLoad("plain.bin"));
if (!code) throw new Error(faults.join(", and "));
const module = await Module.of(code.compiled);
const about = JSON.parse(module.text(module.calls.about()));
const canvas = get("picture");
const context = canvas.getContext("2d", { alpha: false });
const frames = new Frames(code.compiled, navigator.hardwareConcurrency || 2, notify);
const clock = new Clock(code.bytes, about.rate);

/** The width of the next frames, unless they have to be smaller; the canvas has the size of the frame that it shows. */
let fullWidth = canvas.width;
const view = { source: "show", edition: 0, quality: about.default, isHeld: true, width: 0, streak: 0, overlay: "none", handle: 0.5, isPoster: true };
/** Whether the next frame has to be drawn although nothing plays. */
let isStale = true;
let isDrawing = false;
/** What has been measured of late. */
const recent = { shown: [], second: 0 };
/** The sums of the probes of frames that have what `key` says in common. */
let probes = { key: "", probed: 0, squares: 0, fourths: 0 };

/** Loads, unpacks and compiles a module. Returns nothing if that fails, and notes why. */
async function tryToLoad(name) {
  try {
    const response = await fetch(new URL(name, import.meta.url)).catch(() => {
      throw new Error(`${name} can't be fetched`);
    });
    if (!response.ok) throw new Error(`${name} is missing (HTTP ${response.status})`);
    const bytes = await unpack(response).catch(() => {
      throw new Error(`${name} is cut short or damaged`);
    });
    return { name, ...bytes };
  } catch ({ message }) {
    faults.push(message);
  }
}

/** Unpacks and compiles a module. Hosts that declare its packing as compressed transfer have had the browser unpack it. */
async function unpack(response) {
  let bytes = await response.arrayBuffer();
  const [first, second] = new Uint8Array(bytes);
  if (first === 0x1f && second === 0x8b) {
    bytes = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
  }
  return { bytes, compiled: await WebAssembly.compile(bytes) };
}

/** Tells something, for some seconds unless it lasts. */
function notify(sentence, isLasting = false) {
  const notice = get("notice");
  notice.textContent = sentence;
  clearTimeout(notify.timer);
  notify.isLasting = isLasting;
  if (!isLasting) notify.timer = setTimeout(() => (notice.textContent = ""), 8000);
}

/** How long what is shown plays, in seconds. */
const length = () => (view.source === "file" ? module.calls.length() : about.length);

/** The frame that is shown at a time, as the dials say. A picture that rests has its full size. */
function order(time) {
  const share = clock.isPlaying && view.isHeld ? WIDTHS[view.width] : 1;
  const width = Math.round((fullWidth * share) / 16) * 16;
  return {
    scene: { kind: view.source, time, isResting: !clock.isPlaying },
    method: METHODS[view.overlay],
    quality: view.quality,
    isReference: false,
    probes: about.probes,
    width,
    height: (width * 9) / 16,
  };
}

/** The time of the frame that is shown. */
const now = () => (view.isPoster ? POSTER : Math.min(clock.time(), length() - 0.01));

/** Puts a frame's columns from one on the canvas. */
function put({ order: { width, height }, parts }, from = 0) {
  if (canvas.width !== width) Object.assign(canvas, { width, height });
  for (const { bytes, first } of parts) {
    const image = new ImageData(bytes, width);
    context.putImageData(image, 0, first, from, 0, width - from, image.height);
  }
}

/** Draws and shows a frame. Returns its figures. */
async function show(time) {
  if (view.overlay !== "split" && view.overlay !== "error") {
    const frame = await frames.draw(order(time));
    put(frame);
    return frame;
  }
  const wanted = order(time);
  const reference = await frames.draw({ ...wanted, isReference: true });
  const frame = await frames.draw(wanted);
  if (view.overlay === "split") {
    put(reference);
    put(frame, Math.round(view.handle * frame.order.width));
  } else {
    const error = bytesOf(frame);
    const exact = bytesOf(reference);
    for (let i = 0; i < error.length; i++) error[i] = i % 4 === 3 ? 255 : ERROR_SCALE * Math.abs(error[i] - exact[i]);
    put({ order: frame.order, parts: [{ bytes: error, first: 0 }] });
  }
  return { ...frame, gain: reference.milliseconds / frame.milliseconds };
}

/** Shows frames for as long as the page is there. */
async function run() {
  for (;;) {
    if (clock.isPlaying && clock.time() >= length()) end();
    if (clock.isPlaying || isStale) {
      isStale = false;
      isDrawing = true;
      const start = performance.now();
      try {
        measure(await show(now()), performance.now() - start);
        if (notify.isLasting) notify("");
      } catch (error) {
        giveUp(error);
      }
      isDrawing = false;
      // What takes longer than a frame of the screen goes on at once.
      if (clock.isPlaying && performance.now() - start > 15 && !document.hidden) continue;
    } else if (!isSettled() && !(view.isPoster && steps.isBusy())) {
      await frames.draw({ ...order(now()), probes: PROBES, seed: Math.floor(probes.probed / PROBES) }).then(probe, giveUp);
    }
    await new Promise(requestAnimationFrame);
  }
}

/** Says why no frame can be drawn, and rests. */
function giveUp(error) {
  notify(`A frame can't be drawn: ${error.why ?? error.message}.`, true);
  clock.pause();
  probes.isFinal = true;
  tell();
}

/** Chooses how the next frame is drawn by how long the last one took. */
function govern(milliseconds) {
  setQuality(module.calls.governed(milliseconds * 1e6));
  const isLate = view.quality === about.qualities.length - 1 && milliseconds > 1000 / HELD;
  const isEarly = view.quality <= about.default;
  view.streak = isLate ? Math.max(view.streak, 0) + 1 : isEarly ? Math.min(view.streak, 0) - 1 : 0;
  if (view.streak < LATE && view.streak > -EARLY) return;
  view.width = Math.min(Math.max(view.width + Math.sign(view.streak), 0), WIDTHS.length - 1);
  view.streak = 0;
}

/** Counts the probes of a frame, anew where it is not of the same picture as the frame before. */
function probe({ order: { scene, quality, width }, probed, squares, fourths }) {
  const key = JSON.stringify([scene.isResting ? scene : scene.kind, quality, width, view.edition]);
  if (key !== probes.key) probes = { key, probed: 0, squares: 0, fourths: 0 };
  probes.probed += probed;
  probes.squares += squares;
  probes.fourths += fourths;
  // Some overlays are not probed, and where every pixel is traced there is no error.
  probes.isFinal = probed === 0 || quality === 0;
  if (!clock.isPlaying) tellAccuracy();
}

/** A figure of the probes by the module: `psnr`, or `margin`, the half width of its interval, in dB. */
function figure(name) {
  const pixels = clock.isPlaying ? Infinity : canvas.width * canvas.height;
  return module.calls[name](probes.probed, probes.squares, probes.fourths, pixels);
}

/** Whether a resting picture has been probed enough: at the latest when each of its pixels was probed. */
function isSettled() {
  const { probed, squares, isFinal } = probes;
  return isFinal || probed >= canvas.width * canvas.height || (squares > 0 && figure("margin") < MARGIN);
}

function tellAccuracy() {
  const found = probes.probed ? "no error found" : "–";
  get("accuracy").textContent = probes.squares ? `${figure("psnr").toFixed(1)} ± ${figure("margin").toFixed(1)} dB` : found;
}

/** Takes in the figures of a frame that was shown, and tells them. */
function measure(frame, milliseconds) {
  const present = performance.now();
  recent.shown = [...recent.shown.filter((time) => present - time < 1000), present];
  if (clock.isPlaying && view.isHeld && !frame.gain) govern(milliseconds);
  probe(frame);
  if (clock.isPlaying && present - recent.second < 250) return;
  recent.second = present;
  get("rate").textContent = clock.isPlaying ? recent.shown.length : "–";
  get("milliseconds").textContent = frame.milliseconds.toFixed(1);
  get("points").textContent = `${((100 * frame.points) / (frame.order.width * frame.order.height)).toFixed(1)} %`;
  get("size").textContent = `${frame.order.width}×${frame.order.height}`;
  get("rays").textContent = Math.round(frame.rays).toLocaleString("en");
  if (clock.isPlaying) {
    tellAccuracy();
    // Frames count less the older they are.
    for (const sum of ["probed", "squares", "fourths"]) probes[sum] /= 1.2;
  }
  const gain = frame.gain ? `, ${frame.gain.toFixed(1)} times as fast` : "";
  get("right-side").textContent = about.qualities[view.quality] + gain;
  tellTime();
}

/** Tells the time and the scene of the picture that is shown. */
function tellTime() {
  const time = now();
  const minutes = (seconds) => `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, "0")}`;
  get("time").value = time;
  get("position").textContent = `${minutes(time)} / ${minutes(length())}`;
  const playing = about.scenes.findLastIndex(({ start }) => start <= time);
  const name = view.source === "file" ? "your scene" : about.scenes[playing].name;
  get("scene").textContent = name;
  get("time").setAttribute("aria-valuetext", `${minutes(time)}, ${name}`);
  [...get("scenes").children].forEach((button, i) => button.setAttribute("aria-current", i === playing));
}

/** Has a frame drawn although nothing plays, and the dials say what is so. */
function update() {
  isStale = true;
  tell();
}

function tell() {
  const { isPlaying } = clock;
  get("start").hidden = !view.isPoster;
  get("time").max = length();
  get("scenes").hidden = view.source === "file";
  get("verdict").hidden = true;
  clock.isMuted = view.source === "file" || get("mute").getAttribute("aria-pressed") === "true";
  get("play").setAttribute("aria-label", isPlaying ? "Pause" : "Play");
  get("play-shape").setAttribute("d", isPlaying ? SHAPES.pause : SHAPES.play);
  get("handle").hidden = get("sides").hidden = view.overlay !== "split";
  get("handle").style.left = `${100 * view.handle}%`;
  get("handle").setAttribute("aria-valuenow", Math.round(100 * view.handle));
  tellTime();
}

function setQuality(quality) {
  if (quality === view.quality) return;
  view.quality = quality;
  get("quality").value = quality;
  get("quality-name").textContent = about.qualities[quality];
  isStale = true;
  steps.setQuality(quality);
}

/** Has a quality kept that somebody chose. */
function keepQuality(quality) {
  get("held").checked = view.isHeld = false;
  setQuality(quality);
}

/** Plays, or pauses. The first time it opens the sound. */
async function toggle() {
  if (clock.isPlaying || clock.isStarting) {
    clock.pause();
  } else {
    view.isPoster = false;
    await clock.open().catch(({ message }) => notify(`There is no sound: ${message}.`));
    if (view.isHeld) module.calls.govern(HELD);
    await clock.play();
    if (!clock.hasSound && !get("notice").textContent) notify("There is no sound: the browser has no device for it.");
  }
  update();
}

/** Says that a browser has stopped the sound, or goes on with it. */
clock.onChange = () => {
  const silence = clock.hasSound ? "" : "There is no sound: its device has stopped.";
  notify(clock.isPlaying ? silence : "The browser has stopped the sound. Play goes on with it.");
  update();
};

/** Goes back to where it began, to start again if it is a scene file. */
function end() {
  clock.seek(0);
  if (view.source === "file") return;
  clock.pause();
  view.isPoster = true;
  update();
}

/** Shows the show, or a scene file. */
function setSource(source) {
  if (source === "file") frames.setFile(editor.text);
  view.edition++;
  if (source !== view.source) clock.seek(0);
  Object.assign(view, { source, isPoster: false });
  update();
}

function seek(time) {
  view.isPoster = false;
  probes.key = "";
  clock.seek(Math.min(Math.max(time, 0), length() - 0.05));
  update();
}

function setOverlay(overlay) {
  view.overlay = overlay;
  document.querySelector(`input[value=${overlay}]`).checked = true;
  update();
}

function moveHandle(share) {
  view.handle = Math.min(Math.max(share, 0), 1);
  update();
}

/** Has frames be as large as the screen has pixels for them. */
function fit() {
  const widest = document.fullscreenElement ? WIDEST.fullscreen : WIDEST.page;
  const width = Math.min(widest, Math.max(160, Math.round((canvas.clientWidth * devicePixelRatio) / 16) * 16));
  // A window that is not shown may have no width.
  if (fullWidth === width || canvas.clientWidth === 0) return;
  fullWidth = width;
  update();
}

function toggleFullscreen() {
  document.fullscreenElement ? document.exitFullscreen() : get("stage").requestFullscreen().catch((error) => notify(error.message));
}

function toggleSound() {
  const isMuted = get("mute").getAttribute("aria-pressed") !== "true";
  get("mute").setAttribute("aria-pressed", isMuted);
  update();
}

/** Saves the picture as it is shown. */
function save() {
  canvas.toBlob((blob) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = `eightfold-${now().toFixed(2)}.png`;
    link.click();
    URL.revokeObjectURL(link.href);
  });
}

/** Puts what is shown into the address, and into the clipboard where the browser allows it. */
async function share() {
  const { quality, overlay, handle } = view;
  const state = { t: now().toFixed(2), quality: about.qualities[quality], show: overlay, split: handle.toFixed(3) };
  if (view.source === "file") state.scene = await editor.packed();
  history.replaceState(null, "", `#${new URLSearchParams(state)}`);
  const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
  notify(copied ? "The address of this picture is in the clipboard." : "The address of this picture is that of the page now.");
}

/** Shows what an address says. */
async function restore() {
  const state = new URLSearchParams(location.hash.slice(1));
  if (state.get("scene")) await editor.unpack(state.get("scene"));
  const quality = about.qualities.indexOf(state.get("quality"));
  if (quality >= 0) keepQuality(quality);
  if (document.querySelector(`input[name=overlay][value="${CSS.escape(state.get("show") ?? "")}"]`)) setOverlay(state.get("show"));
  if (Number.isFinite(parseFloat(state.get("split")))) moveHandle(parseFloat(state.get("split")));
  if (Number.isFinite(parseFloat(state.get("t")))) seek(parseFloat(state.get("t")));
}

/** What became of the squares that a pixel of the picture is in, from the largest to the smallest, and the points traced around it. */
function inspect(x, y) {
  module.begin(order(now()));
  // A band, which is all of what its squares depend on.
  const top = y - (y % BAND);
  return JSON.parse(module.text(module.calls.inspect(top, top + BAND, x, y)));
}

/** Tells beside a place of the canvas what became of the squares there, with a loupe. */
function explainSquare({ offsetX, offsetY }) {
  const verdict = get("verdict");
  const scale = canvas.width / canvas.clientWidth;
  view.place = { offsetX, offsetY };
  const [x, y] = [offsetX, offsetY].map((offset) => Math.floor(offset * scale));
  const { squares, points } = inspect(x, y);
  const sentences = squares.map(({ w, h, what }) => `${w}×${h} ${what}`);
  verdict.lastChild.textContent = sentences.join("\n") || "Every pixel is traced here.";
  drawLoupe(x, y, squares, points);
  verdict.hidden = false;
  // Beside the pointer, on the side where there is room.
  const beside = (offset, size, room) => (offset + 16 + size > room ? Math.max(offset - 16 - size, 0) : offset + 16);
  verdict.style.left = `${beside(offsetX, verdict.offsetWidth, canvas.clientWidth)}px`;
  verdict.style.top = `${beside(offsetY, verdict.offsetHeight, canvas.clientHeight)}px`;
}

/** Moves the loupe by so many squares, at first from the middle of the picture. */
function moveLoupe(right, down) {
  const { clientWidth, clientHeight } = canvas;
  const square = (8 * clientWidth) / canvas.width;
  const { offsetX, offsetY } = view.place ?? { offsetX: clientWidth / 2, offsetY: clientHeight / 2 };
  const within = (offset, room) => Math.min(Math.max(offset, 0), room - 1);
  explainSquare({ offsetX: within(offsetX + right * square, clientWidth), offsetY: within(offsetY + down * square, clientHeight) });
}

/** Shows the pixels around one, with the squares that it is in and the points that were traced. */
function drawLoupe(x, y, squares, points) {
  const loupe = get("loupe").getContext("2d");
  const zoom = loupe.canvas.width / LOUPE;
  // All its rows are of the band of which the points are known.
  const left = Math.min(Math.max(x - LOUPE / 2, 0), canvas.width - LOUPE);
  const top = y - (y % BAND) + Math.min(Math.max((y % BAND) - LOUPE / 2, 0), BAND - LOUPE);
  loupe.setTransform(1, 0, 0, 1, 0, 0);
  loupe.imageSmoothingEnabled = false;
  loupe.clearRect(0, 0, loupe.canvas.width, loupe.canvas.height);
  loupe.drawImage(canvas, left, top, LOUPE, LOUPE, 0, 0, loupe.canvas.width, loupe.canvas.height);
  loupe.setTransform(zoom, 0, 0, zoom, -left * zoom, -top * zoom);
  loupe.lineWidth = 2 / zoom;
  squares.forEach(({ x, y, w, h }, i) => {
    loupe.strokeStyle = i === squares.length - 1 ? "#e2a65a" : "#fffa";
    loupe.strokeRect(x, y, w, h);
  });
  loupe.fillStyle = "#fff";
  for (const [x, y] of points) loupe.fillRect(x + 0.35, y + 0.35, 0.3, 0.3);
}

/** What keys do, wherever they do nothing else. */
const KEYS = {
  " ": toggle,
  f: toggleFullscreen,
  m: toggleSound,
  o: () => {
    const overlays = [...document.querySelectorAll("input[name=overlay]")].map(({ value }) => value);
    setOverlay(overlays[(overlays.indexOf(view.overlay) + 1) % overlays.length]);
  },
  // Most browsers end fullscreen by themselves.
  Escape: () => (document.fullscreenElement ? document.exitFullscreen() : clock.isPlaying && toggle()),
  ArrowLeft: () => seek(now() - 2),
  ArrowRight: () => seek(now() + 2),
};

/** What they do together with the shift key, in a picture that rests. */
const SHIFTED = {
  ArrowLeft: () => moveLoupe(-1, 0),
  ArrowRight: () => moveLoupe(1, 0),
  ArrowUp: () => moveLoupe(0, -1),
  ArrowDown: () => moveLoupe(0, 1),
};

/** The name of a key. On layouts without Latin letters or digits it is that at the key's place. */
function nameOf({ key, code }) {
  const [, place] = /^(?:Key|Digit)(.)$/.exec(code) ?? [];
  const name = code === "Space" ? " " : place && !/^[a-z0-9]$/i.test(key) ? place : key;
  return name.length === 1 ? name.toLowerCase() : name;
}

function listen() {
  addEventListener("keydown", (event) => {
    const key = nameOf(event);
    const { target, shiftKey, ctrlKey, altKey, metaKey } = event;
    // A key that is held does once what toggles something, and so does a button.
    const isAgain = event.repeat && !key.startsWith("Arrow");
    if (isAgain && key === "Enter" && target.matches("button")) event.preventDefault();
    // What has the focus has keys of its own.
    const own = key === " " ? "button, [type=checkbox]" : key.startsWith("Arrow") && "input, [role=slider]";
    const isUsed = target.matches("textarea, select") || (own && target.matches(own));
    if (isUsed || ctrlKey || altKey || metaKey) return;
    const quality = Number(key) - 1;
    const shifted = shiftKey && !clock.isPlaying && SHIFTED[key];
    const action = about.qualities[quality] ? () => keepQuality(quality) : shifted || KEYS[key];
    if (!action) return;
    event.preventDefault();
    if (!isAgain) action();
  });
  for (const [id, action] of Object.entries({ start: toggle, play: toggle, picture: toggle, mute: toggleSound, fullscreen: toggleFullscreen, save, share })) {
    get(id).addEventListener("click", action);
  }
  // A button that was clicked leaves the keys to the page.
  addEventListener("click", ({ detail, target }) => detail && target.closest("button")?.blur());
  get("time").addEventListener("input", ({ target }) => seek(Number(target.value)));
  get("quality").addEventListener("input", ({ target }) => keepQuality(Number(target.value)));
  get("held").addEventListener("change", ({ target }) => {
    view.isHeld = target.checked;
    module.calls.govern(HELD);
  });
  get("picture").addEventListener("pointermove", (event) => {
    get("verdict").hidden = true;
    clearTimeout(inspect.timer);
    if (!clock.isPlaying && event.pointerType === "mouse") inspect.timer = setTimeout(() => explainSquare(event), 150);
  });
  get("picture").addEventListener("pointerleave", () => {
    get("verdict").hidden = true;
    clearTimeout(inspect.timer);
  });
  get("back").addEventListener("click", () => setSource("show"));
  get("overlays").addEventListener("change", ({ target }) => setOverlay(target.value));
  get("handle").addEventListener("pointerdown", ({ target, pointerId }) => target.setPointerCapture(pointerId));
  get("handle").addEventListener("pointermove", ({ target, pointerId, clientX }) => {
    const { left, width } = canvas.getBoundingClientRect();
    if (target.hasPointerCapture(pointerId)) moveHandle((clientX - left) / width);
  });
  get("handle").addEventListener("keydown", ({ key }) => {
    const step = { ArrowLeft: -0.02, ArrowRight: 0.02 }[key];
    if (step) moveHandle(view.handle + step);
  });
  addEventListener("hashchange", restore);
  new ResizeObserver(fit).observe(canvas);
}

/** Fills in what the module tells of the show. */
function furnish() {
  get("fullscreen").hidden = !document.fullscreenEnabled;
  get("quality").max = about.qualities.length - 1;
  get("quality").value = view.quality;
  get("quality-name").textContent = about.qualities[view.quality];
  about.scenes.forEach(({ name, start }, i) => {
    const button = document.createElement("button");
    button.textContent = name;
    button.title = name;
    button.style.flexGrow = (about.scenes[i + 1]?.start ?? about.length) - start;
    button.addEventListener("click", () => seek(start));
    get("scenes").append(button);
  });
  const slow = hasSimd ? `without SIMD, since ${faults[0]}` : "without SIMD, which this browser lacks and which makes it four times as fast";
  const lanes = code.name === "plain.bin" ? slow : "by SIMD128";
  get("machine").textContent = `Drawn by ${frames.workers.length} workers, ${lanes}. Nothing is sent anywhere.`;
}

const steps = explain({
  about,
  frames: new Frames(code.compiled, 1, notify),
  quality: () => view.quality,
  isIdle: () => !clock.isPlaying,
  // Probes would take processors from what is timed.
  isQuiet: () => view.isPoster || isSettled(),
});
const editor = new Editor(module, () => setSource("file"));
furnish();
listen();
fit();
update();
await restore();
notify(faults.length > 0 ? `The show is slower than it could be: ${faults[0]}.` : "");
// What tests ask.
globalThis.eightfold = { about, clock, code, frames, view, steps, seek, inspect, isSettled, probes: () => probes, shown: now, isStale: () => isStale || isDrawing };
run();
