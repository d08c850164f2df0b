// What the page without a server does besides running and cutting: a program from a drawing, two programs compared, work
// in several views at once, files in the address. Used by alone.mjs.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { deflateSync } from "node:zlib";
import { looks_at, must, until } from "./browser.mjs";

const loop = (turns) =>
  `%\nO0009\nG21 G90\n#1=0\nWHILE[#1LT${turns}]DO1\nG1X[#1/1000]F1000\nG1Y1\nG1Y0\n#1=#1+1\nEND1\nM30\n%\n`;

/// `address` of the page; `drop` puts files on it, `root` shows its folder first.
export function more_steps({ page, address, examples, drop, opened, root, shot }) {
  const { count, text, ended } = looks_at(() => page);
  const named = (name) => readFileSync(join(examples, name), "utf8");
  const files = () => page.locator(".file-list .file-name").allTextContents();
  const convert_to = async (control) => {
    await page.locator('.files-verbs button[data-needs="program"]').last().click();
    await until("the choice of a control", () => count(".convert [name=to]"));
    await page.selectOption(".convert [name=to]", control);
    await page.click(".convert form button.main");
  };
  const converted = () =>
    until("the conversion", async () => (await count(".convert-told .good, .convert-told .error")) === 1);

  return {
    async "says what a cut lacks, and where"() {
      await root();
      await drop([["no_tools.nc", named("haas/pocket.nc").replace("T1 ", "T77 ")]]);
      await opened("no_tools.nc");
      await page.click("[data-tab=cut_tab]");
      await until("the form", () => count(".cut .tool-form.unknown"));
      await page.click(".cut-run button");
      await until("the refusal", () => count(".cut .hint.error"));
      must(/diameter/.test(await text(".cut .hint.error")), await text(".cut .hint.error"));
      must(
        await page.evaluate(() => document.activeElement?.closest(".tool-form.unknown") !== null),
        "the field is not ready",
      );
      await shot("cut_refused");
    },
    async "makes a program from a drawing"() {
      await root();
      await drop([["cover.txt", named("mill/cover.txt")]]);
      await until("the drawing", async () => (await files()).includes("cover.txt"));
      await page.click(".files-verbs button >> nth=0");
      await until("the drawings", () => count("dialog option[value$='cover.txt']"));
      await page.selectOption("dialog [name=drawing]", "cover.txt");
      for (const [name, value] of Object.entries({ tool_diameter: "12", depth: "8", pass: "4" }))
        await page.fill(`dialog [name=${name}]`, value);
      await page.locator("dialog [name=pass]").press("Tab");
      await until("two layers", async () => /2 × Z/.test((await page.locator(".mill-summary").textContent()) ?? ""));
      await shot("mill");
      await page.click(".mill-result button.main");
      await until("it is open", async () => /cover/.test((await text(".topbar .file")) ?? ""));
      await ended();
    },
    async "compares two programs"() {
      await root();
      await drop([["other.nc", named("cut/plate.nc").replace("F300", "F400").replace("X10", "X10.5")]]);
      await opened("other.nc");
      await page.click(".topbar button:has-text('Compare')");
      await until("the other programs", () => count(".compare select option"));
      await page.selectOption(".compare select", "plate.nc");
      await page.click(".compare button.main");
      await until("what differs", async () =>
        /differ|equal/i.test((await page.locator(".compare .note").textContent()) ?? ""),
      );
      await shot("compare");
      await page.keyboard.press("Escape");
      await page.click("dialog.docked button.icon", { timeout: 3000 }).catch(() => {});
    },
    async "a conversion is answered while a long program runs, and finds what was just put here"() {
      await root();
      await drop([["short.nc", named("fanuc/rounded_plate.nc")]]);
      await opened("short.nc");
      await drop([["longer.nc", loop(100000000)]]);
      await until("it runs", () => count(".topbar button.stop"));
      const begin = Date.now();
      await convert_to("linuxcnc");
      await page.waitForTimeout(300);
      must(await count(".topbar button.stop"), "the run has ended");
      await page.click("dialog.docked button.icon", { timeout: 3000 }).catch(() => {});
      await page.click(".topbar button.stop");
      await until("it has stopped", async () => !(await count(".topbar button.stop")));
      await until("the engine anew", () => count(".banner[hidden]"));
      return `${Date.now() - begin} ms`;
    },
    async "the view answers while a long conversion works"() {
      await page.click('.file-name:text-is("plate.nc")');
      await opened("plate.nc");
      await drop([["slow.nc", loop(30000)]]);
      await opened("slow.nc");
      await convert_to("linuxcnc");
      await until("it works", () => count(".convert-clock"));
      const begin = Date.now();
      await page.locator(".slider").focus();
      await page.keyboard.press("End");
      await page.keyboard.press("ArrowLeft");
      const before = await text(".state .positions");
      await page.keyboard.press("Home");
      await until("another instant", async () => (await text(".state .positions")) !== before);
      const took = Date.now() - begin;
      must(await count(".convert-clock"), "the conversion was too short for this test");
      await page.click("dialog.docked button.icon");
      return `${took} ms`;
    },
    async "opens the files of its address, and keeps them"() {
      const json = {
        open: { file: "linked/flange_taps.nc", setup: "linked/flange_taps.json", control: "fanuc" },
        files: {
          "linked/flange_taps.nc": named("fanuc/flange_taps.nc"),
          "linked/flange_taps.json": named("fanuc/flange_taps.json"),
        },
      };
      await page.goto("about:blank");
      await page.goto(`${address}#files=${deflateSync(JSON.stringify(json)).toString("base64url")}`);
      await opened("linked/flange_taps.nc");
      must(
        /Fanuc/.test(await page.locator(".topbar select").first().locator("option:checked").textContent()),
        "control",
      );
      await shot("linked");
      await page.goto("about:blank");
      await page.goto(address);
      await until("the page", () => count(".file-row"));
      await root();
      await until("the folder", async () => (await files()).includes("linked"));
    },
    async "converts what is open"() {
      await page.click('.file-name:text-is("plate.nc")');
      await opened("plate.nc");
      await convert_to("linuxcnc");
      await converted();
      must(/equal/.test(await text(".convert-told")), await text(".convert-told"));
      await shot("convert");
      await page.keyboard.press("Escape");
      await page.click("dialog.docked button.icon", { timeout: 3000 }).catch(() => {});
    },
  };
}
