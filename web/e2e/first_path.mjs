// Measures how soon the first path of a long program is on the screen: KADR=…/kadr node e2e/first_path.mjs [BLOCKS…].
// The time is from the question `open` to a picture that shows some of the path.
import { closeSync, mkdtempSync, openSync, rmSync, writeSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { browser, until } from "./browser.mjs";
import { real } from "./server.mjs";

const sizes = process.argv.length > 2 ? process.argv.slice(2).map(Number) : [100_000, 1_000_000];
const folder = mkdtempSync(join(tmpdir(), "kadr-long-"));

function write_program(name, blocks) {
  const file = openSync(join(folder, name), "w");
  let text = "G21 G90 G17\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F500\n",
    seed = 1;
  for (let n = 0; n < blocks; n++) {
    seed = (seed * 16807) % 2147483647;
    text += `G1 X${((n % 1000) / 10).toFixed(3)} Y${(Math.floor(n / 1000) / 10).toFixed(3)} Z${(-1 + (0.3 * seed) / 2147483647).toFixed(3)}\n`;
    if (text.length > 1e6) {
      writeSync(file, text);
      text = "";
    }
  }
  writeSync(file, `${text}M30\n`);
  closeSync(file);
}

/// Runs in the page, before its own script: records when `open` was sent, its answer came, frames came, lines were
/// first drawn; and each long task.
function listen() {
  const w = (window.first = { tasks: [] }),
    send = WebSocket.prototype.send,
    mark = (name) => {
      w[name] ??= performance.now();
    };
  WebSocket.prototype.send = function (text) {
    if (typeof text === "string" && text.includes('"do":"open"')) {
      w.asked = performance.now();
      this.addEventListener("message", (e) => {
        if (typeof e.data !== "string") return mark("frame");
        if (/^\{[^{]*"re":/.test(e.data.slice(0, 200)) || e.data.includes('"editable"')) mark("answered");
        else if (e.data.includes('"event":"done"')) mark("done");
      });
    }
    return send.call(this, text);
  };
  const draw = WebGL2RenderingContext.prototype.drawArrays;
  WebGL2RenderingContext.prototype.drawArrays = function (mode, first, count) {
    draw.call(this, mode, first, count);
    if (mode !== this.LINES || count < 500 || w.asked === undefined || w.drawn !== undefined) return; // axes and boxes are a few lines
    w.drawn = performance.now();
    requestAnimationFrame(() => setTimeout(() => mark("shown"), 0)); // the picture has been passed to the compositor
  };
  new PerformanceObserver((l) => {
    for (const e of l.getEntries()) w.tasks.push([e.startTime, e.duration]);
  }).observe({ type: "longtask" });
}

let bad = 0;
const errors_seen = [];
for (const blocks of sizes) write_program(`long_${blocks}.nc`, blocks);
const kadr = await real(process.env.KADR ?? new URL("../../build/release/kadr", import.meta.url).pathname, folder);
const { page, errors, close } = await browser();
try {
  await kadr.prepare(page);
  await page.addInitScript(listen);
  await page.goto(kadr.address());
  for (const blocks of sizes) {
    await page.evaluate(() => {
      for (const k of Object.keys(window.first)) if (k !== "tasks") delete window.first[k];
      window.first.tasks.length = 0;
    });
    await page.locator(`.file-name:text-is("long_${blocks}.nc")`).click();
    await until("the path", () => page.evaluate(() => window.first.shown), 120_000);
    await until("the end", () => page.evaluate(() => window.first.done), 180_000);
    await until("the end on the page", () => page.locator(".run-told.ended").count(), 60_000);
    await page.waitForTimeout(800);
    const f = await page.evaluate(() => window.first),
      after = (t) => `${((t - f.asked) / 1000).toFixed(2)} s`,
      long = Math.max(0, ...f.tasks.map((x) => x[1]));
    console.log(
      `${blocks} blocks: answered ${after(f.answered)}, first frame ${after(f.frame)}, first path on the screen ${after(f.shown)}, ` +
        `all ${after(f.done)}; tasks above 50 ms: ${f.tasks.length}, longest ${long.toFixed(0)} ms`,
    );
    if (f.shown - f.asked > (blocks <= 100_000 ? 1000 : 3000)) bad++;
  }
} finally {
  errors_seen.push(...errors);
  await close();
  await kadr.close();
  rmSync(folder, { recursive: true, force: true });
}
if (errors_seen.length) console.log("errors on the page:", errors_seen);
process.exit(errors_seen.length || bad ? 1 : 0);
