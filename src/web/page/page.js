// The page: plays the show and handles its controls.

import { Clock } from "./clock.js";
import { explain } from "./explain.js";
import { Editor } from "./editor.js";
import { Figures, PROBES } from "./figures.js";
import { BAND, Frames, bytesOf } from "./frames.js";
import { Module } from "./module.js";
import { Mean, now } from "./times.js";

const get = (id) => document.getElementById(id);

/** The maximum width of the picture, in the page and in fullscreen; the aspect ratio is 16:9. */
const WIDEST = { page: 1280, fullscreen: 1920 };

/** The frame rate to hold. If the fastest quality is too slow, frames shrink to these fractions of the width. */
const HELD = 60;
const WIDTHS = [1, 0.75, 0.5];

/** Late frames in a row before the size shrinks, and frames of default quality in a row before it grows. */
const LATE = 30;
const EARLY = 120;

/** The show's time, in seconds, of the picture behind the start button. */
const POSTER = 85;

/** The quality of a resting picture, unless the viewer chose one: `finest`. */
const RESTING = 1;

/** Probes of other frames, a multiple of the library's: they take 1 % of a frame's time. */
const LIVE = 4;

/** The factor on displayed errors. */
const ERROR_SCALE = 8;

/** The side of the loupe's region, in pixels of the picture. */
const LOUPE = 24;

/** The overlays: the brightness of points, squares and picture, and the coarseness. */
const METHODS = { points: [1, 0, 0.25, 0], squares: [0, 0.35, 0.65, 0] };

/** The shapes of the play button. */
const SHAPES = { play: "M7 4v16l13-8z", pause: "M6 4h4v16H6zM14 4h4v16h-4z" };

/** A module with one SIMD instruction. */
const SIMD = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11);

const missing = ["WebAssembly", "DecompressionStream", "Worker"].filter((name) => !(name in globalThis));
if (missing.length > 0) throw new Error(`${missing.join(" and ")} is missing from this browser`);
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

/** The maximum width of the next frames; the canvas has the size of its frame. */
let fullWidth = canvas.width;
const view = { source: "show", edition: 0, quality: about.default, draft: about.default, isHeld: true, width: 0, streak: 0, overlay: "none", handle: 0.5, isPoster: true };
/** Whether to draw a frame although the show is paused. */
let isStale = true;
let isDrawing = false;
/** When figures were last shown. */
let told = 0;
const figures = new Figures(module.calls, () => (clock.isPlaying ? Infinity : canvas.width * canvas.height));

/** Loads, unpacks and compiles a module. On failure returns nothing and records the reason. */
async function tryToLoad(name) {
  try {
    const response = await fetch(new URL(name, import.meta.url)).catch(() => {
      throw new Error(`${name} can't be fetched`);
    });
    if (!response.ok) throw new Error(`${name}: HTTP status is ${response.status}; must be 200`);
    const bytes = await unpack(response).catch(() => {
      throw new Error(`${name} is cut short or damaged`);
    });
    return { name, ...bytes };
  } catch ({ message }) {
    faults.push(message);
  }
}

/** Unpacks and compiles a module. If the host declares its compression, the browser has already unpacked it. */
async function unpack(response) {
  let bytes = await response.arrayBuffer();
  const [first, second] = new Uint8Array(bytes);
  if (first === 0x1f && second === 0x8b) {
    bytes = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
  }
  return { bytes, compiled: await WebAssembly.compile(bytes) };
}

/** Shows a message, for some seconds or permanently. */
function notify(sentence, isLasting = false) {
  const notice = get("notice");
  notice.textContent = sentence;
  clearTimeout(notify.timer);
  notify.isLasting = isLasting;
  if (!isLasting) notify.timer = setTimeout(() => (notice.textContent = ""), 8000);
}

/** Returns the length of the show or the scene file in seconds. */
const length = () => (view.source === "file" ? module.calls.length() : about.length);

/** Returns the frame to draw at a time, by the controls. A resting picture has its full size. */
function order(time) {
  const share = clock.isPlaying && view.isHeld ? WIDTHS[view.width] : 1;
  const width = Math.round((fullWidth * share) / 16) * 16;
  return {
    scene: { kind: view.source, time, isResting: !clock.isPlaying },
    method: METHODS[view.overlay],
    quality: view.quality,
    isReference: false,
    probes: LIVE * about.probes,
    width,
    height: (width * 9) / 16,
  };
}

/** The time of the frame that is shown. */
const shown = () => (view.isPoster ? POSTER : Math.min(clock.time(), length() - 0.01));

/** Puts a frame on the canvas, from the column `from` on. */
function put({ order: { width, height }, parts }, from = 0) {
  if (canvas.width !== width) Object.assign(canvas, { width, height });
  for (const { bytes, first } of parts) {
    const image = new ImageData(bytes, width);
    context.putImageData(image, 0, first, from, 0, width - from, image.height);
  }
}

/** Draws the frame of now, and its `reference` if the overlay compares them. */
async function draw(change = {}) {
  const { overlay } = view;
  const wanted = { ...order(shown()), ...change };
  const reference = ["split", "error"].includes(overlay) && (await frames.draw({ ...wanted, isReference: true }));
  return { ...(await frames.draw(wanted)), overlay, reference };
}

/** Shows a frame. */
function show({ overlay, reference, ...frame }) {
  if (overlay === "split") {
    put(reference);
    put(frame, Math.round(view.handle * frame.order.width));
  } else if (overlay === "error") {
    const error = bytesOf(frame);
    const exact = bytesOf(reference);
    for (let i = 0; i < error.length; i++) error[i] = i % 4 === 3 ? 255 : ERROR_SCALE * Math.abs(error[i] - exact[i]);
    put({ order: frame.order, parts: [{ bytes: error, first: 0 }] });
  } else {
    put(frame);
  }
}

/** Returns whether a resting picture is still to be drawn at its quality. */
const isDraft = () => !clock.isPlaying && view.isHeld && view.quality !== RESTING;

/** Shows frames as long as the page exists. */
async function run() {
  for (;;) {
    if (clock.isPlaying && clock.time() >= length()) end();
    if (clock.isPlaying || isStale) {
      isStale = false;
      isDrawing = true;
      const start = now();
      try {
        const frame = await draw();
        show(frame);
        measure(frame, now() - start);
        if (notify.isLasting) notify("");
      } catch (error) {
        giveUp(error);
      }
      isDrawing = false;
      // Do not wait after late frames.
      if (clock.isPlaying && figures.busy.value > 15 && !document.hidden) continue;
    } else if (isDraft()) {
      setQuality(RESTING);
    } else if (!figures.isTimed) {
      await draw({ probes: 0 }).then(time, giveUp);
    } else if (!figures.isSettled && !(view.isPoster && figures.isKnown && steps.isBusy())) {
      await frames.draw({ ...order(shown()), probes: PROBES, seed: Math.floor(figures.probes.probed / PROBES) }).then(probe, giveUp);
    }
    await new Promise(requestAnimationFrame);
  }
}

/** Shows why no frame can be drawn, and pauses. */
function giveUp(error) {
  notify(`A frame can't be drawn: ${error.why ?? error.message}.`, true);
  clock.pause();
  figures.end();
  tell();
}

/** Chooses the next frame's quality and size by the time of the last ones. */
function govern(milliseconds) {
  setQuality(module.calls.governed(milliseconds * 1e6));
  view.draft = view.quality;
  const isLate = view.quality === about.qualities.length - 1 && milliseconds > 1000 / HELD;
  const isEarly = view.quality <= about.default;
  view.streak = isLate ? Math.max(view.streak, 0) + 1 : isEarly ? Math.min(view.streak, 0) - 1 : 0;
  if (view.streak < LATE && view.streak > -EARLY) return;
  view.width = Math.min(Math.max(view.width + Math.sign(view.streak), 0), WIDTHS.length - 1);
  view.streak = 0;
  figures.busy = new Mean();
}

/** Names the picture of a frame, whose figures start anew with it. */
const keyOf = ({ scene, quality, width }) => JSON.stringify([scene.isResting ? scene : scene.kind, quality, width, view.edition]);

/** Adds a frame's times. */
function time(frame) {
  figures.time(keyOf(frame.order) + frame.overlay, frame);
  if (!clock.isPlaying) tellTimes();
}

function tellTimes() {
  get("milliseconds").textContent = figures.milliseconds;
  get("right-side").textContent = about.qualities[view.quality] + figures.gain;
}

/** Adds a frame's probes. */
function probe(frame) {
  figures.probe(keyOf(frame.order), frame);
  if (!clock.isPlaying) tellAccuracy();
}

const tellAccuracy = () => (get("accuracy").textContent = figures.accuracy);

/** Records and shows a frame's figures. */
function measure(frame, milliseconds) {
  if (clock.isPlaying) {
    figures.show();
    figures.busy.add(milliseconds);
    if (view.isHeld && !frame.reference && figures.busy.value > 0) govern(figures.busy.value);
  } else {
    figures.shown = [];
  }
  time(frame);
  probe(frame);
  const present = now();
  if (clock.isPlaying && present - told < 250) return;
  told = present;
  get("rate").textContent = figures.rate;
  get("points").textContent = `${((100 * frame.points) / (frame.order.width * frame.order.height)).toFixed(1)} %`;
  get("size").textContent = `${frame.order.width}×${frame.order.height}`;
  get("rays").textContent = Math.round(frame.rays).toLocaleString("en");
  if (clock.isPlaying) {
    tellTimes();
    tellAccuracy();
    figures.age();
  }
  tellTime();
}

/** Shows the picture's time and scene. */
function tellTime() {
  const time = shown();
  const minutes = (seconds) => `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, "0")}`;
  get("time").value = time;
  get("position").textContent = `${minutes(time)} / ${minutes(length())}`;
  const playing = about.scenes.findLastIndex(({ start }) => start <= time);
  const name = view.source === "file" ? "your scene" : about.scenes[playing].name;
  get("scene").textContent = name;
  get("time").setAttribute("aria-valuetext", `${minutes(time)}, ${name}`);
  [...get("scenes").children].forEach((button, i) => button.setAttribute("aria-current", i === playing));
}

/** Draws a frame although the show is paused, and updates the controls. */
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
  tellQuality();
  isStale = true;
  figures.busy = new Mean();
  steps.setQuality(quality);
}

function tellQuality() {
  const name = about.qualities[view.quality];
  get("quality").value = view.quality;
  get("quality").setAttribute("aria-valuetext", name);
  get("quality-name").textContent = name;
}

/** Draws a resting picture first at the quality that was fast enough, as the viewer may be scrubbing or typing. */
function sketch() {
  if (view.isHeld && !clock.isPlaying) setQuality(view.draft);
}

/** Holds the quality that the viewer chose. */
function keepQuality(quality) {
  get("held").checked = view.isHeld = false;
  setQuality(quality);
}

/** Plays or pauses. The first call opens the sound. */
async function toggle() {
  if (clock.isPlaying || clock.isStarting) {
    clock.pause();
  } else {
    view.isPoster = false;
    notify("");
    await clock.open().catch(({ message }) => notify(`Sound is off: ${message}.`));
    if (view.isHeld) module.calls.govern(HELD);
    await clock.play();
    if (!clock.hasSound && !get("notice").textContent) notify(`Sound is off: ${clock.why}.`);
  }
  update();
}

/** Shows that the browser has stopped or resumed the sound. */
clock.onChange = () => {
  const silence = clock.hasSound ? "" : `Sound is off: ${clock.why}.`;
  notify(clock.isPlaying ? silence : "The browser stopped the sound; press Play to continue.");
  update();
};

/** Ends the show, and returns to the first picture; a scene file starts again. */
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
  sketch();
  update();
}

function seek(time) {
  view.isPoster = false;
  figures.probes.key = "";
  clock.seek(Math.min(Math.max(time, 0), length() - 0.05));
  sketch();
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

/** Sets the frames' size to the screen's pixels. */
function fit() {
  const widest = document.fullscreenElement ? WIDEST.fullscreen : WIDEST.page;
  const width = Math.min(widest, Math.max(160, Math.round((canvas.clientWidth * devicePixelRatio) / 16) * 16));
  // A hidden window may have no width.
  if (fullWidth === width || canvas.clientWidth === 0) return;
  fullWidth = width;
  update();
}

function toggleFullscreen() {
  document.fullscreenElement ? document.exitFullscreen() : get("stage").requestFullscreen().catch(({ message }) => notify(`Fullscreen can't be opened: ${message}.`));
}

function toggleSound() {
  const isMuted = get("mute").getAttribute("aria-pressed") !== "true";
  get("mute").setAttribute("aria-pressed", isMuted);
  update();
}

/** Saves the displayed picture. */
function save() {
  canvas.toBlob((blob) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = `eightfold-${shown().toFixed(2)}.png`;
    link.click();
    URL.revokeObjectURL(link.href);
  });
}

/** Writes the view to the address, and to the clipboard if the browser allows it. */
async function share() {
  const { quality, isHeld, overlay, handle } = view;
  const state = { t: shown().toFixed(2), show: overlay, split: handle.toFixed(3) };
  if (!isHeld) state.quality = about.qualities[quality];
  if (view.source === "file" || editor.hasMistake) state.scene = await editor.packed();
  history.replaceState(null, "", `#${new URLSearchParams(state)}`);
  const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
  notify(copied ? "The address of this picture is in the clipboard." : "The address bar has the address of this picture.");
}

/** Shows the view of an address. */
async function restore() {
  const state = new URLSearchParams(location.hash.slice(1));
  if (state.get("scene")) await editor.unpack(state.get("scene"));
  const quality = about.qualities.indexOf(state.get("quality"));
  if (quality >= 0) keepQuality(quality);
  if (document.querySelector(`input[name=overlay][value="${CSS.escape(state.get("show") ?? "")}"]`)) setOverlay(state.get("show"));
  if (Number.isFinite(parseFloat(state.get("split")))) moveHandle(parseFloat(state.get("split")));
  if (Number.isFinite(parseFloat(state.get("t")))) seek(parseFloat(state.get("t")));
}

/** Returns the squares that contain a pixel, from the largest to the smallest, and the traced points around it. */
function inspect(x, y) {
  module.begin(order(shown()));
  // A band determines its squares.
  const top = y - (y % BAND);
  return JSON.parse(module.text(module.calls.inspect(top, top + BAND, x, y)));
}

/** Explains the squares at a position of the canvas next to it, with a loupe. */
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
  // Next to the pointer, where it fits.
  const beside = (offset, size, room) => (offset + 16 + size > room ? Math.max(offset - 16 - size, 0) : offset + 16);
  verdict.style.left = `${beside(offsetX, verdict.offsetWidth, canvas.clientWidth)}px`;
  verdict.style.top = `${beside(offsetY, verdict.offsetHeight, canvas.clientHeight)}px`;
}

/** Moves the loupe by a number of squares, initially from the centre. */
function moveLoupe(right, down) {
  clearTimeout(inspect.timer);
  const { clientWidth, clientHeight } = canvas;
  const square = (8 * clientWidth) / canvas.width;
  const { offsetX, offsetY } = view.place ?? { offsetX: clientWidth / 2, offsetY: clientHeight / 2 };
  const within = (offset, room) => Math.min(Math.max(offset, 0), room - 1);
  explainSquare({ offsetX: within(offsetX + right * square, clientWidth), offsetY: within(offsetY + down * square, clientHeight) });
}

/** Draws the pixels around (x, y), with its squares and the traced points. */
function drawLoupe(x, y, squares, points) {
  const loupe = get("loupe").getContext("2d");
  const zoom = loupe.canvas.width / LOUPE;
  // Keep its rows in the inspected band.
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

/** The keys that the focused element does not use. */
const KEYS = {
  " ": toggle,
  f: toggleFullscreen,
  m: toggleSound,
  o: () => {
    const overlays = [...document.querySelectorAll("input[name=overlay]")].map(({ value }) => value);
    setOverlay(overlays[(overlays.indexOf(view.overlay) + 1) % overlays.length]);
  },
  // Most browsers leave fullscreen by themselves.
  Escape: () => (document.fullscreenElement ? document.exitFullscreen() : clock.isPlaying && toggle()),
  ArrowLeft: () => seek(shown() - 2),
  ArrowRight: () => seek(shown() + 2),
};

/** The keys with Shift, in a resting picture. */
const SHIFTED = {
  ArrowLeft: () => moveLoupe(-1, 0),
  ArrowRight: () => moveLoupe(1, 0),
  ArrowUp: () => moveLoupe(0, -1),
  ArrowDown: () => moveLoupe(0, 1),
};

/** Returns a key's name. On layouts without Latin letters or digits it is the one at the key's position. */
function nameOf({ key, code }) {
  const [, place] = /^(?:Key|Digit)(.)$/.exec(code) ?? [];
  const name = code === "Space" ? " " : place && !/^[a-z0-9]$/i.test(key) ? place : key;
  return name.length === 1 ? name.toLowerCase() : name;
}

function listen() {
  addEventListener("keydown", (event) => {
    const key = nameOf(event);
    const { target, shiftKey, ctrlKey, altKey, metaKey } = event;
    // Held keys and buttons toggle once.
    const isAgain = event.repeat && !key.startsWith("Arrow");
    if (isAgain && key === "Enter" && target.matches("button")) event.preventDefault();
    // The focused element has its own keys.
    const arrows = shiftKey ? "[type=range], [role=slider]" : "input, [role=slider]";
    const own = key === " " ? "button, [type=checkbox]" : key.startsWith("Arrow") && arrows;
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
  // A clicked button returns the keys to the page.
  addEventListener("click", ({ detail, target }) => detail && target.closest("button")?.blur());
  get("time").addEventListener("input", ({ target }) => seek(Number(target.value)));
  get("quality").addEventListener("input", ({ target }) => keepQuality(Number(target.value)));
  get("held").addEventListener("change", ({ target }) => {
    view.isHeld = target.checked;
    module.calls.govern(HELD);
  });
  get("picture").addEventListener("pointermove", (event) => {
    // Chromium repeats the last move, rounded, when the layout changes.
    const { clientX, clientY } = inspect.pointer ?? {};
    if (Math.abs(event.clientX - clientX) < 1 && Math.abs(event.clientY - clientY) < 1) return;
    inspect.pointer = event;
    get("verdict").hidden = true;
    clearTimeout(inspect.timer);
    if (!clock.isPlaying && event.pointerType === "mouse") inspect.timer = setTimeout(() => explainSquare(event), 150);
  });
  get("picture").addEventListener("pointerleave", () => {
    get("verdict").hidden = true;
    clearTimeout(inspect.timer);
  });
  get("back").addEventListener("click", () => {
    editor.hasMistake = false;
    setSource("show");
  });
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
  // A hidden page shows no frames.
  document.addEventListener("visibilitychange", () => (figures.shown = []));
  new ResizeObserver(fit).observe(canvas);
}

/** Fills in the module's constants. */
function furnish() {
  get("fullscreen").hidden = !document.fullscreenEnabled;
  get("quality").max = about.qualities.length - 1;
  tellQuality();
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
  // Probes would disturb the timings.
  isQuiet: () => (view.isPoster && !isDraft() && figures.isKnown) || figures.isSettled,
});
const editor = new Editor(module, () => setSource("file"));
furnish();
listen();
fit();
update();
await restore();
notify(faults.length > 0 ? `The show is slower than it could be: ${faults[0]}.` : "");
// For tests.
globalThis.eightfold = { about, clock, code, frames, view, steps, seek, inspect, isSettled: () => figures.isSettled, probes: () => figures.probes, shown, isStale: () => isStale || isDrawing || isDraft() };
run();
