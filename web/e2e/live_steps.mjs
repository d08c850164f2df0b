// The first minute, and what follows by itself: examples, the tour, the path of the text while one types, the time that
// zooms, the focus that goes round. Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";
import { hands_on } from "./hands.mjs";

export function live_steps({ kadr, page, pictures }) {
  const { count, text, ended } = looks_at(() => page);
  const { now, add_line } = hands_on(page);
  const skipped = "skipped: the made-up session has no examples";
  const end_of_time = async () => Number(await page.locator(".slider").getAttribute("aria-valuemax"));

  return {
    async "a tour of five steps, which can be left and called again"() {
      if (!kadr.folder) return skipped;
      if (!(await count(".start:visible"))) return "skipped: a program is open";
      await page.click(".start button:has-text('Show me around')");
      for (let n = 1; n <= 5; n++) {
        await until(`step ${n}`, async () => (await text(".tour .dim")) === `${n} of 5`);
        const box = await page.locator(".tour").boundingBox(),
          { width, height } = page.viewportSize();
        must(
          box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height,
          `step ${n} is cut off`,
        );
        if (n < 5) await page.click(".tour button:has-text('Next')");
      }
      await page.keyboard.press("Escape");
      await until("it has ended", async () => !(await count(".tour")));
      await page.click(".topbar button[aria-label='Keys']");
      await page.click("dialog button:has-text('Show me around')");
      await until("once more", () => count(".tour"));
      await page.click(".tour button:has-text('Leave')");
      await until("left", async () => !(await count(".tour, .tour-ring")));
    },
    async "an example by one click"() {
      if (!kadr.folder) return skipped;
      if (!(await count(".start:visible"))) return "skipped: a program is open";
      await until("the examples", async () => (await count(".start [data-example]")) >= 6);
      await page.screenshot({ path: join(pictures, "start.png") });
      await page.click(".start [data-example='cut/plate.nc']");
      await until("its text", async () => (await text(".source .pane-title")).includes("kadr-examples/plate.nc"));
      await ended();
      must(!(await count(".start:visible")), "the beginning is still there");
    },
    async "the path follows the text by itself"() {
      if (!kadr.folder) return skipped;
      if (!(await text(".source .pane-title")).includes("kadr-examples/plate.nc")) return "skipped: no example is open";
      await ended();
      const before = await end_of_time();
      await page.locator(".cm-line", { hasText: "N40" }).first().click();
      await page.keyboard.press("End");
      await page.keyboard.press("Enter");
      await page.keyboard.type("G4 P100", { delay: 40 });
      await until("a longer time", async () => (await end_of_time()) > before + 50);
      await until("it is no longer old", async () => !(await count(".scene.old")));
      must((await page.locator(".cm-content").textContent()).includes("G4 P100"), "a typed character is lost");
      await page.keyboard.type(" (fast typing while it runs, and nothing of it may be lost)", { delay: 15 });
      await page.waitForTimeout(1500);
      await ended();
      must(
        (await page.locator(".cm-content").textContent()).includes("and nothing of it may be lost)"),
        "typed text is lost",
      );
      for (let i = 0; i < 12 && (await count(".dirty")); i++) await page.keyboard.press("Control+z");
      await until("the old text", async () => !(await count(".dirty")));
      await until("the old time", async () => Math.abs((await end_of_time()) - before) < 0.2);
    },
    async "the time zooms by wheel, keys and buttons"() {
      const slider = page.locator(".slider"),
        box = await slider.boundingBox(),
        instant_at = async (share) => {
          await page.mouse.click(box.x + share * box.width, box.y + box.height - 9);
          await page.waitForTimeout(100);
          return now();
        };
      const whole = (await instant_at(0.6)) - (await instant_at(0.4));
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      for (let i = 0; i < 6; i++) await page.mouse.wheel(0, -120);
      await until("a part of the time", () => count(".timeline button:has-text('All of it')"));
      const part = (await instant_at(0.6)) - (await instant_at(0.4));
      must(part > 0 && part < 0.5 * whole, `${part} s instead of ${whole} s between the same places`);
      await page.screenshot({ path: join(pictures, "zoomed.png") });
      await page.keyboard.press("ArrowUp");
      const closer = (await instant_at(0.6)) - (await instant_at(0.4));
      must(closer < part, "the arrow up does not zoom");
      await page.click(".timeline button:has-text('All of it')");
      await until("all of it", async () => !(await count(".timeline button:has-text('All of it')")));
    },
    async "F6 goes round all panes, also from the view"() {
      const pane = () =>
        page.evaluate(
          () => document.activeElement?.closest(".files, .source, .scene, .state, .tabs, .timeline")?.className,
        );
      await page.locator(".slider").focus();
      const seen = [];
      for (let i = 0; i < 6; i++) {
        await page.keyboard.press("F6");
        seen.push((await pane())?.split(" ").find((c) => c !== "pane"));
      }
      must(new Set(seen).size === 6 && seen[5] === "timeline", `it goes ${seen.join(", ")}`);
      await page.keyboard.press("Shift+F6");
      must((await pane())?.includes("tabs"), "it does not go back");
    },
    async "a window of another size shows the whole path again"() {
      const inside = () =>
        page.evaluate(() => {
          const host = document.querySelector(".scene-host").getBoundingClientRect();
          return [...document.querySelectorAll(".flag-figure")].every((e) => {
            const b = e.getBoundingClientRect();
            return b.left >= host.left && b.right <= host.right && b.top >= host.top && b.bottom <= host.bottom;
          });
        });
      const size = page.viewportSize();
      await page.locator(".slider").focus();
      await page.keyboard.press("f");
      await page.setViewportSize({ width: 1024, height: 768 });
      await until("all in the small view", inside);
      await page.screenshot({ path: join(pictures, "small.png") });
      await page.setViewportSize(size);
      await until("all in the large view", inside);
    },
  };
}
