// The part that is cut: at an instant, in section, measured, turned by rotary axes. Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";
import { hands_on } from "./hands.mjs";

export function part_steps({ page, pictures }) {
  const { count, text, settled_view } = looks_at(() => page);
  const { now, not_served, find_motion } = hands_on(page);

  return {
    async "cuts, shows the part at an instant"() {
      await page.click("[data-tab=cut_tab]");
      await until("the form", () => count(".cut-choices .field"));
      await page.click(".cut-run button");
      await until("what is left", async () => (await count(".cut .facts")) || (await not_served()));
      if (await not_served()) return "skipped: not served yet";
      await page.keyboard.press("Escape");
      await page.locator(".slider").focus();
      await page.keyboard.press("End");
      await until("the part at the end", async () =>
        /\d/.test((await page.locator(".cut .note").allTextContents()).join(" ")),
      );
      await until("the end", async () => (await now()) > 1);
      await settled_view(); // the previous part may still arrive
      const whole = (await page.locator(".cut .note").allTextContents()).join(" ");
      await page.keyboard.press("Home");
      await until(
        "another part at the start",
        async () => (await page.locator(".cut .note").allTextContents()).join(" ") !== whole,
      );
      await page.screenshot({ path: join(pictures, "cut.png") });
    },
    async "section and measuring"() {
      await page.selectOption(".scene-bar.below select", "0");
      await until("the place of the section", async () => /X/.test(await text(".section-told")));
      const told = await text(".section-told");
      await page.locator(".scene-bar.below input[type=range]").fill("0.8");
      await until("another place", async () => (await text(".section-told")) !== told);
      await page.click(".scene-bar.below button.icon");
      await page.selectOption(".scene-bar.below select", "");
      await page.locator(".slider").focus();
      await page.keyboard.press("1");
      await page.keyboard.press("m");
      must((await text(".scene-told")).length > 5, "measuring does not say how");
      const first = await find_motion((t) => /feed/.test(t)),
        line_of = async () => /line (\d+)/.exec((await page.locator(".scene-tip").textContent()) ?? "")?.[1];
      const here = await line_of();
      await page.mouse.click(...first);
      await until("the first end", async () => /now the second/.test(await text(".scene-told")));
      const second = await find_motion((t) => !t.startsWith(`line ${here} `) && /feed|arc/.test(t));
      await page.mouse.click(...second);
      await until("the distance", async () => /Distance \d+\.\d{3}/.test(await text(".scene-told")));
      const arc = await find_motion((t) => / R \d/.test(t)).catch(() => null);
      if (arc) {
        await page.mouse.click(...arc);
        await until("an end of the arc or its centre", async () => /Centre R|Point/.test(await text(".scene-told")));
      }
      await page.keyboard.press("Escape");
      must((await text(".scene-told")) === "", "measuring does not end");
    },
  };
}
