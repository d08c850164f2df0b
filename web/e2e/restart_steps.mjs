// Going on in mid program at the panel of a machine: the sheet, what is left, the way there. Used by page.mjs.
import { join } from "node:path";
import { at_panel } from "./at_panel.mjs";
import { looks_at, must, until } from "./browser.mjs";

export function restart_steps(place) {
  const { page, pictures } = place,
    { count, text, toasts } = looks_at(() => page),
    panel = at_panel(place);
  return {
    async "going on in mid program at the panel: the sheet, what is left, the way there"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await panel.open("cut", "step.nc");
      await panel.switch_on();
      await page.click(".restart > summary");
      const field = (name) => page.locator(`.restart input[aria-label='${name}']`);
      await field("line").fill("9999");
      await page.click(".restart button:has-text('Find')");
      await until("that it is not there", async () => (await toasts()).includes("not reached"));
      await field("line").fill("20");
      await field("line").press("Enter"); // by keyboard only
      await until("the sheet", () => count(".restart-sheet"));
      await until(
        "a clearance over all that is gone through",
        async () => (await field("Clearance").inputValue()) !== "",
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
      );
      await page.click(".restart summary:has-text('As blocks')");
      must((await text(".restart-blocks")).includes("G"), "no blocks");
      await page.click(".restart button:has-text('Go there')");
      await until("it stands there", async () => ((await text(".operator-head")) ?? "").includes("At the place"));
      must((await text(".operator-head")).includes("line 20"), `elsewhere: ${await text(".operator-head")}`);
      await panel.key("Start");
      await panel.mode("running");
      await panel.stop_and_reset();
      await panel.switch_off();
    },
  };
}
