// Tables, watches and the log at the panel of a machine, in two languages and on two pages. Used by page.mjs.
import { join } from "node:path";
import { at_panel } from "./at_panel.mjs";
import { looks_at, until } from "./browser.mjs";

export function table_steps(place) {
  const { kadr, page, pictures } = place,
    { count, text, ended, settled_view } = looks_at(() => page),
    panel = at_panel(place);
  return {
    async "tables at the panel: an offset edited and the path moved; the log; watches; two pages"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await panel.open("cut", "step.nc");
      await panel.switch_on();
      await page.click(".tables > summary");
      await until("the tables", () => count(".tables select"));
      await page.selectOption(".tables select >> nth=0", "work_offsets");
      await page.fill(".tables input[aria-label='New row']", "G54");
      await page.click(".tables button:has-text('Add')");
      await until("the row", () => count(".tables tr:has-text('G54')"));
      await ended();
      const was = await settled_view();
      await page.fill(".tables tr:has-text('G54') input >> nth=0", "123");
      await page.press(".tables tr:has-text('G54') input >> nth=0", "Tab");
      await until("the zero at the panel", async () => Math.abs((await panel.position("X")) + 123) < 1e-6);
      await until("the path has moved", async () => !was.equals(await settled_view()));
      await page.locator(".tables").evaluate((e) => e.scrollIntoView());
      await page.screenshot({ path: join(pictures, "tables.png") });
      await page.click(".tables button:has-text('As in the set-up')");
      await until("the zero as before", async () => Math.abs(await panel.position("X")) < 1e-6);
      await page.click(".watches > summary");
      await page.fill(".watches input[aria-label='Expression']", "#5221+2");
      await page.press(".watches input[aria-label='Expression']", "Enter");
      await until("its value", async () => ((await text(".watches .stop-points >> nth=1")) ?? "").includes("2"));
      await page.fill(".watches input[aria-label='line']", "25");
      await page.click(".watches button:has-text('Add') >> nth=0");
      await until("the stop point", () => count(".watches .stop-points li:has-text('line 25')"));
      await panel.key("Over");
      await panel.mode("standing");
      await page.fill(".watches input[aria-label='Condition']", "#5220 == 1");
      await page.click(".watches button:has-text('Add') >> nth=0");
      await until("the condition", () => count(".watches .stop-points li:has-text('#5220')"));
      await panel.key("Start");
      await until("held by the condition", () => count(".watches .stop-points li.hit:has-text('#5220')"));
      await page.locator(".watches .stop-points li:has-text('#5220') button.icon").click();
      await page.click(".topbar button:has-text('РУ')");
      await until(
        "the panel in Russian",
        async () =>
          (await text(".operator-keys")).includes("Пуск") &&
          (await text(".tables > summary")).includes("Таблицы") &&
          (await text(".restart > summary")).includes("Продолжить"),
      );
      await page.screenshot({ path: join(pictures, "panel_ru.png") });
      await page.click(".topbar button:has-text('EN')");
      await until("and in English", async () => (await text(".operator-keys")).includes("Start"));
      await page.click(".shift > summary");
      await until("the log", () => count(".shift tr:has-text('tables edited')"));
      await page.screenshot({ path: join(pictures, "shift.png") });
      const other = await page.context().newPage();
      await other.goto(kadr.address());
      await other.waitForSelector("[data-tab=panel]");
      await other.click(".crumbs button >> nth=0");
      for (const name of ["cut", "step.nc"]) await other.click(`.file-row:has-text('${name}')`);
      await other.click("[data-tab=panel]");
      await other.click(".operator button:has-text('Switch on')");
      await other.waitForSelector(".operator button:has-text('Take them')");
      await other.click(".operator button:has-text('Take them')");
      await until("the first page sees it", () => count(".operator button:has-text('Take them')"));
      await other.click(".operator-keys button:has-text('Switch off')");
      await other.close();
      await until("it is off", () => count(".operator button:has-text('Switch on')"));
    },
  };
}
