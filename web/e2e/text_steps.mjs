// What is shown is what is compared, kept and run: the text as it stands in the editor. For page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

export function text_steps({ kadr, page, pictures, only }) {
  const { count, text, ended } = looks_at(() => page);
  const doc = () => page.locator(".cm-content").textContent();
  /// Opens a file of the folder `cut` from the files' list.
  async function open(name) {
    await page.goto(`${new URL(kadr.address()).origin}/`);
    await until("the files", () => count(".file-row"));
    if (!only) await ended();
    await page.click(".crumbs button >> nth=0");
    for (const one of ["cut", name]) await page.click(`.file-row:has(.file-name:text-is("${one}"))`);
    await ended();
    await until(`the text of ${name}`, async () => (await text(".source .pane-title")).includes(name));
  }
  /// Types at the end of the line that begins so, as a person does.
  async function type_at(begins, told) {
    await page.locator(".cm-line", { hasText: begins }).first().click();
    await page.keyboard.press("End");
    await page.keyboard.type(told);
    await until("unsaved", () => count(".dirty"));
  }
  async function save_as_it_was(length) {
    for (let i = 0; i < length; i++) await page.keyboard.press("Backspace");
    await until("the saved text", async () => !(await count(".dirty")));
  }

  return {
    async "compares the text that is shown, not the one that was run last"() {
      if (!process.env.KADR) return "skipped: the made-up session compares nothing";
      await open("plate.nc");
      await type_at("N60", "\nG1 X77.5");
      must((await doc()).includes("X77.5"), "not typed");
      await page.click(".topbar button:has-text('Compare')");
      await until("as saved", () => count(".compare option:has-text('as saved')"));
      await page.selectOption(".compare select", { index: 0 });
      await page.click(".compare button.main");
      const told = async () => ((await text(".compare .note")) ?? "").trim();
      await until("what differs", async () => !["", "Comparing…"].includes(await told()), 60_000);
      must(!/^equal/.test(await told()) && (await count(".differences li")), `told: ${await told()}`);
      must(/^10 /.test((await text(".differences li")) ?? ""), `not line 10: ${await text(".differences li")}`);
      await page.screenshot({ path: join(pictures, "compare_shown.png") });
      must(!(await page.locator(".compare .stale").isVisible()), "stale at once");
      await page.locator(".cm-content").first().focus();
      await save_as_it_was("\nG1 X77.5".length);
      await until("that it is stale", () => page.locator(".compare .stale").isVisible());
      await page.click("dialog.docked .dialog-head button");
    },
  };
}
