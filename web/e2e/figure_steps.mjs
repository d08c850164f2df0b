// Positions of marks, and units of figures. Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

export function figure_steps({ kadr, page, pictures, only }) {
  const { count, text, ended } = looks_at(() => page);
  async function open(name, setup = "") {
    await page.goto(`${new URL(kadr.address()).origin}/`);
    await until("the files", () => count(".file-row"));
    if (!only) await ended();
    // The program that was open last may arrive meanwhile, and its folder with it: then the name is clicked again.
    const is_open = async () => (await text(".source .pane-title")).includes(name),
      row = page.locator(`.file-row:has(.file-name:text-is("${name}"))`);
    await until("its name", async () => {
      if (await is_open()) return true;
      if (!(await row.count())) await page.click(".crumbs button >> nth=0", { timeout: 3000 }).catch(() => {});
      await row.click({ timeout: 3000 }).catch(() => {});
      return until("it is open", is_open, 5000).catch(() => false);
    });
    await ended();
    await page.selectOption(".choices select[aria-label='Control']", "fanuc");
    await page.waitForTimeout(300);
    await ended();
    if (setup) {
      await page.selectOption(".setup-choice", setup);
      await page.waitForTimeout(300);
      await until("the program without an alarm", () => count(".run-told.ended"));
    }
  }
  const at_end = async () => {
    await page.locator(".slider").focus();
    await page.keyboard.press("End");
    await until("the end", async () => (await text(".state")).includes("left 0:00.0"));
  };
  const figure = (name) =>
    page.evaluate(
      (wanted) =>
        [...document.querySelectorAll(".state .figure")]
          .map((f) => [...f.children].map((c) => c.textContent))
          .find(([n]) => n === wanted)
          ?.slice(1),
      name,
    );

  return {
    async "marks stand where the tool is, also with a stated work zero"() {
      if (!process.env.KADR) return "skipped: the made-up session has one program";
      await open("zero.nc", "zero.json");
      await page.click(".scene-bar button:has-text('Top')");
      await page.waitForTimeout(800);
      const flag = (kind, told = "") =>
        page.evaluate(
          ([k, x]) => {
            const f = [...document.querySelectorAll(`.flag-${k}`)].find((e) => e.textContent.includes(x));
            return /translate\((-?\d+)px, (-?\d+)px\)/
              .exec(f?.style.transform ?? "")
              ?.slice(1)
              .map(Number);
          },
          [kind, told],
        );
      // The path goes from (-20, 0) to (40, 38), 8 beyond the contour: the figures are at the middles of its sides,
      // the end at a corner.
      const end = await flag("end"),
        wide = await flag("figure", "60.000"),
        high = await flag("figure", "38.000");
      must(end && wide && high, `no marks: ${end} ${wide} ${high}`);
      const ratio = (end[0] - wide[0]) / (high[1] - end[1]);
      must(Math.abs(ratio - 30 / 19) < 0.1, `the end is not at the corner: ${end}, sides at ${wide}, ${high}`);
      await page.screenshot({ path: join(pictures, "marks.png") });
    },
    async "the state tells the radius that acts, the sheet an offset that two tools share"() {
      if (!process.env.KADR) return "skipped: the made-up session has one program";
      await open("zero.nc", "zero.json");
      await at_end();
      must((await figure("D2"))?.[0] === "8.000", `D2: ${await figure("D2")}`);
      must((await figure("H3"))?.[0] === "80.000", `H3: ${await figure("H3")}`);
      await page.click(".topbar button:has-text('Set-up sheet')");
      await until("the sheet", () => count("dialog .sheet"));
      const rows = await page.locator(".sheet-tools tbody tr").allTextContents();
      must(rows[0].includes("H3 also used by T2") && rows[0].includes("80.000"), `T1: ${rows[0]}`);
      must(
        rows[1].includes("H3 also used by T1") && rows[1].includes("80.000") && rows[1].includes("D2"),
        `T2: ${rows[1]}`,
      );
      await page.screenshot({ path: join(pictures, "sheet_shared.png") });
      await page.keyboard.press("Escape");
      await page.click(".switch [lang=ru]");
      await page.click(".topbar button:has-text('Карта наладки')");
      await until("the sheet in Russian", () => count("dialog .sheet:has-text('H3 применяет также T2')"));
      await page.keyboard.press("Escape");
      await page.click(".switch [lang=en]");
      await until("English", async () => (await text("[data-tab=summary]")) === "Summary");
    },
    async "a program in inches is shown in inches, with the units; a switch to mm"() {
      if (!process.env.KADR) return "skipped: the made-up session has one program";
      await open("inch.nc");
      await at_end();
      await page.click("[data-tab=summary]");
      const x = () => text(".state .positions tbody tr >> nth=0");
      must(/3\.2000.*in$/.test(await x()), `X: ${await x()}`);
      must(
        (await figure("F")).join().startsWith("10") && (await figure("F"))[1].includes("in/min"),
        `F: ${await figure("F")}`,
      );
      must((await text(".summary")).includes("3.2000") && (await text(".summary")).includes("from, in"), "the summary");
      must(await count(".flag-figure:has-text('3.2000 in')"), "the figures in the view");
      await page.screenshot({ path: join(pictures, "inch.png") });
      const chosen = (name) => page.locator(`.topbar .switch button[aria-pressed=true]:text-is("${name}")`).count();
      must(await chosen("in"), "the switch does not stand at inches");
      await page.click(".topbar .switch button:text-is('mm')");
      await until("mm", async () => /81\.280.*mm$/.test(await x()));
      must((await figure("F"))[0] === "254" && (await figure("F"))[1].includes("mm/min"), `F: ${await figure("F")}`);
      must(
        (await text(".summary")).includes("81.280") && (await text(".summary")).includes("from, mm"),
        "the summary in mm",
      );
      await page.click(".switch [lang=ru]");
      await until("Russian", async () => /81\.280.*мм$/.test(await x()));
      await page.click(".topbar .switch button:text-is('дюйм')");
      await until("inches in Russian", async () => /3\.2000.*дюйм$/.test(await x()));
      await page.screenshot({ path: join(pictures, "inch_ru.png") });
      await page.click(".switch [lang=en]");
      await open("zero.nc");
      await until("mm again", () => chosen("mm"));
    },
  };
}
