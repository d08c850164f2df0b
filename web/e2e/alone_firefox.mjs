// The page without a server in Firefox: BUILD=../build/web node e2e/alone_firefox.mjs [FORM...]. FORM:
// `site`, a folder on a simple host; `file`, kadr.html from the disk. Exit status 1 if a step fails.
import { mkdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { must } from "./browser.mjs";
import { firefox } from "./firefox.mjs";
import { simple_host } from "./simple_host.mjs";

const given = process.argv.slice(2),
  forms = given.length ? given : ["site", "file"],
  pictures = process.env.PICTURES ?? "/tmp/kadr-alone",
  build = resolve(process.env.BUILD ?? "../build/web"),
  examples = process.env.EXAMPLES ?? fileURLToPath(new URL("../../examples", import.meta.url));
mkdirSync(pictures, { recursive: true });

/// Waits on the page until a selector has an element, with a text that matches if one is given; returns its text.
const wait_for = async (selector, pattern = "", ms = 120_000) => {
  for (const end = Date.now() + ms; Date.now() < end;) {
    const found = [...document.querySelectorAll(selector)].find((e) => new RegExp(pattern).test(e.textContent));
    if (found) return found.textContent;
    await new Promise((yes) => setTimeout(yes, 50));
  }
  throw new Error(`waited for ${selector} ${pattern}`);
};
const click = (selector, number = 0) => document.querySelectorAll(selector)[number].click();
const drop = (files) => {
  const data = new DataTransfer();
  for (const [name, content] of files) data.items.add(new File([content], name));
  for (const kind of ["dragover", "drop"])
    document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
};
const choose = (selector, value) => {
  const field = document.querySelector(selector);
  field.value = value;
  field.dispatchEvent(new Event("change", { bubbles: true }));
};
const example = (name) => [name.split("/").pop(), readFileSync(join(examples, name), "utf8")];

function steps_of(page, address) {
  const see = (...what) => page.run(wait_for, ...what);
  const ended = () => see(".run-told.ended, .run-told.stopped");
  const open_flange = async () => {
    await page.run(
      () => void [...document.querySelectorAll(".file-name")].find((e) => e.textContent === "flange_taps.nc").click(),
    );
    await see(".topbar .file", "flange_taps.nc");
    await ended();
  };
  return {
    async "an example runs"() {
      const begin = Date.now();
      await page.go(address);
      await see(".examples button");
      const took = Date.now() - begin;
      await page.run(click, ".examples button");
      await ended();
      must((await see(".state .positions")).length > 20, "no positions");
      return `${took} ms to the examples`;
    },
    async "its part is cut, with the tools that came with it"() {
      await page.run(click, "[data-tab=cut_tab]");
      await see(".cut-run button:enabled");
      await page.run(click, ".cut-run button");
      await see(".cut .facts");
    },
    async "a dropped program is run, and converted"() {
      await page.run(drop, [example("fanuc/flange_taps.json"), example("fanuc/flange_taps.nc")]);
      await see(".file-list .file-name", "flange_taps.nc");
      await open_flange();
      await page.run(
        () => void [...document.querySelectorAll('.files-verbs button[data-needs="program"]')].at(-1).click(),
      );
      await see(".convert [name=to]");
      await page.run(choose, ".convert [name=to]", "linuxcnc");
      await page.run(click, ".convert form button.main");
      must(/equal/.test(await see(".convert-told", "equal|not conv")), "it is not converted");
      await page.run(click, "dialog.docked button.icon");
    },
    async "a long run is stopped"() {
      const loop =
        "%\nO9\nG21 G90\n#1=0\nWHILE[#1LT99999999]DO1\nG1X[#1/1000]F1000\nG1Y1\nG1Y0\n#1=#1+1\nEND1\nM30\n%\n";
      await page.run(drop, [["long.nc", loop]]);
      await see(".topbar button.stop");
      await new Promise((yes) => setTimeout(yes, 1000));
      const begin = Date.now();
      await page.run(click, ".topbar button.stop");
      await see(".topbar:not(:has(button.stop))");
      return `${Date.now() - begin} ms`;
    },
    async "speaks Russian"() {
      await see(".banner[hidden]");
      await page.run(() => void [...document.querySelectorAll("button")].find((e) => e.textContent === "РУ").click());
      await see(".topbar", "Карта наладки");
      await page.run(() => void [...document.querySelectorAll("button")].find((e) => e.textContent === "EN").click());
    },
    async "the files are there at the next visit"() {
      await open_flange(); // else the page runs the long one again
      await page.go("about:blank");
      await page.go(address);
      await page.run(wait_for, ".crumbs button");
      await page.run(click, ".crumbs button");
      await see(".file-list .file-name", "flange_taps.nc");
    },
  };
}

let passed = 0,
  failed = 0;
for (const form of forms) {
  const host = form === "file" ? null : await simple_host(join(build, "site"), "/some/path/");
  const page = await firefox();
  console.log(`Firefox ${page.version}, ${form}`);
  const address = host ? host.address : pathToFileURL(join(build, "kadr.html")).href;
  for (const [name, step] of Object.entries(steps_of(page, address))) {
    const begin = Date.now();
    try {
      const note = await step();
      passed++;
      console.log(`ok    ${form}: ${name}${note ? ` (${note})` : ""}  ${Date.now() - begin} ms`);
    } catch (e) {
      failed++;
      console.log(`FAIL  ${form}: ${name}: ${e.message.split("\n")[0]}`);
    }
    await page.shot(join(pictures, `firefox_${form}_${name.replace(/\W+/g, "_")}.png`)).catch(() => {});
  }
  await page.close();
  await host?.close();
}
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
