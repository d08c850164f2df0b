// Measures the time from a typed character to the painted list of problems, and to the marked text:
// KADR=…/kadr node e2e/typing.mjs [CHARACTERS=40] [LINES=2000]. A block is edited into an alarm and back, in Chromium.
//   asked    the text is sent to be checked: the editor waits until nobody types      answer   of the server
//   list     the tab of the problems shows it (its DOM)                               painted  that picture is passed on
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { browser, until } from "./browser.mjs";
import { server } from "./server.mjs";
import { told_times } from "./times.mjs";

const characters = Number(process.argv[2] ?? 40),
  lines = Number(process.argv[3] ?? 2000),
  folder = mkdtempSync(join(tmpdir(), "kadr-typing-")),
  stages = ["asked", "answer", "list", "painted"];
const block = (i) => `N${10 * (i + 1)} G1 X${(i % 100) / 10} Y${Math.floor(i / 100) / 10} F600\n`;
writeFileSync(
  join(folder, "typed.nc"),
  `G21 G90 G94\n${Array.from({ length: lines }, (_, i) => block(i)).join("")}M30\n`,
);
const kadr = await server(folder),
  { page, close } = await browser();
await kadr.prepare(page);
await page.addInitScript(() => {
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
await page.click(".file-row:has-text('typed.nc')");
await until("the run's end", () => page.locator(".run-told.ended").count(), 60_000);
await page.click("[data-tab=problems]");
await page.locator(".cm-line", { hasText: "N30 " }).first().click();
await page.keyboard.press("End");

/// Runs in the page: measures from the next key until the list shows an alarm or none.
const wait = (wanted) => {
  window.typed = new Promise((yes) => {
    const times = {},
      list = document.querySelector(".problems"),
      now = () => performance.now() - began;
    let id = null,
      began = 0;
    window.addEventListener("keydown", (e) => (began = e.timeStamp), { once: true, capture: true });
    window.went = (q) => {
      if (q.do !== "check") return;
      id = q.id;
      times.asked ??= now();
    };
    window.came = (a) => {
      if (a.re === id) times.answer ??= now();
    };
    const observer = new MutationObserver(() => {
      if (Boolean(list.querySelector(".alarm")) !== wanted) return;
      observer.disconnect();
      times.list = now();
      requestAnimationFrame(() => {
        const after = new MessageChannel();
        after.port1.onmessage = () => {
          times.painted = now();
          window.went = window.came = undefined;
          yes(times);
        };
        after.port2.postMessage(0);
      });
    });
    observer.observe(list, { childList: true, subtree: true, characterData: true });
  });
};
const all = Object.fromEntries(stages.map((s) => [s, []]));
for (let i = 0; i < characters; i++) {
  const faulty = i % 2 === 0;
  await page.evaluate(wait, faulty);
  await page.keyboard.press(faulty ? "Q" : "Backspace"); // F600Q: a word without a value
  const times = await page.evaluate(() => window.typed);
  for (const s of stages) all[s].push(times[s]);
  await page.waitForTimeout(i % 4 < 2 ? 100 : 1500); // while the text runs, and when it has run
}
for (const s of stages) told_times(`typed to ${s}`, all[s]);
await close();
await kadr.close();
rmSync(folder, { recursive: true });
