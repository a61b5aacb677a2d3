// Firefox without a screen, by its own protocol, Marionette, over a socket: node firefox.mjs SITE INTRO. It holds that the page loads,
// draws the bits of --still, turns its dials, tells faults of a scene, and plays where there is no sound; it prints a line for each test,
// and fails if one does.

import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { serve } from "./chromium.mjs";

const PORT = 2828;
const profile = mkdtempSync(join(tmpdir(), "eightfold-firefox-"));
writeFileSync(join(profile, "user.js"), `user_pref("media.autoplay.default", 0);\nuser_pref("marionette.port", ${PORT});\n`);
const firefox = spawn("firefox-esr", ["--headless", "--no-remote", "--marionette", "--profile", profile], { stdio: "ignore" });
const socket = await (async () => {
  for (let turn = 0; turn < 300; turn++) {
    const socket = connect(PORT, "127.0.0.1");
    const isThere = await new Promise((resolve) => socket.once("connect", () => resolve(true)).once("error", () => resolve(false)));
    if (isThere) return socket;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error("Firefox does not answer within half a minute");
})();

// A message is the length of its text, a colon, and the text: a list of its kind, number, error, and result.
const replies = new Map();
let received = Buffer.alloc(0);
socket.on("data", (data) => {
  received = Buffer.concat([received, data]);
  for (let colon = received.indexOf(":"); colon > 0; colon = received.indexOf(":")) {
    const end = colon + 1 + Number(received.subarray(0, colon));
    if (received.length < end) return;
    const message = JSON.parse(received.subarray(colon + 1, end));
    received = received.subarray(end);
    if (!Array.isArray(message)) continue;
    const [, number, error, result] = message;
    error ? replies.get(number).reject(new Error(error.message)) : replies.get(number).resolve(result);
  }
});

let last = 0;
function send(command, parameters = {}) {
  const text = JSON.stringify([0, ++last, `WebDriver:${command}`, parameters]);
  socket.write(`${Buffer.byteLength(text)}:${text}`);
  return new Promise((resolve, reject) => replies.set(last, { resolve, reject }));
}

/** The value of an expression in the page, which may be a promise. */
const value = async (expression) => (await send("ExecuteAsyncScript", {
  script: `const done = arguments[arguments.length - 1]; Promise.resolve().then(() => window.eval(${JSON.stringify(expression)})).then(done, (error) => done("FAILED " + error));`,
  args: [],
  sandbox: null,
})).value;

async function until(expression) {
  for (let turn = 0; turn < 600; turn++) {
    if ((await value(expression)) === true) return;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error(`not within a minute: ${expression}`);
}

const [folder, intro] = process.argv.slice(2);
const site = await serve(folder);
let code = 0;
try {
  await send("NewSession");
  await send("Navigate", { url: site.address });
  await until("globalThis.eightfold !== undefined && document.getElementById('points').textContent.endsWith('%')");
  assert.equal(await value("document.getElementById('notice').textContent"), "");
  console.log("ok      the page loads in Firefox");

  const order = { scene: { kind: "show", time: 62.3 }, quality: 4, isReference: false, width: 641, height: 363 };
  const letters = await value(`(async () => {
    const { bytesOf } = await import("${site.address}frames.js");
    const bytes = bytesOf(await eightfold.frames.draw(${JSON.stringify(order)})).filter((_, i) => i % 4 < 3);
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  })()`);
  const still = execFileSync(intro, ["--still", "62.3", "--size", "641x363", "--isa", "sse2"], { maxBuffer: 1e8 });
  assert.ok(Buffer.from(letters, "base64").equals(still.subarray(still.length - 3 * 641 * 363)), letters.slice(0, 200));
  console.log("ok      a frame in Firefox has the bits of --still");

  const input = (id, text) => value(`(() => { const input = document.getElementById("${id}"); input.value = ${JSON.stringify(text)}; input.dispatchEvent(new Event("input", { bubbles: true })); return input.value; })()`);
  const share = async (quality) => {
    await input("quality", quality);
    await until(`!eightfold.isStale() && eightfold.view.quality === ${quality}`);
    return parseFloat(await value("document.getElementById('points').textContent"));
  };
  const [all, few] = [await share(0), await share(7)];
  assert.ok(all >= 99 && few < 40, `${all} % and ${few} %`);
  console.log("ok      the slider changes what is traced in Firefox");

  await until("document.getElementById('scene-text').value.includes('spheres')");
  const text = await value("document.getElementById('scene-text').value");
  await input("scene-text", text.replace("radius: 1.0", "radius: -1.0"));
  const line = text.split("\n").findIndex((line) => line.includes("radius: 1.0")) + 1;
  assert.match(await value("document.getElementById('scene-fault').textContent"), new RegExp(`^Line ${line}, column \\d+: `));
  console.log("ok      a faulty scene shows its line and column in Firefox");

  const { value: button } = await send("FindElement", { using: "css selector", value: "#start" });
  await send("ElementClick", { id: Object.values(button)[0] });
  await until("eightfold.clock.isPlaying && eightfold.clock.time() > 1");
  console.log("ok      a click plays in Firefox, which has no device for sound here");
} catch (error) {
  console.log(`FAILED  ${error.stack}`);
  code = 1;
}
firefox.kill();
await new Promise((resolve) => firefox.once("exit", resolve));
rmSync(profile, { recursive: true, force: true, maxRetries: 9, retryDelay: 100 });
process.exit(code);
