// A lathe's program: diameters, the cut part in half section with its insert, the panel. Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

export function lathe_steps({ kadr, page, pictures, only }) {
  const { count, text, ended, settled_view } = looks_at(() => page);
  async function open(folder, name, control, setup) {
    await page.goto(`${new URL(kadr.address()).origin}/`);
    await until("the files", () => count(".file-row"));
    if (!only) await ended();
    await page.click(".crumbs button >> nth=0");
    await page.click(`.file-row:has(.file-name:text-is("${folder}"))`);
    await until("the folder", () => count(`.file-row:has(.file-name:text-is("${name}"))`));
    await page.click(`.file-row:has(.file-name:text-is("${name}"))`);
    await until("its name", async () => (await text(".source .pane-title")).includes(name));
    await ended();
    await page.selectOption(".choices select[aria-label='Control']", control);
    await page.waitForTimeout(300);
    await ended();
    await page.selectOption(".setup-choice", setup);
    await page.waitForTimeout(300);
    await until("the program without an alarm", () => count(".run-told.ended"));
  }
  const to = async (share) => {
    const slider = await page.locator(".slider").boundingBox();
    await page.mouse.click(slider.x + share * slider.width, slider.y + slider.height / 2);
  };
  const figures = () =>
    page.evaluate(() =>
      [...document.querySelectorAll(".state .figure")].map((f) => [...f.children].map((c) => c.textContent).join("|")),
    );

  return {
    async "X of a lathe is a diameter everywhere"() {
      if (!process.env.KADR) return "skipped: the made-up session has no lathe";
      await open("cut", "lathe.nc", "fanuc-t", "cut/lathe.json");
      await until("diameters in the state", async () => (await text(".state .positions")).includes("X Ø"));
      await page.click("[data-tab=summary]");
      await until("diameters in the summary", async () => (await text(".summary table.list")).includes("X Ø"));
      const extents = await page.locator(".summary table.list >> nth=0").textContent();
      must(/X Ø\s*20\.000\s*52\.600/.test(extents), `the widest cut is not 52.6: ${extents}`);
      await until("the greatest diameter in the view", async () =>
        (await page.locator(".flag-figure").allTextContents()).some((x) => /^Ø 52\.600/.test(x.trim())),
      );
    },
    async "the surface speed, its limit and the offsets of the tool"() {
      if (!process.env.KADR) return "skipped: the made-up session has no lathe";
      let share = 0.25; // rapids and cuts alternate along the slider
      await until("a cut with a feed per revolution", async () => {
        await to((share += 0.003));
        return (await figures()).some((x) => /^F\|0\.\d+\|mm\/rev/.test(x));
      });
      await until("the surface speed", async () => (await figures()).some((x) => /^S\|180\|m\/min/.test(x)));
      const all = await figures();
      must(
        all.some((x) => /^S max\|2.500\|rev/.test(x)),
        `no limit: ${all}`,
      );
      must(
        all.some((x) => /^R\|0\.800\|/.test(x)),
        `no nose radius: ${all}`,
      );
    },
    async "the part is cut exactly and shown in half section"() {
      if (!process.env.KADR) return "skipped: the made-up session has no lathe";
      await page.click("[data-tab=cut_tab]");
      await until("the blank as a bar", async () => (await text(".cut")).includes("Z from"));
      await until("the form", () => count(".cut-choices .field"));
      await page.locator(".cut label:has-text('take from') select").selectOption("cut/lathe.toml");
      await until("the tools of the file", async () => (await text(".cut")).includes("entering angle"));
      await page.click(".cut-run button");
      await until("what is left", () => count(".cut .facts"));
      must(!(await text(".cut .facts")).includes("cell"), "a cell of an exact cut");
      await until("the part", async () => (await text(".cut")).includes("Cut exactly"));
      const half = await settled_view();
      await page.screenshot({ path: join(pictures, "lathe_cut.png") });
      await page.selectOption(".scene select[aria-label='Section']", "");
      await until("the whole part", async () => !(await settled_view()).equals(half));
      const whole = await settled_view();
      await page.selectOption(".scene select[aria-label='Section']", "half");
      await until("the half section again", async () => !(await settled_view()).equals(whole));
      const again = await settled_view();
      await to(0.6);
      await until("the part later, with the insert", async () => !(await settled_view()).equals(again));
      await page.screenshot({ path: join(pictures, "lathe.png") });
    },
    async "the panel of a lathe"() {
      if (!process.env.KADR) return "skipped: the made-up session has no lathe";
      await page.click("[data-tab=panel]");
      await page.click(".operator button:has-text('Switch on')");
      await until("diameters", async () => (await text(".operator .positions")).includes("X Ø"));
      await page.fill(".mdi", "G97 S800 M3");
      await page.keyboard.press("Enter");
      await until("the speed", async () => (await text(".operator-figures")).includes("800 rev/min"));
      const x = async () => Number(await text(".operator .positions tbody tr >> nth=0 >> td >> nth=0"));
      const before = await x();
      await page.click(".jog-keys button[aria-label='X −']");
      await until("one millimetre less in diameter", async () => Math.abs((await x()) - before + 1) < 1e-6);
      await page.screenshot({ path: join(pictures, "lathe_panel.png") });
      await page.click(".operator button:has-text('Switch off')");
    },
  };
}
