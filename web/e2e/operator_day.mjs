// An operator's day at the operator's screen, by touches: switch on, touch off the zero, start, M0, overrides, hold, a
// broken tool, on in mid program. Counts touches and seconds (docs/operator.md). Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

const most_touches = 24,
  most_daily = 2;

export function operator_day({ kadr, browser, pictures }) {
  let page;
  const { count, text } = looks_at(() => page);
  const mode = (wanted) => until(`the machine ${wanted}`, () => count(`.screen-head .mode.${wanted}`));
  const work = async (row) =>
    Number((await text(`.readout-positions tbody tr >> nth=${row} >> td >> nth=0`)).replace("\u2212", "-"));
  return {
    async "an operator's day by touches, counted"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      const context = await browser.newContext({ hasTouch: true, viewport: { width: 1024, height: 768 } });
      page = await context.newPage();
      await kadr.prepare(page);
      const begin = Date.now();
      let touches = 0;
      const daily = {};
      /// Touches one thing after the other, as one action of the day.
      const act = async (name, ...what) => {
        for (const one of what) {
          await page.tap(one);
          touches++;
        }
        daily[name] = Math.max(daily[name] ?? 0, what.length);
      };
      const key = (name) => `.big-keys button:has-text('${name}')`;
      const tab = (name) => `.operator-screen [data-tab=${name}]`;
      try {
        await page.goto(kadr.address().replace("/#", "/?operator#"));
        await until("the screen", () => page.locator(".operator-screen").isVisible());
        await until("the files", () => count(".file-row"));
        const row = page.locator('.file-row:has(.file-name:text-is("day.nc"))');
        // The program that was open last may arrive meanwhile: two touches count, others repeat them.
        await until("day.nc", async () => {
          if ((await text(".screen-head .file")) === "day.nc") return true;
          if (!(await row.isVisible())) {
            const top_folder = page.locator(".crumbs button >> nth=0");
            if (!(await top_folder.isVisible()))
              await page.tap(".screen-head .file", { timeout: 3000 }).catch(() => {});
            await top_folder.tap({ timeout: 3000 }).catch(() => {});
          }
          await row.tap({ timeout: 3000 }).catch(() => {});
          return page.waitForTimeout(500);
        });
        touches += daily["choose a program"] = 2;
        await until("its path", () => page.locator(".scene-host canvas").isVisible());
        await act("switch on", key("Switch on"));
        await mode("standing");

        await page.tap(tab("op_manual"));
        touches++;
        const plus = await page.locator("button.jog[aria-label='X +']").boundingBox();
        const touch = await context.newCDPSession(page);
        const at = [{ x: plus.x + plus.width / 2, y: plus.y + plus.height / 2 }];
        await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: at });
        await until("X moves while the key is held", async () => (await work(0)) > 2);
        await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
        touches++;
        daily["move an axis"] = 2;
        await mode("standing");
        const stood = await work(0);
        must(stood > 2, `X stands at ${stood}`);
        await act("zero all axes", tab("op_manual"), ".zeros button:has-text('Zero all')");
        await until("X reads 0", async () => (await work(0)) === 0);
        await mode("standing");

        await act("start", key("Start"));
        await until("M0 with its reason", async () => ((await text(".notice")) ?? "").includes("CLAMP THE PART"));
        await page.screenshot({ path: join(pictures, "operator_m0.png") });
        await act("start", key("Start"));
        await mode("running");
        await act("override −10 %", ".override-row >> nth=0 >> button:has-text('−10')");
        await act("override −10 %", ".override-row >> nth=0 >> button:has-text('−10')");
        await until("80 %", async () => (await text(".override-value")) === "80 %");
        await act("override 100 %", ".override-row >> nth=0 >> button:has-text('100 %')");
        await until("100 %", async () => (await text(".override-value")) === "100 %");
        await until("line 10", async () => Number(/\d+/.exec(await text(".screen-head .dim"))?.[0]) >= 10);
        await act("hold", key("Hold"));
        await mode("held");

        await act("reset", key("Reset")); // the tool is broken
        await mode("standing");
        await page.tap(tab("op_restart"));
        await page.fill(".restart input[aria-label='line']", "10");
        await page.tap(".restart button:has-text('Find')");
        await until("the sheet", () => count(".restart-sheet"));
        await page.tap(".restart button:has-text('Go there')");
        touches += 3;
        await until("it is there", async () => ((await text(".notice")) ?? "").includes("At the place"));
        must((await text(".screen-head .dim")) === "line 10", `elsewhere: ${await text(".screen-head .dim")}`);
        await act("start", key("Start"));
        await mode("running");
        await act("emergency stop", key("STOP"));
        await mode("emergency");
        await act("reset", key("Reset"));
        await mode("standing");
        const long = Object.entries(daily).filter(([, n]) => n > most_daily);
        must(!long.length, `more than ${most_daily} touches: ${JSON.stringify(long)}`);
        must(touches <= most_touches, `${touches} touches, ${most_touches} are documented`);
        return `${touches} touches, ${Math.round((Date.now() - begin) / 1000)} s`;
      } finally {
        await page.screenshot({ path: join(pictures, "operator_day.png") }).catch(() => {});
        await context.close();
      }
    },
  };
}
