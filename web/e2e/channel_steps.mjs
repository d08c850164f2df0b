// A machine of two channels at its panel. Used by page.mjs.
import { join } from "node:path";
import { at_panel } from "./at_panel.mjs";
import { looks_at, must, until } from "./browser.mjs";

export function channel_steps(place) {
  const { kadr, page, pictures } = place,
    { count, text, ended, toasts } = looks_at(() => page),
    panel = at_panel(place);
  return {
    async "two channels at the panel, side by side with who waits for whom"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      kadr.put("two-channels/wrong.json", '{"work_offsets": {"G54": {"Q": 1}}}');
      await panel.open("two-channels", "milling.nct");
      await page.selectOption(".setup-choice", "two-channels/wrong.json");
      await until("that it is refused", async () => (await toasts()) !== "");
      await until(
        "what could be opened stays",
        async () => (await count(".setup-choice")) && (await page.locator(".setup-choice").inputValue()) === "",
      );
      await ended();
      await page.selectOption(".setup-choice", "two-channels/milling.json");
      await ended();
      await panel.switch_on();
      await until("both channels", async () => (await count(".channels .channel")) === 2);
      must(await count("button[aria-label='2:X −']"), "no keys for the axes of channel 2");
      await page.click("button[aria-label='2:X +']");
      await until("its axis has moved", async () =>
        ((await page.locator(".channels .channel >> nth=1").textContent()) ?? "").includes("X 1.000"),
      );
      await panel.mode("standing");
      await panel.key("Start");
      await until("one waits for the other", async () => /M50\d: waits for [12]/.test((await text(".channels")) ?? ""));
      await page.screenshot({ path: join(pictures, "channels.png") });
      const found = ((await text(".channels .channel.waits")) ?? "").match(/Channel (\d).*waits for (\d)/);
      must(found && found[1] !== found[2], `who waits for whom: ${await text(".channels")}`);
      await panel.key("Reset");
      await panel.mode("standing");
      await page.click(".restart > summary");
      await page.fill(".restart input[aria-label='line']", "10");
      await page.press(".restart input[aria-label='line']", "Enter");
      await until("a sheet of each channel", () => count(".restart-sheet .restart-beside"));
      must(/Channel 2/.test(await text(".restart-beside")), `whose sheet: ${await text(".restart-beside")}`);
      await page.click(".restart button[aria-label='Goes first: Channel 2']");
      await until("its way is the first", async () => (await text(".restart-beside")).includes("way 1"));
      await page.locator(".restart-beside").evaluate((e) => e.scrollIntoView({ block: "center" }));
      await page.screenshot({ path: join(pictures, "channels_restart.png") });
      await page.click(".restart button:has-text('Go there')");
      await until("both stand there", async () => ((await text(".operator-head")) ?? "").includes("At the place"));
      await panel.key("Start");
      await panel.mode("running");
      await panel.key("Reset");
      await panel.mode("standing");
      await panel.switch_off();
    },
  };
}
