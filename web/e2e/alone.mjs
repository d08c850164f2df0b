// The page without a server, in a real browser: BUILD=build/web node e2e/alone.mjs FORM [PICTURES]. FORM: `site` is the
// folder on a simple host, under a path; `file` is kadr.html, opened from the disk; `offline` is the installed page
// without a network. Exit status 1 if a step fails. FIGURES=1 also measures.
import { mkdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { alone_figures } from "./alone_figures.mjs";
import { more_steps } from "./alone_more.mjs";
import { browser, looks_at, must, until } from "./browser.mjs";
import { hands_on } from "./hands.mjs";
import { simple_host } from "./simple_host.mjs";

const form = process.argv[2] ?? "site",
  pictures = process.argv[3] ?? "/tmp/kadr-alone",
  build = resolve(process.env.BUILD ?? "../build/web"),
  examples = process.env.EXAMPLES ?? fileURLToPath(new URL("../../examples", import.meta.url));
mkdirSync(pictures, { recursive: true });
const host = form === "file" ? null : await simple_host(join(build, "site"), "/some/path/");
const address = host ? host.address : pathToFileURL(join(build, "kadr.html")).href;
const { context, page, errors, close } = await browser();
const { count, text, ended } = looks_at(() => page);
const { now } = hands_on(page);
const shot = (name) => page.screenshot({ path: join(pictures, `${form}_${name}.png`) });

const asked = []; // every request that leaves the page or its worker
context.on("request", (r) => {
  if (!/^(blob|data):/.test(r.url())) asked.push(r.url());
});

/// Drops files on the page: `[name, text]`.
const drop = (files) =>
  page.evaluate((all) => {
    const data = new DataTransfer();
    for (const [name, content] of all) data.items.add(new File([content], name));
    for (const kind of ["dragover", "drop"])
      document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
  }, files);
const example = (name) => [name.split("/").pop(), readFileSync(join(examples, name), "utf8")];
const files = () => page.locator(".file-list .file-name").allTextContents();
/// Shows the folder of the page, into which files are dropped then.
const root = async () => {
  await page.click(".crumbs button >> nth=0");
  await until("the folder", async () => (await count(".crumbs button")) === 1);
};
const opened = async (name) => {
  await until(`${name} is open`, async () => (await text(".topbar .file")) === name);
  await ended();
};

const steps = {
  async "shows the examples"() {
    const begin = Date.now();
    await page.goto(address);
    await until("the examples", () => count(".examples button"));
    const told = await page.locator(".start").textContent();
    must(/leaves this computer/.test(told), `it does not say where the files are: ${told}`);
    await shot("start");
    return `${Date.now() - begin} ms`;
  },
  async "an example runs, and is a file of the page"() {
    await page.locator(".examples button").first().click();
    await ended();
    must((await text(".state .positions")).length > 20, "no positions");
    await page.locator(".slider").focus();
    await page.keyboard.press("End");
    await until("the end", async () => (await now()) > 1);
    must((await page.locator(".file-row.folder").count()) + (await files()).length > 0, "no file in the list");
    await shot("example");
  },
  async "no request left after the page was loaded"() {
    const before = asked.length;
    await page.locator(".slider").press("Home");
    const refused = await page.evaluate(() =>
      Promise.all(
        [fetch("index.html"), fetch("https://example.com/")].map((f) => f.then(() => false).catch(() => true)),
      ),
    );
    must(refused.every(Boolean), "the page may still connect");
    const others = asked.filter((url) => !url.startsWith(host ? host.address : "file:"));
    must(asked.length === before && !others.length, `requests: ${asked.slice(before)} ${others}`);
    errors.splice(0, errors.length, ...errors.filter((e) => !/Content Security Policy|Failed to fetch/.test(e)));
  },
  async "a dropped program is run, with its set-up"() {
    await root();
    await drop([example("fanuc/flange_taps.json")]);
    await until("the set-up", async () => (await files()).includes("flange_taps.json"));
    await drop([example("fanuc/flange_taps.nc")]);
    await opened("flange_taps.nc");
    must(
      /Fanuc/i.test(await page.locator(".topbar select").first().locator("option:checked").textContent()),
      "control",
    );
    await shot("dropped");
  },
  async "a fault is found while one types"() {
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+Home");
    await page.keyboard.press("End");
    await page.keyboard.press("Enter");
    await page.keyboard.insertText("G777 X5");
    await page.click("[data-tab=problems]");
    await until("the alarm", () => count(".problems .alarm"));
    await shot("fault");
    for (let i = 0; i < 5 && (await count(".dirty")); i++) {
      await page.locator(".cm-content").focus();
      await page.keyboard.press("Control+z");
    }
    await until("the old text", async () => !(await count(".dirty")));
    await ended();
  },
  async "cuts the part"() {
    await drop([example("cut/tools.toml")]);
    await until("the tools", async () => (await files()).includes("tools.toml"));
    await drop([example("cut/plate.nc")]);
    await opened("plate.nc");
    await page.click("[data-tab=cut_tab]");
    await until("the form", () => count(".cut-run button:enabled"));
    await page.click(".cut-run button");
    await until("what is left", () => count(".cut .facts"));
    await page.locator(".slider").press("End");
    await until("the part at the end", async () =>
      /\d/.test((await page.locator(".cut .note").allTextContents()).join(" ")),
    );
    await page.waitForTimeout(800);
    await shot("cut");
  },
  async "makes a report"() {
    const waits = page.waitForEvent("download");
    await page.click(".topbar button:has-text('Report')");
    const file = readFileSync(await (await waits).path(), "utf8");
    must(/<html/.test(file) && file.length > 500_000, `${file.length} bytes`);
  },
  async "the machine's panel says what it needs"() {
    await page.click("[data-tab=panel]");
    await until("the sentence", async () =>
      /kadr serve/.test((await page.locator(".tab-body, main, body").first().textContent()) ?? ""),
    );
    must(!(await count(".topbar button:has-text('Operate')")), "the operator's screen is offered");
  },
  async "stops a long run, and goes on"() {
    const loop =
      "%\nO0009\nG21 G90\n#1=0\nWHILE[#1LT100000000]DO1\nG1X[#1/1000]F1000\nG1Y1\nG1Y0\n#1=#1+1\nEND1\nM30\n%\n";
    await drop([["long.nc", loop]]);
    await until("it runs", () => count(".topbar button.stop"));
    await page.waitForTimeout(1500);
    const begin = Date.now();
    await page.click(".topbar button.stop");
    await until("it has stopped", async () => !(await count(".topbar button.stop")), 60_000);
    const took = Date.now() - begin;
    if (form === "file") await until("the engine anew", () => count(".banner[hidden]"));
    await page.click('.file-name:text-is("plate.nc")');
    await opened("plate.nc");
    return `${took} ms`;
  },
  async "speaks Russian"() {
    await page.click('button:text-is("РУ")');
    await until("Russian", async () => /Карта наладки/.test(await text(".topbar")));
    await ended();
    await page.click("[data-tab=panel]");
    await shot("ru");
    await page.click('button:text-is("EN")');
    await ended();
  },
  async "saves, and keeps the files for the next visit"() {
    const name = await text(".topbar .file");
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+Home");
    await page.keyboard.press("End");
    await page.keyboard.insertText(" (CHANGED HERE)");
    await page.keyboard.press("Control+s");
    await until("it is saved", async () => !(await count(".dirty")));
    await page.waitForTimeout(500);
    if (form === "offline") await host.close();
    await page.goto("about:blank");
    await page.goto(address);
    await opened(name);
    await root();
    await until("the files", async () => (await files()).includes("flange_taps.nc"));
    await until("the saved text", async () => /CHANGED HERE/.test(await text(".cm-content")));
    await shot("again");
  },
};

Object.assign(steps, more_steps({ page, address, examples, drop, opened, root, shot }));

let passed = 0,
  failed = 0;
const run = async (name, step) => {
  if (failed && process.env.UNTIL_FAILURE) return; // the steps that follow wait in vain
  const begin = Date.now();
  try {
    const note = await step();
    passed++;
    console.log(`ok    ${form}: ${name}${note ? ` (${note})` : ""}  ${Date.now() - begin} ms`);
  } catch (e) {
    failed++;
    console.log(`FAIL  ${form}: ${name}: ${e.message.split("\n")[0]}`);
    await shot(`fail_${failed}`).catch(() => {});
  }
};
const only = process.env.STEPS;
if (form === "offline")
  await run("is kept by the browser", async () => {
    await page.goto(address);
    await page.evaluate(() => navigator.serviceWorker.ready.then((r) => r.active.state));
    await until("the parts are kept", () => page.evaluate(async () => (await caches.keys()).length > 0));
    await page.evaluate(() => new Promise((r) => setTimeout(r, 1000)));
    await context.setOffline(true);
  });
for (const [name, step] of Object.entries(steps))
  if (!only || name.startsWith("shows") || only.split("|").some((part) => name.includes(part))) await run(name, step);
if (process.env.FIGURES) await run("figures", () => alone_figures({ page, address, drop, ended }));
if (errors.length) {
  failed++;
  console.log("errors on the page:", errors);
}
await close();
await host?.close().catch(() => {});
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
