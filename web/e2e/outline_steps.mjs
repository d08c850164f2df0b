// The structure of programs of several controls: what it lists, where a click and the keys lead, what it marks. Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

export function outline_steps({ kadr, page, pictures, only }) {
  const { count, text, ended } = looks_at(() => page);
  const names = () => page.locator(".outline-row .outline-name").allTextContents();
  const current = async () => ((await text(".outline-row[aria-current]")) ?? "").trim();
  /// The text of the cursor's line, by the editor's own mark.
  const line = async () => ((await text(".cm-activeLine")) ?? "").trim();
  async function open(folder, name) {
    await page.goto(`${new URL(kadr.address()).origin}/`);
    await until("the files", () => count(".file-row"));
    if (!only) await ended();
    if (await count(".crumbs button")) await page.click(".crumbs button >> nth=0");
    for (const one of [folder, name]) await page.click(`.file-row:has(.file-name:text-is("${one}"))`);
    await ended();
    await until(`the structure of ${name}`, async () =>
      ((await text(".source .pane-title")) ?? "").includes(name) ? count(".outline-row") : 0,
    );
  }
  async function shot(name) {
    await page.waitForTimeout(300);
    await page.screenshot({ path: join(pictures, `outline_${name}.png`) });
  }
  const dark = (on) => page.evaluate((is) => (document.documentElement.dataset.theme = is ? "dark" : "light"), on);

  return {
    async "the structure of a conversational program: a click goes to the line, the cursor's entry is marked"() {
      if (!process.env.KADR) return "skipped: the made-up session knows no such program";
      await open("heidenhain", "bearing_plate.h");
      const listed = await names();
      must(listed[0].startsWith("BEARING_PLATE"), `first ${listed[0]}`);
      for (const one of ["T2 Bearing seat, end mill 10", "LBL LEVEL", "CYCL DEF 252 CIRCULAR POCKET"])
        must(
          listed.some((name) => name.startsWith(one)),
          `no ${one} in ${listed}`,
        );
      await page.click(".outline-row:has-text('LBL LEVEL')");
      await until("the cursor in line 12", async () => (await line()).startsWith('10 LBL "LEVEL"'));
      must((await current()).startsWith("LBL LEVEL"), `marked: ${await current()}`);
      must(
        await page.evaluate(() => document.activeElement?.classList.contains("cm-content")),
        "the text has no focus",
      );
      await page.keyboard.press("Control+Home");
      await until("the program is marked", async () => (await current()).startsWith("BEARING_PLATE"));
      await shot("heidenhain");
    },
    async "the structure by keys: arrows move and close, Enter goes to the line"() {
      if (!process.env.KADR) return "skipped: the made-up session knows no such program";
      await open("sinumerik", "hole_flange.mpf");
      await page.locator(".outline-list").focus();
      const chosen = async () => ((await text(".outline-row[aria-selected=true]")) ?? "").trim();
      const press = async (...keys) => {
        for (const key of keys) await page.keyboard.press(key);
      };
      await press("Home", "ArrowDown");
      must((await chosen()).startsWith("T1"), `after an arrow: ${await chosen()}`);
      const before = await count(".outline-row[aria-level='3']");
      await press("ArrowLeft");
      must((await count(".outline-row[aria-level='3']")) < before, "T1 is not closed");
      must((await page.getAttribute(".outline-row[aria-selected=true]", "aria-expanded")) === "false", "not said");
      await press("ArrowDown");
      must((await chosen()).startsWith("T2"), `after the closed one: ${await chosen()}`);
      await press("ArrowRight", "Enter");
      await until("the line of CYCLE83", async () => (await line()).startsWith("N170 MCALL CYCLE83"));
      await shot("sinumerik");
      await dark(true);
      await shot("sinumerik_dark");
      await dark(false);
    },
    async "the structure follows what is typed, and closes"() {
      if (!process.env.KADR) return "skipped: the made-up session knows no such program";
      await open("fanuc", "flange_taps.nc");
      await shot("fanuc");
      await page.locator(".cm-line", { hasText: "S1200" }).first().click();
      await page.keyboard.press("End");
      await page.keyboard.type("\n(ENGRAVE)\nT9 M6");
      await until("the new tool", async () => (await names()).some((name) => name.startsWith("T9 ENGRAVE")));
      for (let i = 0; i < "\n(ENGRAVE)\nT9 M6".length; i++) await page.keyboard.press("Backspace");
      await until("the tool is gone", async () => !(await names()).some((name) => name.startsWith("T9")));
      await page.click(".outline-head");
      must(!(await page.locator(".outline-list").isVisible()), "not closed");
      await page.click(".outline-head");
      must(await page.locator(".outline-list").isVisible(), "not open again");
      await until("the saved text", async () => !(await count(".dirty")));
      await open("linuxcnc", "bolt_circles.ngc");
      await shot("linuxcnc");
    },
  };
}
