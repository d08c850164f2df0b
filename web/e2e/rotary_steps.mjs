// Rotary axes turn the part, and what is cut of it. Used by page.mjs.
import { join } from "node:path";
import { looks_at, until } from "./browser.mjs";

export function rotary_steps({ kadr, page, pictures, only }) {
  const { count, ended, settled_view } = looks_at(() => page);

  return {
    async "rotary axes turn the part, and what is cut of it"() {
      if (!process.env.KADR) return "skipped: the made-up session has no rotary axes";
      await page.goto(`${new URL(kadr.address()).origin}/`);
      await until("the files", () => count(".file-row"));
      if (!only) await ended(); // the program that was open before the reload has opened again, with its folder
      await page.click(".crumbs button >> nth=0");
      for (const name of ["five-axes", "trunnion_drilling.nct"]) await page.click(`.file-row:has-text('${name}')`);
      await ended();
      for (const [which, value] of [
        ["control", "nct"],
        ["machine", "table-table"],
      ]) {
        await page.selectOption(`.choices select[aria-label='${which === "control" ? "Control" : "Machine"}']`, value);
        await page.waitForTimeout(300);
        await ended();
      }
      await page.selectOption(".setup-choice", "five-axes/trunnion_drilling.json");
      await until("the program without an alarm", () => count(".run-told.ended"));
      const slider = await page.locator(".slider").boundingBox();
      await page.mouse.click(slider.x + 0.62 * slider.width, slider.y + slider.height / 2);
      const tick = async () => {
        await page.click(".filters summary");
        await page.locator(".filters label:has-text('The part turns')").click();
        await page.click(".filters summary"); // the list covers the view, and would be in its picture
        await page.locator(".slider").hover();
      };
      await page.locator(".slider").hover();
      const turned = await settled_view();
      await page.screenshot({ path: join(pictures, "turned.png") });
      await tick();
      await until("the part does not turn any more", async () => !(await settled_view()).equals(turned));
      await page.screenshot({ path: join(pictures, "not_turned.png") });
      await tick();
      await until("it turns again", async () => (await settled_view()).equals(turned));
      await page.click("[data-tab=cut_tab]");
      await until("the form", () => count(".cut-choices .field"));
      await page.click(".cut-run button");
      await until("what is left", () => count(".cut .facts"));
      await page.screenshot({ path: join(pictures, "turned_cut.png") });
    },
  };
}
