// What the operator's screen does with the window and the text: full screen, and from an alarm to its line. Used by
// page.mjs.
import { join } from "node:path";
import { at_screen } from "./at_screen.mjs";
import { looks_at, must, until } from "./browser.mjs";

export function screen_steps(place) {
  const { page, pictures } = place,
    { count, text, line_shown } = looks_at(() => page),
    screen = at_screen(place),
    skipped = "skipped: the made-up session has no machine";
  return {
    async "full screen, in which Esc holds the machine"() {
      if (!process.env.KADR) return skipped;
      await screen.open("day.nc");
      const full = page.locator(".screen-head button[aria-label='Full screen']"),
        is_full = () => page.evaluate(() => document.fullscreenElement !== null);
      if (!(await full.isVisible())) return "skipped: this browser does not leave Esc to the page";
      await full.click();
      await until("full screen", is_full);
      await until("the button that shows it", async () => (await full.getAttribute("aria-pressed")) === "true");
      await screen.key("Start");
      await until("M0", async () => ((await text(".notice")) ?? "").includes("CLAMP THE PART"));
      await screen.key("Start");
      await screen.mode("running");
      await page.keyboard.press("Escape");
      await screen.mode("held");
      must(await is_full(), "Esc has left the full screen");
      await screen.key("Reset");
      await screen.mode("standing");
      await full.click();
      await until("it has left the full screen", async () => !(await is_full()));
      await full.click();
      await until("full screen again", is_full);
      await page.keyboard.press("o");
      await until(
        "the whole page, not in full screen",
        async () => !(await is_full()) && (await page.isVisible(".page")),
      );
      await page.keyboard.press("o");
    },
    async "a click on the line of an alarm shows the block, from the notice, the messages and the panel"() {
      if (!process.env.KADR) return skipped;
      await screen.open("alarm.nc");
      await screen.key("Start");
      await screen.mode("alarm");
      await until("the alarm", async () => ((await text(".notice.alarm")) ?? "").includes("G777"));
      const shows = async (what) => {
        await until(
          `the line, ${what}`,
          async () => (await page.isVisible(".source-host")) && (await line_shown()).includes("N610 G777"),
        );
      };
      const away = async () => {
        await page.locator(".cm-scroller").evaluate((e) => e.scrollTo(0, 0));
        await until("another place", async () => !(await line_shown()).includes("N610"));
        await page.click(".program-tab > .switch button >> nth=0");
      };
      await page.click(".notice .to-line");
      await shows("from the notice");
      await page.screenshot({ path: join(pictures, "alarm_line.png") });
      await away();
      await screen.tab("messages");
      await page.click(".said .alarm .to-line >> nth=0");
      await shows("from the messages");
      await away();
      await screen.key("Reset");
      await screen.mode("standing");
      await until("no alarm any more", async () => !(await page.isVisible(".notice.alarm")));
      await screen.key("Start");
      await screen.mode("alarm");
      await page.keyboard.press("o");
      await page.setViewportSize({ width: 1600, height: 1000 });
      await page.click("[data-tab=panel]");
      await page.locator(".cm-scroller").evaluate((e) => e.scrollTo(0, 0));
      await page.click(".operator-head .alarm .to-line", { delay: 400 }); // held for longer than from one state to the next
      await shows("from the panel");
      await page.click(".operator-keys button:has-text('Reset')");
      await until("the machine stands", () => count(".operator .mode.standing"));
      await page.click(".operator-keys button:has-text('Switch off')");
    },
  };
}
