// What is shown is what is compared, saved and run: the current text of the editor. Used by page.mjs.
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
  /// Types at the end of the line with this beginning, as a person does.
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
      await until("what differs", async () => !["", "Comparing…"].includes(await told()));
      must(!/^equal/.test(await told()) && (await count(".differences li")), `told: ${await told()}`);
      must(/^10 /.test((await text(".differences li")) ?? ""), `not line 10: ${await text(".differences li")}`);
      await page.screenshot({ path: join(pictures, "compare_shown.png") });
      must(!(await page.locator(".compare .stale").isVisible()), "stale at once");
      await page.locator(".cm-content").first().focus();
      await save_as_it_was("\nG1 X77.5".length);
      await until("that it is stale", () => page.locator(".compare .stale").isVisible());
      await page.click("dialog.docked .dialog-head button");
    },
    async "a program saved while its machine is on: the marked line is the one that the machine runs"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await open("step.nc");
      const mode = (wanted) => until(`the machine ${wanted}`, () => count(`.operator .mode.${wanted}`));
      const marked = () =>
        page.evaluate(() => {
          const row = document.querySelector(".source-host .cm-running");
          return row ? (row.querySelector(".virtual-text") ?? row).textContent.trim() : "";
        });
      const block = async () => ((await text(".operator-head .block-text")) ?? "").trim();
      const is_marked = () =>
        until(
          "the mark on the machine's block",
          async () => (await block()) !== "" && (await marked()) === (await block()),
        );
      await page.click("[data-tab=panel]");
      await page.click(".operator button:has-text('Switch on')");
      await mode("standing");
      await page.click(".operator-keys button:has-text('Start')");
      await until("a motion", async () => /^(N\d+ )?G[01]/.test(await block()));
      await page.click(".operator-keys button:has-text('Hold')");
      await mode("held");
      await is_marked();
      await page.locator(".cm-content").click();
      await page.keyboard.press("Control+Home");
      await page.keyboard.type("(ONE)\n(TWO)\n(THREE)\n");
      await until("that it is another text", () => count(".machine-other"));
      await until("no mark in the edited text", async () => (await marked()) === "");
      await page.keyboard.press("Control+s");
      await until("saved", async () => !(await count(".dirty")));
      await ended();
      await until("still another text", () => count(".machine-other"));
      await page.click(".operator-keys button:has-text('Start')");
      await until("its own text", async () => (await text(".source .pane-title")).includes("as the machine runs it"));
      await page.click(".operator-keys button:has-text('Hold')");
      await mode("held");
      await is_marked();
      await page.screenshot({ path: join(pictures, "machine_text.png") });
      await page.click(".switch [lang=ru]");
      await until("Russian", async () => (await text(".source .pane-title")).includes("как выполняет станок"));
      await page.click(".source .pane-tools button:has-text('Назад')");
      await until("the offer", async () => /другой текст/.test((await text(".machine-other")) ?? ""));
      await page.screenshot({ path: join(pictures, "machine_text_ru.png") });
      await page.click(".switch [lang=en]");
      await page.click(".operator-keys button:has-text('Reset')");
      await mode("standing");
      await until("no other text", async () => !(await count(".machine-other")));
      await page.click(".operator-keys button:has-text('Over')");
      await mode("standing");
      await is_marked();
      must((await page.locator(".cm-running").count()) === 1, "not in the editor");
      await page.click(".operator-keys button:has-text('Switch off')");
      await until("it is off", () => count(".operator button:has-text('Switch on')"));
    },
    async "a tab that is closed: the browser asks, and the text is offered on the next visit"() {
      if (!process.env.KADR) return "skipped: the made-up session has no files to come back to";
      await open("plate.nc"); // the file that the server opened last
      const visit = async () => {
        const its = await page.context().newPage();
        await kadr.prepare(its);
        await its.goto(kadr.address());
        await until("the run's end", () => its.locator(".run-told.ended, .run-told.stopped").count());
        return its;
      };
      const type = async (its, told) => {
        await its.locator(".cm-content").click();
        await its.keyboard.press("Control+Home");
        await its.keyboard.type(told);
        await until("unsaved", () => its.locator(".dirty").count());
      };
      const asked = async (its, leave, stays = false) => {
        let question = "";
        its.once("dialog", (d) => {
          question = d.type();
          return stays ? d.dismiss() : d.accept();
        });
        await leave();
        await until("the browser's question", () => question === "beforeunload");
      };
      const close = async (its) => {
        await asked(its, () => its.close({ runBeforeUnload: true }));
        await until("a closed tab", () => its.isClosed());
      };
      const first = await visit();
      await type(first, "(OF YESTERDAY)");
      await asked(first, () => first.evaluate(() => location.assign("about:blank")), true);
      must((await first.locator(".cm-content").textContent()).includes("(OF YESTERDAY)"), "the text is gone");
      await close(first);

      const second = await visit();
      await until("the offer", () =>
        second.locator("dialog:has-text('OF YESTERDAY'), dialog:has-text('was not saved')").count(),
      );
      must(!(await second.locator(".cm-content").textContent()).includes("YESTERDAY"), "taken without a question");
      await second.screenshot({ path: join(pictures, "unsaved.png") });
      await second.click("dialog button:has-text('Ask later')");
      await second.click(".switch [lang=ru]");
      await second.close();

      const third = await visit();
      await until("the offer in Russian", () =>
        third.locator("dialog:has-text('Несохранённый текст прошлого раза')").count(),
      );
      await third.click("dialog button:has-text('Продолжить с ним')");
      await until("the text", async () =>
        (await third.locator(".cm-content").textContent()).includes("(OF YESTERDAY)"),
      );
      await until("unsaved", () => third.locator(".dirty").count());
      await third.click(".switch [lang=en]");
      await until("its run", () => third.locator(".run-told.ended, .run-told.stopped").count());
      kadr.change(); // another client changes the file meanwhile
      await close(third);

      const fourth = await visit();
      await until("that the file has changed", () => fourth.locator("dialog:has-text('changed since')").count());
      await fourth.click("dialog button:has-text('Take it up')");
      await until("the text", async () =>
        (await fourth.locator(".cm-content").textContent()).includes("(OF YESTERDAY)"),
      );
      await until("its run", () => fourth.locator(".run-told.ended, .run-told.stopped").count());
      await fourth.keyboard.press("Control+s");
      await until("the conflict", () => fourth.locator("dialog:has-text('changed on the disk')").count());
      await fourth.click("dialog button.main"); // the other client's version
      await until(
        "what lies on the disk",
        async () => !(await fourth.locator(".cm-content").textContent()).includes("YESTERDAY"),
      );
      await until("nothing unsaved", async () => !(await fourth.locator(".dirty").count()));
      await fourth.close({ runBeforeUnload: true });
      await until("a closed tab", () => fourth.isClosed());

      const last = await visit();
      await last.waitForTimeout(300);
      must(!(await last.locator("dialog").count()), "offered again");
      await last.close();
    },
  };
}
