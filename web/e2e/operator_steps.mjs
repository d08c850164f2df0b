// What an operator does at the operator's screen, in a real browser. Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

export function operator_steps({ kadr, page, pictures }) {
  const { count, text } = looks_at(() => page);
  const screen = ".operator-screen";
  const mode = (wanted) => until(`the machine ${wanted}`, () => count(`.screen-head .mode.${wanted}`));
  const shown = () => page.locator(screen).isVisible();
  const tab = (name) => page.click(`${screen} [data-tab=${name}]`);
  /// Work coordinate of an axis, as it is shown.
  const work = async (row) =>
    Number(
      (await text(`.readout-positions tbody tr >> nth=${row} >> td >> nth=0`)).replace("\u2212", "-").replace(",", "."),
    );
  const key = (name) => `.big-keys button:has-text('${name}')`;
  const choose = async (...names) => {
    await tab("op_program");
    await page.click(".program-tab button:has-text('Files')");
    if (await count(".crumbs button >> nth=0")) await page.click(".crumbs button >> nth=0");
    for (const name of names) await page.click(`.file-row:has(.file-name:text-is("${name}"))`);
    await until("its path", () =>
      page.evaluate(() => document.querySelector(".run-told")?.className.includes("ended")),
    );
  };
  return {
    async "the operator's screen: Start, Hold and Stop in every tab, and on keys"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await page.setViewportSize({ width: 1024, height: 768 });
      await page.goto(`${new URL(kadr.address()).origin}/?operator`);
      await until("the screen", shown);
      await choose("cut", "step.nc");
      await page.click(key("Switch on"));
      await mode("standing");
      const figure = await page
        .locator(".readout-positions td")
        .first()
        .evaluate((e) => parseFloat(getComputedStyle(e).fontSize));
      must(figure >= 32, `positions of ${figure} px`);
      const places = new Set();
      for (const name of ["op_program", "op_manual", "op_tool_zero", "op_messages", "op_restart"]) {
        await tab(name);
        const boxes = await Promise.all(["Start", "Hold", "STOP"].map((k) => page.locator(key(k)).boundingBox()));
        must(
          boxes.every((b) => b && b.height >= 44 && b.y + b.height <= 768),
          `${name}: ${JSON.stringify(boxes)}`,
        );
        places.add(JSON.stringify(boxes.map((b) => [b.x, b.y])));
        await page.screenshot({ path: join(pictures, `operator_${name}.png`) });
      }
      must(places.size === 1, "the keys are not at the same place in every tab");
      must((await count(".next-blocks li")) === 4, "not the running block and the next three");
      await page.locator(key("Start")).focus();
      await page.keyboard.press("Space");
      await tab("op_manual");
      await page.locator(".mdi-row .mdi").last().click();
      await page.keyboard.type("r");
      await page.waitForTimeout(300);
      must(await count(".screen-head .mode.standing"), "Space, or a letter that was typed, has started the machine");
      await page.keyboard.press("Backspace");
      await tab("op_program");
      await page.keyboard.press("r");
      await mode("running");
      await until("motion", async () => Math.abs(await work(0)) > 1);
      await page.screenshot({ path: join(pictures, "operator_runs.png") });
      await tab("op_manual");
      await page.locator(".mdi-row .mdi").last().click(); // Hold acts also while text is typed
      await page.keyboard.press("Escape");
      await mode("held");
      await page.click(key("Continue"));
      await mode("running");
      await page.keyboard.press("F1");
      await mode("emergency");
      await page.keyboard.press("Escape");
      await page.waitForTimeout(200);
      must(await count(".screen-head .mode.emergency"), "Esc has ended the emergency stop");
      await page.click(key("Reset"));
      await mode("standing");
    },
    async "the operator's screen is remembered, and left by its key"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await page.goto(`${new URL(kadr.address()).origin}/`);
      await until("the screen again", shown);
      await page.keyboard.press("?");
      await until("its keys", async () => (await text("dialog .keys")).includes("Start or continue"));
      await page.keyboard.press("Escape");
      await until("the dialogue is closed", async () => !(await count("dialog")));
      await page.keyboard.press("o");
      await until("the whole page", async () => !(await shown()) && (await page.locator(".page").isVisible()));
      await page.setViewportSize({ width: 1600, height: 1000 });
      await until("the files are at their place", () => count(".left > .files"));
      await until("the view too", () => count(".main-panes > .scene"));
      await page.click(".topbar button:has-text('Operator')");
      await until("the screen", shown);
      await page.click(".screen-head button:has-text('Page')");
      await until("the whole page again", async () => !(await shown()));
    },
  };
}
