// One list of all problems: collisions of the cut are among them, with the ids of `kadr cut`. Used by page.mjs.
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

export function list_steps({ kadr, page, pictures, examples, only }) {
  const { count, text, ended } = looks_at(() => page);
  const stock = "box:-40,-30,-20,40,30,0";
  async function open(name) {
    await page.goto(`${new URL(kadr.address()).origin}/`);
    await until("the files", () => count(".file-row"));
    if (!only) await ended();
    await page.click(".crumbs button >> nth=0");
    for (const one of ["cut", name]) await page.click(`.file-row:has(.file-name:text-is("${one}"))`);
    await ended();
    await until(`the text of ${name}`, async () => (await text(".source .pane-title")).includes(name));
    await page.selectOption(".choices select[aria-label='Control']", "mach3");
    await page.waitForTimeout(300);
    await ended();
  }
  /// The findings of the command for the same program: "id line", in the order of both.
  function by_command(name) {
    const cut = join(examples, "cut");
    const words = ["--control", "mach3", "--stock", stock, "--tools", join(cut, "tools.toml"), "--json", "-", "-q"];
    try {
      execFileSync(process.env.KADR, ["cut", join(cut, name), ...words], { stdio: ["ignore", "pipe", "ignore"] });
    } catch (e) {
      const { collisions, warned = [] } = JSON.parse(String(e.stdout));
      return [...collisions, ...warned].map((f) => `${f.id} ${f.line}`).sort();
    }
    throw new Error("the command finds nothing");
  }
  /// The rows of a tab: "id line".
  const rows = (of) =>
    page.evaluate(
      (where) =>
        [...document.querySelectorAll(where)]
          .map((e) => `${e.dataset.id} ${/line (\d+)/.exec(e.querySelector(".dim").textContent)[1]}`)
          .sort(),
      of,
    );
  const badge = async (tab) => Number((await page.locator(`[data-tab=${tab}] .count`).allTextContents())[0] ?? 0);
  const cut = async () => {
    await page.click("[data-tab=cut_tab]");
    await until("the form", () => count(".cut-choices .field"));
    await page.locator(".cut input.wide").fill(stock);
    await page.locator(".cut input.wide").press("Enter");
    await page.click(".cut-run button.main");
    await until("what is left", () => count(".cut .facts"));
  };

  return {
    async "what the cut finds is in the one list of problems, as kadr cut has it"() {
      if (!process.env.KADR) return "skipped: the made-up session cuts nothing";
      await open("crash.nc");
      const before = await badge("problems");
      await cut();
      const wanted = by_command("crash.nc");
      await until("its list", async () => (await badge("cut_tab")) === wanted.length);
      must(
        (await rows(".cut .problem")).join() === wanted.join(),
        `tab Cut: ${await rows(".cut .problem")}, kadr cut: ${wanted}`,
      );
      await page.click("[data-tab=problems]");
      must(
        (await badge("problems")) === before + wanted.length,
        `${await badge("problems")} problems, ${before} before the cut`,
      );
      for (const group of await page.locator(".problems details.problem-group:not([open]) summary").all())
        await group.click();
      const told = await rows(".problems .problem");
      must(
        wanted.every((w) => told.includes(w)),
        `tab Problems: ${told}, kadr cut: ${wanted}`,
      );
      must(await count(".problems .whence"), "nothing says that the cut has found it");
      const collision = page.locator(".problems .problem[data-id=rapid_in_stock] .problem-go").first();
      const at = Number(/line (\d+)/.exec(await collision.locator(".dim").textContent())[1]);
      await collision.click();
      await until("its moment", async () => Number(await page.locator(".slider").getAttribute("aria-valuenow")) > 0);
      await until("its line", async () => (await text(".state .block-told .dim")).includes(String(at)));
      await page.screenshot({ path: join(pictures, "one_list.png") });
    },
    async "a text edited after the cut keeps what the cut has found, a new run does not"() {
      if (!process.env.KADR) return "skipped: the made-up session cuts nothing";
      const found = await badge("cut_tab");
      must(found > 0, "nothing found by the cut");
      await page.locator(".cm-line", { hasText: "N30" }).first().click();
      await page.keyboard.press("End");
      await page.keyboard.type(" (EDITED)");
      await until("unsaved", () => count(".dirty"));
      await page.waitForTimeout(800);
      must((await badge("cut_tab")) === found && (await count(".problems .whence")) > 0, "the findings are gone");
      await page.locator(".cm-content").first().focus();
      for (let i = 0; i < " (EDITED)".length; i++) await page.keyboard.press("Backspace");
      await until("the saved text", async () => !(await count(".dirty")));
      await page.selectOption(".choices select[aria-label='Control']", "linuxcnc");
      await until("nothing of the cut", async () => !(await badge("cut_tab")) && !(await count(".problems .whence")));
      await ended();
    },
  };
}
