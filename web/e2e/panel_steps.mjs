// What an operator does at the panel of a machine, step by step, in a real browser. Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

/// `only`: some of the steps run alone, without those before them.
export function panel_steps({ kadr, page, pictures, only }) {
  const { count, text, ended, toasts, line_shown, settled_view } = looks_at(() => page);
  const mode = (wanted) => until(`the machine ${wanted}`, () => count(`.operator .mode.${wanted}`), 60_000);
  return {
    async "a machine at its panel: runs, holds, a line by hand, the emergency stop"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await page.goto(`${new URL(kadr.address()).origin}/`);
      await until("the files", () => count(".file-row"));
      if (!only) await ended();
      await page.click(".crumbs button >> nth=0");
      for (const name of ["cut", "step.nc"]) await page.click(`.file-row:has-text('${name}')`);
      await ended();
      await page.click("[data-tab=panel]");
      await page.click(".operator button:has-text('Switch on')");
      const x = async () =>
        Number(
          (await page.locator(".operator .positions tbody tr >> nth=0").locator("td >> nth=0").textContent()).replace(
            "\u2212",
            "-",
          ),
        );
      await mode("standing");
      await page.fill(".operator .mdi", "G0 X17.5");
      await page.press(".operator .mdi", "Enter");
      await until("X 17.5", async () => Math.abs((await x()) - 17.5) < 1e-6, 60_000);
      await mode("standing");
      await page.click(".operator button:has-text('Undo')");
      await until("X as before", async () => Math.abs(await x()) < 1e-6);
      await page.click(".operator-keys button:has-text('Start')");
      await mode("running");
      await until("a motion", async () => (await line_shown()).includes("G"), 60_000);
      await page.click(".operator-keys button:has-text('Hold')");
      await mode("held");
      await page.screenshot({ path: join(pictures, "panel.png") });
      await page.click(".operator-keys button:has-text('Start')");
      await mode("running");
      await page.click("button.emergency");
      await mode("emergency");
      await page.click(".operator-keys button:has-text('Reset')");
      await mode("standing");
      await page.click(".operator-keys button:has-text('Switch off')");
      await until("it is off", () => count(".operator button:has-text('Switch on')"));
    },
    async "going on in mid program at the panel: the sheet, what is left, the way there"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await page.goto(`${new URL(kadr.address()).origin}/`);
      await until("the files", () => count(".file-row"));
      if (!only) await ended();
      await page.click(".crumbs button >> nth=0");
      for (const name of ["cut", "step.nc"]) await page.click(`.file-row:has-text('${name}')`);
      await ended();
      await page.click("[data-tab=panel]");
      await page.click(".operator button:has-text('Switch on')");
      await mode("standing");
      await page.click(".restart > summary");
      const field = (name) => page.locator(`.restart input[aria-label='${name}']`);
      await field("line").fill("9999");
      await page.click(".restart button:has-text('Find')");
      await until("that it is not there", async () => (await toasts()).includes("not reached"), 20_000);
      await field("line").fill("20");
      await field("line").press("Enter"); // by keyboard only
      await until("the sheet", () => count(".restart-sheet"), 20_000);
      await until(
        "a clearance over all that is gone through",
        async () => (await field("Clearance").inputValue()) !== "",
        20_000,
      );
      must(await count(".restart-rows tr.differs"), "nothing differs");
      await page.locator(".restart").evaluate((e) => e.scrollIntoView());
      await page.screenshot({ path: join(pictures, "restart.png") });
      const rows = async () => page.locator(".restart-rows tr.differs").count();
      const before = await rows();
      await page.selectOption(".restart-rows select >> nth=0", "leave");
      await until("one row less in red", async () => (await rows()) === before - 1);
      await page.selectOption(".restart-rows select >> nth=0", "set");
      await field("Clearance").fill("55");
      await field("Clearance").press("Enter");
      await until(
        "the way over it",
        async () => (await page.locator(".restart-way input >> nth=0").inputValue()) === "55.000",
        20_000,
      );
      await page.click(".restart summary:has-text('As blocks')");
      must((await text(".restart-blocks")).includes("G"), "no blocks");
      await page.click(".restart button:has-text('Go there')");
      await until(
        "it stands there",
        async () => ((await text(".operator-head")) ?? "").includes("At the place"),
        90_000,
      );
      must((await text(".operator-head")).includes("line 20"), `elsewhere: ${await text(".operator-head")}`);
      await page.click(".operator-keys button:has-text('Start')");
      await mode("running");
      await page.click("button.emergency");
      await mode("emergency");
      await page.click(".operator-keys button:has-text('Reset')");
      await mode("standing");
      await page.click(".operator-keys button:has-text('Switch off')");
      await until("it is off", () => count(".operator button:has-text('Switch on')"));
    },
    async "tables at the panel: an offset edited and the path moved; the log; watches; two pages"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await page.goto(`${new URL(kadr.address()).origin}/`);
      await until("the files", () => count(".file-row"));
      if (!only) await ended();
      await page.click(".crumbs button >> nth=0");
      for (const name of ["cut", "step.nc"]) await page.click(`.file-row:has-text('${name}')`);
      await ended();
      await page.click("[data-tab=panel]");
      await page.click(".operator button:has-text('Switch on')");
      await mode("standing");
      await page.click("[data-tab=summary]");
      const path = () => page.locator("#tab-summary, .summary").first().textContent();
      await page.click("[data-tab=panel]");
      await page.click(".tables > summary");
      await until("the tables", () => count(".tables select"), 20_000);
      await page.selectOption(".tables select >> nth=0", "work_offsets");
      await page.fill(".tables input[aria-label='New row']", "G54");
      await page.click(".tables button:has-text('Add')");
      await until("the row", () => count(".tables tr:has-text('G54')"), 20_000);
      await ended();
      const was = await settled_view();
      await page.fill(".tables tr:has-text('G54') input >> nth=0", "123");
      await page.press(".tables tr:has-text('G54') input >> nth=0", "Tab");
      await until(
        "the zero at the panel",
        async () =>
          Math.abs(
            Number(
              (
                await page.locator(".operator .positions tbody tr >> nth=0").locator("td >> nth=0").textContent()
              ).replace("\u2212", "-"),
            ) + 123,
          ) < 1e-6,
        20_000,
      );
      await until("the path has moved", async () => !was.equals(await settled_view()));
      await page.locator(".tables").evaluate((e) => e.scrollIntoView());
      await page.screenshot({ path: join(pictures, "tables.png") });
      await page.click(".tables button:has-text('As in the set-up')");
      await until(
        "the zero as before",
        async () =>
          Math.abs(
            Number(
              (
                await page.locator(".operator .positions tbody tr >> nth=0").locator("td >> nth=0").textContent()
              ).replace("\u2212", "-"),
            ),
          ) < 1e-6,
        20_000,
      );
      await page.click(".watches > summary");
      await page.fill(".watches input[aria-label='Expression']", "#5221+2");
      await page.press(".watches input[aria-label='Expression']", "Enter");
      await until(
        "its value",
        async () => ((await text(".watches .stop-points >> nth=1")) ?? "").includes("2"),
        20_000,
      );
      await page.fill(".watches input[aria-label='line']", "25");
      await page.click(".watches button:has-text('Add') >> nth=0");
      await until("the stop point", () => count(".watches .stop-points li:has-text('line 25')"));
      await page.click(".operator-keys button:has-text('Over')");
      await mode("standing");
      await page.fill(".watches input[aria-label='Condition']", "#5220 == 1");
      await page.click(".watches button:has-text('Add') >> nth=0");
      await until("the condition", () => count(".watches .stop-points li:has-text('#5220')"));
      await page.click(".operator-keys button:has-text('Start')");
      await until("held by the condition", () => count(".watches .stop-points li.hit:has-text('#5220')"), 20_000);
      await page.locator(".watches .stop-points li:has-text('#5220') button.icon").click();
      await page.click(".topbar button:has-text('РУ')");
      await until(
        "the panel in Russian",
        async () =>
          (await text(".operator-keys")).includes("Пуск") &&
          (await text(".tables > summary")).includes("Таблицы") &&
          (await text(".restart > summary")).includes("Продолжить"),
      );
      await page.screenshot({ path: join(pictures, "panel_ru.png") });
      await page.click(".topbar button:has-text('EN')");
      await until("and in English", async () => (await text(".operator-keys")).includes("Start"));
      await page.click(".shift > summary");
      await until("the log", () => count(".shift tr:has-text('tables edited')"), 20_000);
      await page.screenshot({ path: join(pictures, "shift.png") });
      const other = await page.context().newPage();
      await other.goto(kadr.address());
      await other.waitForSelector("[data-tab=panel]");
      await other.click(".crumbs button >> nth=0");
      for (const name of ["cut", "step.nc"]) await other.click(`.file-row:has-text('${name}')`);
      await other.click("[data-tab=panel]");
      await other.click(".operator button:has-text('Switch on')");
      await other.waitForSelector(".operator button:has-text('Take them')", { timeout: 30_000 });
      await other.click(".operator button:has-text('Take them')");
      await until("the first page sees it", () => count(".operator button:has-text('Take them')"), 20_000);
      await other.click(".operator-keys button:has-text('Switch off')");
      await other.close();
      await until("it is off", () => count(".operator button:has-text('Switch on')"), 20_000);
    },
    async "two channels at the panel, side by side with who waits for whom"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await page.goto(`${new URL(kadr.address()).origin}/`);
      await until("the files", () => count(".file-row"));
      await page.click(".crumbs button >> nth=0");
      kadr.put("two-channels/wrong.json", '{"work_offsets": {"G54": {"Q": 1}}}');
      for (const name of ["two-channels", "milling.nct"])
        await page.click(`.file-row:has(.file-name:text-is("${name}"))`);
      await ended();
      await page.selectOption(".setup-choice", "two-channels/wrong.json");
      await until("that it is refused", async () => (await toasts()) !== "");
      await until(
        "what could be opened stays",
        async () => (await count(".setup-choice")) && (await page.locator(".setup-choice").inputValue()) === "",
      );
      await ended();
      await page.selectOption(".setup-choice", "two-channels/milling.json");
      await ended();
      await page.click("[data-tab=panel]");
      await page.click(".operator button:has-text('Switch on')");
      await mode("standing");
      await until("both channels", async () => (await count(".channels .channel")) === 2);
      must(await count("button[aria-label='2:X −']"), "no keys for the axes of channel 2");
      await page.click("button[aria-label='2:X +']");
      await until(
        "its axis has moved",
        async () => ((await page.locator(".channels .channel >> nth=1").textContent()) ?? "").includes("X 1.000"),
        60_000,
      );
      await mode("standing");
      await page.click(".operator-keys button:has-text('Start')");
      await until(
        "one waits for the other",
        async () => /M50\d: waits for [12]/.test((await text(".channels")) ?? ""),
        60_000,
      );
      await page.screenshot({ path: join(pictures, "channels.png") });
      const found = ((await text(".channels .channel.waits")) ?? "").match(/Channel (\d).*waits for (\d)/);
      must(found && found[1] !== found[2], `who waits for whom: ${await text(".channels")}`);
      await page.click(".operator-keys button:has-text('Reset')");
      await mode("standing");
      await page.click(".restart > summary");
      await page.fill(".restart input[aria-label='line']", "10");
      await page.press(".restart input[aria-label='line']", "Enter");
      await until("a sheet of each channel", () => count(".restart-sheet .restart-beside"), 20_000);
      must(/Channel 2/.test(await text(".restart-beside")), `whose sheet: ${await text(".restart-beside")}`);
      await page.click(".restart button[aria-label='Goes first: Channel 2']");
      await until("its way is the first", async () => (await text(".restart-beside")).includes("way 1"));
      await page.locator(".restart-beside").evaluate((e) => e.scrollIntoView({ block: "center" }));
      await page.screenshot({ path: join(pictures, "channels_restart.png") });
      await page.click(".restart button:has-text('Go there')");
      await until(
        "both stand there",
        async () => ((await text(".operator-head")) ?? "").includes("At the place"),
        90_000,
      );
      await page.click(".operator-keys button:has-text('Start')");
      await mode("running");
      await page.click(".operator-keys button:has-text('Reset')");
      await mode("standing");
      await page.click(".operator-keys button:has-text('Switch off')");
      await until("it is off", () => count(".operator button:has-text('Switch on')"), 20_000);
    },
    async "a touch of the part at the panel sets the zero"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await page.goto(`${new URL(kadr.address()).origin}/`);
      await until("the files", () => count(".file-row"));
      await page.click(".crumbs button >> nth=0");
      for (const name of ["cut", "step.nc"]) await page.click(`.file-row:has(.file-name:text-is("${name}"))`);
      await ended();
      await page.click("[data-tab=cut_tab]");
      await until("the form", () => count(".cut-run button"));
      await page.click(".cut-run button");
      await until("what is left", () => count(".cut .facts"), 120_000);
      await page.click("[data-tab=panel]");
      await page.click(".operator button:has-text('Switch on')");
      await mode("standing");
      await page.click(".touch > summary");
      await page.click(".scene-bar button:text-is('Top')");
      await settled_view();
      const box = await page.locator(".scene-host canvas").boundingBox();
      await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
      await until("a place from above", async () => ((await text(".touch")) ?? "").includes("Z− up to Z ="));
      await page.screenshot({ path: join(pictures, "touch.png") });
      await page.click(".touch button:has-text('Touch')");
      await until("it has touched", async () => ((await text(".touch")) ?? "").includes("Touched. In G54"), 60_000);
      await page.fill(".touch input[aria-label='Value']", "7");
      await page.click(".touch button:has-text('Set zero')");
      await until("the zero is set", () => count(".touch summary"), 20_000);
      await page.click(".tables > summary");
      await page.selectOption(".tables select >> nth=0", "work_offsets");
      await until("it stands in the table", () => count(".tables tr:has-text('G54') input.edited"), 20_000);
      await page.click(".tables button:has-text('As in the set-up')");
      await page.click(".operator-keys button:has-text('Switch off')");
      await until("it is off", () => count(".operator button:has-text('Switch on')"), 20_000);
    },
  };
}

/// These steps are last: once another browser context has had the keyboard, type-ahead in lists no longer works in the
/// first page.
export function finger_steps({ kadr, browser, pictures }) {
  let page;
  const { count, ended } = looks_at(() => page);
  const mode = (wanted) => until(`the machine ${wanted}`, () => count(`.operator .mode.${wanted}`), 60_000);
  return {
    async "the panel by fingers"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      const context = await browser.newContext({ hasTouch: true, viewport: { width: 1024, height: 768 } });
      page = await context.newPage();
      try {
        await page.goto(kadr.address());
        await until("the files", () => count(".file-row"));
        await page.tap(".crumbs button >> nth=0");
        for (const name of ["cut", "step.nc"]) await page.tap(`.file-row:has(.file-name:text-is("${name}"))`);
        await ended();
        await page.tap("[data-tab=panel]");
        await page.tap(".topbar button:has-text('Shop')");
        await page.tap(".operator button:has-text('Switch on')");
        await mode("standing");
        for (const key of ["Start", "Hold", "Reset", "STOP"]) {
          const at = await page.locator(`.operator-keys button:has-text('${key}')`).first().boundingBox();
          must(at.height >= 44 && at.width >= 44, `${key} is ${at.width} by ${at.height}`);
        }
        await page.tap(".operator-keys button:has-text('Start')");
        await mode("running");
        await page.tap(".operator-keys button:has-text('Hold')");
        await mode("held");
        await page.tap("button.emergency");
        await mode("emergency");
        await page.tap(".operator-keys button:has-text('Reset')");
        await mode("standing");
        const z = async () =>
          Number(
            (await page.locator(".operator .positions tbody tr >> nth=2").locator("td >> nth=1").textContent()).replace(
              "\u2212",
              "-",
            ),
          );
        const before = await z();
        await page.tap("button[aria-label='Z +']");
        await until("the axis has moved", async () => Math.abs((await z()) - before - 1) < 0.0025, 60_000); // shown in thousandths
        await mode("standing");
        await page.screenshot({ path: join(pictures, "fingers.png") });
        await page.tap(".operator-keys button:has-text('Switch off')");
        await until("it is off", () => count(".operator button:has-text('Switch on')"), 20_000);
      } finally {
        await context.close();
      }
    },
  };
}
