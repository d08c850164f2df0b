// From a press to its effect on the screen: KADR=…/kadr node e2e/press.mjs [PRESSES=40]. Hold and Start in turn on a long motion, in Chromium.
import { mkdtempSync, writeFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { browser, until } from "./browser.mjs";
import { server } from "./server.mjs";

const presses = Number(process.argv[2] ?? 40), folder = mkdtempSync(join(tmpdir(), "kadr-press-"));
writeFileSync(join(folder, "long.nc"), `G21 G90 G94\nG1 F600\n${Array.from({ length: 200 }, (_, i) => `X${i % 2 ? 0 : 100} Y${i % 2 ? 0 : 7}\n`).join("")}M30\n`);
const kadr = await server(folder), { page, close } = await browser();
await kadr.prepare(page);
await page.goto(kadr.address());
await until("the files", () => page.locator(".file-row").count());
await page.click(".file-row:has-text('long.nc')");
await until("the run's end", () => page.locator(".run-told.ended").count(), 60_000);
await page.click("[data-tab=panel]");
await page.click(".operator button:has-text('Switch on')");
await until("it stands", () => page.locator(".operator .mode.standing").count());
const times = [];
for (let i = 0; i < presses; i++) {
  const [key, mode] = i % 2 === 0 ? ["Start", "running"] : ["Hold", "held"];
  const button = await page.locator(`.operator-keys button:has-text('${key}')`).first().elementHandle();
  times.push(await button.evaluate((b, wanted) => new Promise((yes) => {
    const began = performance.now(), panel = document.querySelector(".operator"), share = () => panel.querySelector(".operator-figures .row .dim")?.textContent;
    // Hold shows as soon as the axes are slower than planned; that they stand takes as long as they brake.
    const seen = () => { if (wanted === "held" ? share() !== "100 %" : panel.querySelector(".mode.running")) { observer.disconnect(); requestAnimationFrame(() => yes(performance.now() - began)); } };
    const observer = new MutationObserver(seen);
    observer.observe(panel, { childList: true, subtree: true, characterData: true });
    b.click();
  }), mode));
  await until(mode, () => page.locator(`.operator .mode.${mode}`).count());
  await page.waitForTimeout(60);
}
times.sort((a, b) => a - b);
console.log(`press to screen, ms: median ${times[times.length >> 1].toFixed(1)}, greatest ${times.at(-1).toFixed(1)}, of ${times.length}`);
await close();
await kadr.close();
rmSync(folder, { recursive: true });
