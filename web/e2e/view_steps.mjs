// The view: turned by mouse, fingers and cube, coloured, saved as a picture. Used by page.mjs.
import { statSync } from "node:fs";
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";
import { hands_on } from "./hands.mjs";

export function view_steps({ page, pictures }) {
  const { count } = looks_at(() => page);
  const { find_motion } = hands_on(page);

  return {
    async "a long block does not push the figures out of the pane"() {
      const wide = await page.evaluate(() => {
        const block = document.querySelector(".block-text"),
          pane = block.closest(".pane-body"),
          was = block.textContent;
        block.textContent = "G1 X[#5*COS[#121]-#101*#2] Y[#5*SIN[#121]-#101*#3] ".repeat(4);
        const over = pane.scrollWidth - pane.clientWidth;
        block.textContent = was;
        return over;
      });
      must(wide <= 0, `${wide} px beyond the pane`);
    },
    async "views, cube, perspective, colours with their figures"() {
      await page.keyboard.press("6");
      await until("three faces", async () => (await count(".cube-face")) === 3);
      await page.locator(".cube-face", { hasText: "Top" }).first().click();
      await until("the cube has turned", async () => (await count(".cube-face")) === 1);
      await page.keyboard.press("6");
      for (const [value, told] of [
        ["speed", /mm\/min/],
        ["depth", /mm/],
        ["slowed", /100/],
        ["time", /\d:\d\d/],
        ["tool", /T1/],
        ["kind", /feed/],
      ]) {
        await page.selectOption(".scene-bar:not(.below) select", value);
        await until(`the legend of ${value}`, async () =>
          told.test((await page.locator(".scene-legend").textContent()) ?? ""),
        );
      }
      await page.click(".scene-bar button:has-text('Ortho')");
      await until("perspective", () => count(".scene-bar button:has-text('Persp')"));
      await find_motion();
      await page.click(".scene-bar button:has-text('Persp')");
      must(await count(".flag-start"), "no flag at the start");
      must(await count(".flag-end"), "no flag at the end");
    },
    async "turns, moves and zooms with the mouse and with two fingers"() {
      const canvas = page.locator(".scene-host canvas"),
        box = await canvas.boundingBox(),
        [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      const seen = async () =>
        page.evaluate(() =>
          [...document.querySelectorAll(".flag-sign")].map((e) => e.style.transform + e.style.visibility).join(),
        );
      const changes = async (name, act) => {
        const before = await seen();
        await act();
        await until(name, async () => (await seen()) !== before);
      };
      await changes("turned", async () => {
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(x + 60, y + 30, { steps: 4 });
        await page.mouse.up();
      });
      await changes("moved", async () => {
        await page.mouse.move(x, y);
        await page.mouse.down({ button: "right" });
        await page.mouse.move(x + 60, y, { steps: 4 });
        await page.mouse.up({ button: "right" });
      });
      await changes("zoomed", () => page.mouse.wheel(0, -240));
      const cdp = await page.context().newCDPSession(page),
        fingers = (type, points) =>
          cdp.send("Input.dispatchTouchEvent", {
            type,
            touchPoints: points.map(([px, py], id) => ({ x: px, y: py, id })),
          });
      await changes("pinched", async () => {
        await fingers("touchStart", [[x - 40, y]]);
        await fingers("touchStart", [
          [x - 40, y],
          [x + 40, y],
        ]);
        for (let i = 1; i <= 5; i++)
          await fingers("touchMove", [
            [x - 40 - 12 * i, y],
            [x + 40 + 12 * i, y],
          ]);
        await fingers("touchEnd", []);
      });
      await changes("moved by two fingers", async () => {
        await fingers("touchStart", [[x - 40, y]]);
        await fingers("touchStart", [
          [x - 40, y],
          [x + 40, y],
        ]);
        for (let i = 1; i <= 5; i++)
          await fingers("touchMove", [
            [x - 40, y + 10 * i],
            [x + 40, y + 10 * i],
          ]);
        await fingers("touchEnd", []);
      });
      await page.locator(".slider").focus();
      await page.keyboard.press("f");
    },
    async "a picture as PNG"() {
      const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.click(".scene-bar.below button:has-text('PNG')"),
      ]);
      const file = join(pictures, "view.png");
      await download.saveAs(file);
      must(statSync(file).size > 3000, "the picture is empty");
    },
  };
}
