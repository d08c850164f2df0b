// The set-up made from a program, in a real browser. Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

/// A program as a CAM system writes it, for which no set-up exists.
const from_cam = [
  "%",
  "O1234 (BRACKET)",
  "(STOCK 80 X 60 X 20)",
  "(T1 D=10. CR=0. - ZMIN=-5. - FLAT END MILL)",
  "(T2 D=6. CR=0. TAPER=118DEG - ZMIN=-12. - DRILL)",
  "G90 G94 G17 G21",
  "T1 M6",
  "S3000 M3",
  "G54",
  "G0 X-50. Y0.",
  "G43 Z15. H1",
  "/Z10.",
  "Z-5.",
  "G1 G41 D1 X-30. Y0. F600.",
  "Y20.",
  "X30.",
  "Y-20.",
  "X-30.",
  "Y0.",
  "G40 X-50.",
  "G0 Z15.",
  "M1",
  "T2 M6",
  "S1800 M3",
  "G0 X-20. Y-10.",
  "G43 Z15. H2",
  "G81 G98 X-20. Y-10. Z-12. R2. F180.",
  "X20.",
  "G80",
  "M30",
  "%",
  "",
].join("\n");

export function setup_steps({ kadr, page, pictures }) {
  const { count, text, ended, toasts } = looks_at(() => page);
  const cell = (name) => page.locator(`.setup-form input[aria-label="${name}"]`);
  const state = () => text(".setup-head .note, .setup-head .hint");
  const open_again = async (file) => {
    await page.goto(kadr.address());
    await page.reload();
    await until("the files", () => count(".file-row"));
    await page.click(".crumbs button >> nth=0");
    await until("the file", () => count(`.file-name:text-is("${file}")`));
    await page.locator(`.file-name:text-is("${file}")`).click();
    await until("its name", async () => (await text(".source .pane-title"))?.includes(file));
    await ended();
  };
  return {
    async "setup: a form of what the program uses, without a machine, saved and run at once"() {
      if (!kadr.put) return "skipped: the made-up session has no set-ups";
      kadr.put("bracket.nc", from_cam);
      await open_again("bracket.nc");
      await page.selectOption(".setup-choice", { label: "make one from the program…" });
      await until("the form", () => count(".setup-form .setup-table"));
      must((await text(".setup-head")).includes("bracket.json"), "the name of the file is missing");
      must((await cell("1 Radius").inputValue()) === "5", "no radius is proposed");
      must((await text(".setup-form")).includes("T1 D=10. CR=0. - ZMIN=-5. - FLAT END MILL"), "no comment is named");
      must((await state()).includes("5 values"), `open values: ${await state()}`);
      const titles = await page.locator(".setup-table[data-table=offsets] thead").textContent();
      must(titles.includes("Length mm") && titles.includes("Radius mm"), `columns in words: ${titles}`);
      await page.locator(".setup-form").screenshot({ path: join(pictures, "setup_form.png") });
      for (const [name, value] of [
        ["G54 X", "-200"],
        ["G54 Y", "-120,5"],
        ["G54 Z", "-310"],
        ["1 Length", "95"],
        ["2 Length", "8x"],
      ])
        await cell(name).fill(value);
      must((await state()).includes("no number") && (await page.locator(".setup-save").isDisabled()), "8x is a number");
      await cell("2 Length").fill("82");
      await page.locator(".setup-form label.check", { hasText: "skip" }).click();
      await page.click(".setup-save");
      await until("it is saved", async () => (await toasts()).includes("bracket.json"));
      await ended();
      await until("it is in force", async () => (await page.locator(".setup-choice").inputValue()) === "bracket.json");
      await until("the form says so", async () => (await text(".setup-head")).includes("runs with it"));
      const saved = JSON.parse(kadr.got("bracket.json"));
      must(
        JSON.stringify(saved.work_offsets) === '{"G54":{"X":-200,"Y":-120.5,"Z":-310}}' &&
          saved.offsets["1"].length === 95 &&
          saved.offsets["1"].radius === 5 &&
          saved.skip[0] === 1,
        `saved: ${JSON.stringify(saved)}`,
      );
      must((await state()).startsWith("All values"), await state());
    },
    async "setup: a change of somebody else is not overwritten, and entries stay"() {
      if (!kadr.put) return "skipped: the made-up session has no set-ups";
      const theirs = JSON.parse(kadr.got("bracket.json"));
      theirs.work_offsets.G54.Y = 7;
      kadr.put("bracket.json", JSON.stringify(theirs));
      await cell("G54 X").fill("-201");
      await page.click(".setup-save");
      await until("the question", () => count("dialog"));
      must((await text("dialog")).includes("bracket.json"), "the question names no file");
      must(JSON.parse(kadr.got("bracket.json")).work_offsets.G54.X === -200, "it has been overwritten");
      await page.locator("dialog button", { hasText: "keep my entries" }).click();
      await until("their value", async () => (await cell("G54 Y").inputValue()) === "7");
      must((await cell("G54 X").inputValue()) === "-201", "my entry is lost");
      await page.click(".setup-save");
      await until("both", () => {
        const { X, Y } = JSON.parse(kadr.got("bracket.json")).work_offsets.G54;
        return X === -201 && Y === 7;
      });
      await ended();
    },
    async "setup: entries outlast a reload, zero all, chosen from the list"() {
      if (!kadr.put) return "skipped: the made-up session has no set-ups";
      await until("the form", async () => (await text(".setup-head")).includes("runs with it"));
      await cell("1 Length").fill("96");
      await page.reload();
      await until("the files", () => count(".file-row"));
      await ended();
      await page.click("[data-tab=setup_tab]");
      await until("the entry", async () => (await cell("1 Length").inputValue()) === "96");
      await page.locator(".setup-table[data-table=offsets] button", { hasText: "Zero all" }).click();
      must((await cell("1 Length").inputValue()) === "0" && (await cell("1 Radius").inputValue()) === "0", "not zero");
      await page.locator(".setup-head button", { hasText: "As before" }).click();
      must((await cell("1 Length").inputValue()) === "95", "not as before");
      await page.selectOption(".setup-choice", "");
      await until("without", async () => (await text(".setup-head")).includes("runs without it"));
      await ended();
      await page.selectOption(".setup-choice", "bracket.json");
      await until("with it", async () => (await text(".setup-head")).includes("the program runs with it"));
      await ended();
    },
    async "setup: a technologist's day: a program from CAM, its set-up, blank, tools, cut, sheet"() {
      if (!kadr.put) return "skipped: the made-up session has no set-ups";
      kadr.put("day.nc", from_cam.replace("BRACKET", "DAY"));
      await page.goto(kadr.address());
      await page.reload();
      await until("the files", () => count(".file-row"));
      await page.click(".crumbs button >> nth=0");
      await until("the file", () => count('.file-name:text-is("day.nc")'));
      const begin = Date.now();
      let clicks = 0,
        fields = 0;
      const click = async (what) => {
        clicks++;
        await what.click();
      };
      const type = async (name, value) => {
        fields++;
        await cell(name).fill(value);
      };
      await click(page.locator('.file-name:text-is("day.nc")'));
      await until("its name", async () => (await text(".source .pane-title"))?.includes("day.nc"));
      await ended();
      await click(page.locator("[data-tab=setup_tab]"));
      await until("its form", async () => (await text(".setup-head"))?.includes("day.json"));
      for (const [name, value] of [
        ["G54 X", "-200"],
        ["G54 Y", "-120"],
        ["G54 Z", "-310"],
        ["1 Length", "95"],
        ["2 Length", "82"],
      ])
        await type(name, value);
      await click(page.locator(".setup-save"));
      await until("it is in force", async () => (await page.locator(".setup-choice").inputValue()) === "day.json");
      await ended();
      await click(page.locator("[data-tab=cut_tab]"));
      await until("the blank", async () => (await page.locator(".cut input.wide").inputValue()).startsWith("box:"));
      must((await page.locator(".cut input.wide").inputValue()) === "box:-40,-30,-20,40,30,0", "not by the comment");
      must((await text(".cut")).includes("STOCK 80 X 60 X 20"), "it does not say by which comment");
      must((await text(".cut")).includes("assumed"), "it does not say what is assumed");
      await click(page.locator(".cut-run button.main"));
      await until("what is left", () => count(".cut .facts"));
      await page.screenshot({ path: join(pictures, "setup_cut.png") });
      await click(page.locator(".cut-start button", { hasText: "Keep" }));
      await until("kept", async () => (await toasts()).includes("day.toml"));
      const kept = JSON.parse(kadr.got("day.json"));
      must(kept.stock === "box:-40,-30,-20,40,30,0" && kept.work_offsets.G54.X === -200, JSON.stringify(kept));
      must(kadr.got("day.toml").includes('kind = "drill"'), kadr.got("day.toml"));
      await ended();
      await click(page.locator(".topbar button", { hasText: "Set-up sheet" }));
      await until("the sheet", () => count("dialog .sheet"));
      must((await text("dialog .sheet")).includes("-310"), "the sheet does not have the zero");
      const seconds = (Date.now() - begin) / 1000;
      await page.keyboard.press("Escape");
      must(clicks <= 8 && fields <= 5, `${clicks} clicks, ${fields} fields`);
      return `${clicks} clicks, ${fields} fields, ${seconds.toFixed(1)} s`;
    },
    async "setup: what was kept is used from then on, and the cut says so"() {
      if (!kadr.put) return "skipped: the made-up session has no set-ups";
      await open_again("day.nc");
      await page.selectOption(".setup-choice", "day.json");
      await until("with it", async () => (await page.locator(".setup-choice").inputValue()) === "day.json");
      await ended();
      await page.click("[data-tab=cut_tab]");
      await until("its blank", async () => (await text(".cut"))?.includes("by the set-up day.json"));
      must((await text(".cut")).includes("day.toml"), "the tools are not those of the file");
    },
  };
}
