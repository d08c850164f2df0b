// A live report in a real browser: node e2e/alone_live.mjs REPORT.html [PICTURES]. REPORT: what `kadr report --live` has
// made of examples/cut/plate.nc with its tools and a blank. Exit status 1 if a step fails.
import { mkdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { browser, looks_at, must, until } from "./browser.mjs";

const report = resolve(process.argv[2]),
  pictures = process.argv[3] ?? "/tmp/kadr-alone";
mkdirSync(pictures, { recursive: true });
const { context, page, errors, close } = await browser();
const { count, text, ended } = looks_at(() => page);
const asked = [];
context.on("request", (r) => {
  if (!/^(blob|data):/.test(r.url())) asked.push(r.url());
});
const steps = {
  async "opens the program"() {
    await page.goto(pathToFileURL(report).href);
    await until("it is open", async () => (await text(".topbar .file")) === "plate.nc");
    await ended();
    must(/Mach3/.test(await page.locator(".topbar select").first().locator("option:checked").textContent()), "control");
  },
  async "any instant has its state"() {
    const before = await text(".state .positions");
    await page.locator(".slider").press("End");
    await until("another state", async () => (await text(".state .positions")) !== before);
  },
  async "cuts the part with the tools and the blank of the report"() {
    await page.click("[data-tab=cut_tab]");
    await until("the form", () => count(".cut-run button:enabled"));
    must(!(await count(".cut .tool-form.unknown")), "a tool is not known");
    await page.click(".cut-run button");
    await until("what is left", () => count(".cut .facts"));
    await page.waitForTimeout(800);
    await page.screenshot({ path: join(pictures, "live.png") });
  },
  async "another control reads it anew"() {
    await page.locator(".topbar select").first().selectOption("linuxcnc");
    await until("it runs again", () => count(".run-told.ended, .run-told.stopped"));
    await ended();
  },
  async "its files are not kept, and nothing was asked of anybody"() {
    await page.goto("about:blank");
    await page.goto(pathToFileURL(report).href);
    await until("it is open", async () => (await text(".topbar .file")) === "plate.nc");
    const kept = await page.evaluate(async () => (await indexedDB.databases()).map((d) => d.name));
    must(!kept.includes("kadr-files"), `kept: ${kept}`);
    const others = asked.filter((url) => !url.startsWith("file:") && url !== "about:blank");
    must(!others.length, `requests: ${others}`);
  },
};
let passed = 0,
  failed = 0;
for (const [name, step] of Object.entries(steps))
  try {
    await step();
    passed++;
  } catch (e) {
    failed++;
    console.log(`FAIL  live: ${name}: ${e.message.split("\n")[0]}`);
    await page.screenshot({ path: join(pictures, `live_fail_${failed}.png`) });
  }
if (errors.length) console.log("errors:", errors, ++failed && "");
await close();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
