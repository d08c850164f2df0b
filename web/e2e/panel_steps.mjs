// What an operator does at the panel of a machine: runs, holds, stops, a line by hand, a touch of the part. Used by
// page.mjs.
import { join } from "node:path";
import { at_panel } from "./at_panel.mjs";
import { looks_at, until } from "./browser.mjs";

export function panel_steps(place) {
  const { page, pictures } = place,
    { count, text, line_shown, settled_view } = looks_at(() => page),
    panel = at_panel(place);
  return {
    async "a machine at its panel: runs, holds, a line by hand, the emergency stop"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await panel.open("cut", "step.nc");
      await panel.switch_on();
      const x = () => panel.position("X");
      await page.fill(".operator .mdi", "G0 X17.5");
      await page.press(".operator .mdi", "Enter");
      await until("X 17.5", async () => Math.abs((await x()) - 17.5) < 1e-6);
      await panel.mode("standing");
      await page.click(".operator button:has-text('Undo')");
      await until("X as before", async () => Math.abs(await x()) < 1e-6);
      await panel.key("Start");
      await panel.mode("running");
      await until("a motion", async () => (await line_shown()).includes("G"));
      await panel.key("Hold");
      await panel.mode("held");
      await page.screenshot({ path: join(pictures, "panel.png") });
      await panel.key("Start");
      await panel.mode("running");
      await panel.stop_and_reset();
      await panel.switch_off();
    },
    async "a touch of the part at the panel sets the zero"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await panel.open("cut", "step.nc");
      await page.click("[data-tab=cut_tab]");
      await until("the form", () => count(".cut-choices .field"));
      await page.click(".cut-run button");
      await until("what is left", () => count(".cut .facts"));
      await panel.switch_on();
      await page.click(".touch > summary");
      await page.click(".scene-bar button:text-is('Top')");
      await settled_view();
      const box = await page.locator(".scene-host canvas").boundingBox();
      await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
      await until("a place from above", async () => ((await text(".touch")) ?? "").includes("Z− up to Z ="));
      await page.screenshot({ path: join(pictures, "touch.png") });
      await page.click(".touch button:has-text('Touch')");
      await until("it has touched", async () => ((await text(".touch")) ?? "").includes("Touched. In G54"));
      await page.fill(".touch input[aria-label='Value']", "7");
      await page.click(".touch button:has-text('Set zero')");
      await until("the zero is set", () => count(".touch summary"));
      await page.click(".tables > summary");
      await page.selectOption(".tables select >> nth=0", "work_offsets");
      await until("it stands in the table", () => count(".tables tr:has-text('G54') input.edited"));
      await page.click(".tables button:has-text('As in the set-up')");
      await panel.switch_off();
    },
  };
}
