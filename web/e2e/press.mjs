// Measures the time from a key press to its effect on the screen: KADR=…/kadr node e2e/press.mjs [PRESSES=40]. Hold and
// Start in turn on a long motion, in Chromium.
// Printed stage by stage, to separate the time of the page from the time of the browser's drawing:
//   answer   of the server to the press          told    the first state that shows it has arrived
//   page     the page shows it (its DOM)         frame   the animation frame after that begins (docs/benchmarks.md)
//   painted  that frame has been passed to the compositor
import { mkdtempSync, writeFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { browser, until } from "./browser.mjs";
import { server } from "./server.mjs";
import { told_times } from "./times.mjs";

const presses = Number(process.argv[2] ?? 40),
  folder = mkdtempSync(join(tmpdir(), "kadr-press-"));
const stages = ["answer", "told", "page", "frame", "painted"];
writeFileSync(
  join(folder, "long.nc"),
  `G21 G90 G94\nG1 F600\n${Array.from({ length: 200 }, (_, i) => `X${i % 2 ? 0 : 100} Y${i % 2 ? 0 : 7}\n`).join("")}M30\n`,
);
const kadr = await server(folder),
  { page, close } = await browser();
await kadr.prepare(page);
await page.addInitScript(() => {
  // sees messages before the page does
  const Plain = window.WebSocket;
  window.WebSocket = class extends Plain {
    constructor(...of) {
      super(...of);
      this.addEventListener("message", (e) => typeof e.data === "string" && window.came?.(JSON.parse(e.data)));
    }
    send(text) {
      window.went?.(JSON.parse(text));
      super.send(text);
    }
  };
});
await page.goto(kadr.address());
await until("the files", () => page.locator(".file-row").count());
await page.click(".file-row:has-text('long.nc')");
await until("the run's end", () => page.locator(".run-told.ended").count(), 60_000);
await page.click("[data-tab=panel]");
await page.click(".operator button:has-text('Switch on')");
await until("it stands", () => page.locator(".operator .mode.standing").count());

/// Runs in the page. Hold shows as soon as the axes are slower than planned; a full stop takes as long as braking.
const press = (button, key) =>
  new Promise((yes) => {
    const panel = document.querySelector(".operator"),
      share = () => panel.querySelector(".operator-figures .share")?.textContent;
    const times = {},
      began = performance.now(),
      now = () => performance.now() - began;
    let id = null;
    window.went = (q) => {
      if (q.do === "press") id ??= q.id;
    };
    window.came = (a) => {
      if (a.re === id) times.answer ??= now();
      if (a.mode && (key === "Hold" ? a.share < 1 : a.mode === "running")) times.told ??= now();
    };
    const seen = () => {
      if (key === "Hold" ? share() === "100 %" : !panel.querySelector(".mode.running")) return;
      observer.disconnect();
      times.page = now();
      requestAnimationFrame(() => {
        times.frame = now();
        const after = new MessageChannel();
        after.port1.onmessage = () => {
          times.painted = now();
          window.went = window.came = undefined;
          yes(times);
        };
        after.port2.postMessage(0);
      });
    };
    const observer = new MutationObserver(seen);
    observer.observe(panel, { childList: true, subtree: true, characterData: true, attributes: true });
    button.click();
  });
/// Runs in the page: ms between frames while the machine runs and no key is pressed.
const pace = () =>
  new Promise((yes) => {
    const gaps = [];
    let last = performance.now();
    const next = () => {
      const at = performance.now();
      gaps.push(at - last);
      last = at;
      if (gaps.length < 40) requestAnimationFrame(next);
      else yes(gaps);
    };
    requestAnimationFrame(next);
  });

const all = Object.fromEntries(stages.map((s) => [s, []]));
let gaps = [];
for (let i = 0; i < presses; i++) {
  const [key, mode] = i % 2 === 0 ? ["Start", "running"] : ["Hold", "held"];
  if (key === "Hold")
    await until(
      "the planned speed",
      async () => (await page.locator(".operator-figures .share").textContent()) === "100 %",
    );
  const button = await page.locator(`.operator-keys button:has-text('${key}')`).first().elementHandle();
  const times = await button.evaluate(press, key);
  for (const s of stages) all[s].push(times[s]);
  await until(mode, () => page.locator(`.operator .mode.${mode}`).count());
  await page.waitForTimeout(60);
  if (i % 20 === 0) gaps = gaps.concat(await page.evaluate(pace));
}
for (const s of stages) told_times(`press to ${s}`, all[s]);
told_times("between frames, running", gaps);
await close();
await kadr.close();
rmSync(folder, { recursive: true });
