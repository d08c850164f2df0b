// The operator's screen with a machine that is on, for the steps that move its axes: opens it, reads its figures.
import { looks_at, must, until } from "./browser.mjs";

const screen = ".operator-screen";

export function at_screen({ kadr, page }) {
  const { count, text } = looks_at(() => page);
  const mode = (wanted) => until(`the machine ${wanted}`, () => count(`.screen-head .mode.${wanted}`));
  const tab = (name) => page.click(`${screen} [data-tab=op_${name}]`);
  const key = (name) => page.click(`.big-keys button:has-text('${name}')`);

  /// Opens the screen with a program of the top folder, and switches its machine on.
  async function open(name) {
    await page.setViewportSize({ width: 1024, height: 768 });
    await page.goto(`${new URL(kadr.address()).origin}/?operator`);
    await until("the screen", () => page.locator(screen).isVisible());
    const row = page.locator(`.file-row:has(.file-name:text-is("${name}"))`);
    const is_open = async () => (await text(".screen-head .file")) === name;
    // The program that was open last may arrive meanwhile, and its folder with it.
    const try_click = (what) =>
      what
        .first()
        .click({ timeout: 3000 })
        .catch(() => {}); // it may be hidden meanwhile
    await until(name, async () => {
      if (await is_open()) return true;
      if (!(await page.isVisible(".program-host .files"))) await try_click(page.locator(".screen-head .file"));
      if (await row.count()) await try_click(row);
      else await try_click(page.locator(".crumbs button"));
      return until("it is open", is_open, 5000).catch(() => false); // clicked again, it would be opened again
    });
    const has_run = () => page.evaluate(() => /ended|stopped/.test(document.querySelector(".run-told")?.className));
    await until("its path", has_run);
    const on = page.locator(".big-keys button:has-text('Switch on'), .big-keys button:has-text('Load')");
    if (await on.first().isVisible()) await on.first().click();
    await mode("standing");
  }

  /// The three coordinates as they are shown: of the work offset, or of the machine.
  async function position(column = 0) {
    const shown = await page
      .locator(".readout-positions tbody tr")
      .evaluateAll((rows, k) => rows.map((r) => r.querySelectorAll("td")[k].textContent), column);
    const [X, Y, Z] = shown.map((v) => Number(v.replace("\u2212", "-")));
    return { X, Y, Z };
  }
  /// Waits until the machine stands, and the figures no longer change.
  async function rest() {
    await mode("standing");
    let last = "";
    await until("the axes at rest", async () => {
      const before = last;
      last = JSON.stringify(await position(1));
      await page.waitForTimeout(300); // longer than the page waits between two states of a machine that stands
      return before === last;
    });
  }
  async function must_be(wanted, what, column = 0) {
    const is = await position(column);
    for (const [axis, value] of Object.entries(wanted))
      must(Math.abs(is[axis] - value) < 0.0015, `${what}: ${axis} is ${is[axis]}, not ${value}`); // shown in thousandths
  }
  /// Collects the positions that the page shows until `end` is called, which returns them.
  async function record() {
    await page.evaluate(() => {
      const seen = [],
        cells = () =>
          [...document.querySelectorAll(".readout-positions tbody tr")].map((r) => r.querySelectorAll("td")),
        look = () =>
          seen.push(cells().map((r) => [...r].slice(0, 2).map((c) => Number(c.textContent.replace("\u2212", "-")))));
      const watch = new MutationObserver(look);
      look();
      watch.observe(document.querySelector(".readout-positions"), {
        subtree: true,
        childList: true,
        characterData: true,
      });
      window.recorded = () => {
        watch.disconnect();
        return seen;
      };
    });
    return async () => (await page.evaluate(() => window.recorded())).map(([x, y, z]) => ({ X: x, Y: y, Z: z }));
  }

  return { mode, tab, key, open, position, rest, must_be, record };
}
