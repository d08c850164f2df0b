// The panel of a machine by fingers. Used by page.mjs.
import { join } from "node:path";
import { position_of } from "./at_panel.mjs";
import { looks_at, must, until } from "./browser.mjs";

/// These steps are last: once another browser context has had the keyboard, type-ahead in lists no longer works in the
/// first page.
export function finger_steps({ kadr, browser, pictures }) {
  let page;
  const { count, ended } = looks_at(() => page);
  const mode = (wanted) => until(`the machine ${wanted}`, () => count(`.operator .mode.${wanted}`));
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
        const z = () => position_of(page, "Z", 1);
        const before = await z();
        await page.tap("button[aria-label='Z +']");
        await until("the axis has moved", async () => Math.abs((await z()) - before - 1) < 0.0025); // shown in thousandths
        await mode("standing");
        await page.screenshot({ path: join(pictures, "fingers.png") });
        await page.tap(".operator-keys button:has-text('Switch off')");
        await until("it is off", () => count(".operator button:has-text('Switch on')"));
      } finally {
        await context.close();
      }
    },
  };
}
