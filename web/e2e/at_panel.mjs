// What every step at the panel of a machine does: opens a program, switches its machine on and off, reads its figures.
import { looks_at, until } from "./browser.mjs";

/// `only`: some of the steps run alone, without those before them.
export function at_panel({ kadr, page, only }) {
  const { count, ended } = looks_at(() => page);
  const mode = (wanted) => until(`the machine ${wanted}`, () => count(`.operator .mode.${wanted}`));
  const key = (name) => page.click(`.operator-keys button:has-text('${name}')`);

  /// Opens a program by the names of its folders and its own.
  async function open(...names) {
    await page.goto(`${new URL(kadr.address()).origin}/`);
    await until("the files", () => count(".file-row"));
    if (!only) await ended();
    await page.click(".crumbs button >> nth=0");
    for (const name of names) await page.click(`.file-row:has(.file-name:text-is("${name}"))`);
    await ended();
  }
  async function switch_on() {
    await page.click("[data-tab=panel]");
    await page.click(".operator button:has-text('Switch on')");
    await mode("standing");
  }
  async function switch_off() {
    await key("Switch off");
    await until("it is off", () => count(".operator button:has-text('Switch on')"));
  }
  /// The emergency stop, and back out of it.
  async function stop_and_reset() {
    await page.click("button.emergency");
    await mode("emergency");
    await key("Reset");
    await mode("standing");
  }
  /// A coordinate as it is shown: of the work offset, or of the machine.
  const position = (axis, column = 0) => position_of(page, axis, column);

  return { mode, key, open, switch_on, switch_off, stop_and_reset, position };
}

export async function position_of(page, axis, column = 0) {
  const row = page.locator(".operator .positions tbody tr").nth("XYZ".indexOf(axis));
  return Number((await row.locator("td").nth(column).textContent()).replace("\u2212", "-"));
}
