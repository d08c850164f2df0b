// What a programmer does with a program that is open: runs it, follows it by slider, mouse and keys, edits it, compares it.
// Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";
import { hands_on } from "./hands.mjs";
import { keep_steps } from "./keep_steps.mjs";
import { part_steps } from "./part_steps.mjs";
import { view_steps } from "./view_steps.mjs";

export function program_steps({ kadr, page, pictures }) {
  const { count, text, ended, line_shown } = looks_at(() => page);
  const { now, not_served, click_line, find_motion } = hands_on(page);
  return {
    async "runs an example to its end"() {
      for (const name of kadr.path) {
        const row = page.locator(".file-row", { has: page.locator(`.file-name:text-is("${name}")`) });
        await row.click();
      }
      await ended();
      must((await text(".state .positions")).length > 20, "no positions");
      must(await count(".strip canvas"), "no speed strip");
    },
    async "a click on a line goes to its pass"() {
      await click_line("N60");
      await until("another instant", async () => (await now()) > 0);
      await until("the block", async () => (await text(".block-text")).includes("N60"));
    },
    async "what the program says stays text"() {
      if (!(await count('.file-name:text-is("xss.nc")')))
        return "skipped: the made-up session has it in its one program";
      await page.locator(`.file-name:text-is("xss.nc")`).click();
      await until("its name", async () => (await text(".source .pane-title"))?.includes("xss.nc"));
      await ended();
      await until("its text", async () => (await page.locator(".cm-content").textContent()).includes("onerror=boom()"));
      await page.click("[data-tab=problems]");
      must(
        await page.evaluate(() => !document.querySelector("img") && window.boomed === undefined),
        "the comment has become an element",
      );
      await page.locator(`.file-name:text-is("plate.nc")`).click();
      await until("the plate again", async () => (await text(".source .pane-title"))?.includes("plate.nc"));
      await ended();
    },
    async "a click on a segment goes to its line"() {
      if (!(await count(".scene-host canvas"))) return "no canvas";
      await page.locator(".slider").focus();
      await page.keyboard.press("Home");
      await until("the start", async () => (await now()) === 0);
      await page.keyboard.press("1");
      const at = await find_motion((told) => !/rapid/.test(told)),
        told = await page.locator(".scene-tip").textContent(),
        wanted = /line (\d+)/.exec(told)[1];
      must(/L \d/.test(told), `no length: ${told}`);
      await page.mouse.click(...at);
      await until("the clicked segment's instant", async () => (await now()) > 0);
      await until(`line ${wanted}`, async () => (await text(".state .block-told .dim")).startsWith(`line ${wanted}`));
      await until("its line in the text", line_shown);
    },
    ...view_steps({ page, pictures }),
    async "the slider goes back and forth by keys and mouse"() {
      const slider = page.locator(".slider");
      await slider.focus();
      await page.keyboard.press("End");
      await until("the end", async () => (await now()) > 1);
      const end = await now();
      await until("the last line in the text", async () => (await line_shown()).includes(await text(".block-text")));
      const last = await text(".block-text");
      await page.keyboard.press("Home");
      await until("the start", async () => (await now()) === 0);
      await until("the first line in the text", line_shown);
      for (let i = 0; i < 5; i++) for (const key of ["End", "Home"]) await page.keyboard.press(key, { delay: 0 });
      await until("the start again", async () => (await now()) === 0);
      await until("its line in the text", line_shown);
      await page.keyboard.press("Shift+ArrowRight");
      await until("ten blocks on", async () => (await now()) > 0 && (await text(".block-text")) !== last);
      const box = await slider.boundingBox();
      await page.mouse.click(box.x + box.width * 0.5, box.y + box.height - 9);
      await until("the middle", async () => Math.abs((await now()) - end / 2) < end * 0.02);
      await page.keyboard.press("ArrowLeft");
      await until("a block back", async () => (await now()) <= end / 2);
    },
    async "plays and pauses"() {
      const before = await now();
      await page.keyboard.press("Space");
      await until("it plays", async () => (await now()) > before);
      await page.keyboard.press("Space");
      const stands = await now();
      await page.waitForTimeout(300);
      must((await now()) === stands, "it does not stand");
    },
    async "a line edited into an alarm is told with its hint, and undone"() {
      await click_line("N60");
      await until("the block", async () => (await text(".block-text")).includes("N60"));
      await page.keyboard.press("Home");
      await page.keyboard.press("Shift+End");
      await page.keyboard.insertText(kadr.line);
      await page.click("[data-tab=problems]");
      await until("the alarm", () => count(".problems .alarm"));
      if (await count("details.problem-group.alarm:not([open])"))
        await page.click("details.problem-group.alarm summary");
      await until("its hint", async () => (await text(".problems .alarm .hint")).length > 5);
      await page.screenshot({ path: join(pictures, "alarm.png") });
      for (let i = 0; i < 5 && (await count(".dirty")); i++) {
        await page.locator(".cm-content").focus();
        await page.keyboard.press("Control+z");
      }
      await until("the old text", async () => !(await count(".dirty")));
      await until("no alarm any more", async () => !(await count(".problems .alarm")));
    },
    ...part_steps({ page, pictures }),
    ...keep_steps({ kadr, page, pictures }),
    async "two versions side by side"() {
      await page.click(".topbar button:has-text('Compare')");
      await until("the other programs", () => count(".compare option"));
      await page.selectOption(".compare select", { index: 0 });
      await page.click(".compare button.main");
      await until(
        "what differs",
        async () => (await not_served()) || !["", "Comparing…"].includes(((await text(".compare .note")) ?? "").trim()),
      );
      if (await not_served()) {
        await page.click("dialog.docked .dialog-head button");
        return "skipped: not served yet";
      }
      await page.screenshot({ path: join(pictures, "compare.png") });
      await page.click("dialog.docked .dialog-head button");
      await until("it closes", async () => !(await count("dialog")));
    },
    async "shop mode: targets of 44 pixels, everything has a name"() {
      await page.click(".topbar button:has-text('Shop')");
      await page.waitForTimeout(200);
      const bad = await page.evaluate(() =>
        [...document.querySelectorAll("button, select, input:not([type=checkbox]), summary")]
          .filter((e) => e.checkVisibility() && !e.closest(".cm-editor"))
          .flatMap((e) => {
            const box = e.getBoundingClientRect(),
              name =
                (e.getAttribute("aria-label") ?? e.textContent ?? "").trim() ||
                e.closest("label")?.textContent?.trim() ||
                e.title;
            return [
              ...(box.height < 43.5 ? [`${Math.round(box.height)} px: ${e.className} ${name}`] : []),
              ...(name ? [] : [`no name: ${e.outerHTML.slice(0, 80)}`]),
            ];
          }),
      );
      await page.screenshot({ path: join(pictures, "shop.png") });
      await page.click(".topbar button:has-text('Shop')");
      must(!bad.length, bad.slice(0, 5).join("; "));
    },
    async "help, set-up sheet, keys of panes"() {
      await page.locator(".slider").focus();
      await page.keyboard.press("Shift+Slash");
      await until("help", () => count("dialog .keys"));
      await page.keyboard.press("Escape");
      await page.click(".topbar button:has-text('Set-up sheet')");
      await until("the sheet", () => count("dialog .sheet"));
      await page.screenshot({ path: join(pictures, "sheet.png") });
      await page.keyboard.press("Escape");
      await page.keyboard.press("F6");
    },
  };
}
