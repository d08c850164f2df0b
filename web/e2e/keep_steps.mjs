// Nothing is lost: another language, a lost connection, a reload, two who save. Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";
import { hands_on } from "./hands.mjs";

export function keep_steps({ kadr, page, pictures }) {
  const { count, text, ended, kept } = looks_at(() => page);
  const { now, line, add_line } = hands_on(page);

  return {
    async "two languages"() {
      await page.locator(".slider").focus();
      await page.keyboard.press("End");
      await until("the end", async () => (await now()) > 1);
      await page.keyboard.press("3");
      await page.selectOption(".scene-bar:not(.below) select", "depth");
      await until("its state", async () => (await text(".state")).includes("left 0:00.0"));
      const stood = await now(),
        where = await text(".block-text"),
        seen = () => page.evaluate(() => document.querySelector(".view-cube polygon")?.getAttribute("points")),
        eye = await seen();
      await page.click(".switch [lang=ru]");
      await until("Russian", async () => (await text("[data-tab=summary]")) === "Сводка");
      await ended();
      await page.screenshot({ path: join(pictures, "ru.png") });
      must((await page.getAttribute("html", "lang")) === "ru", "html lang");
      await until(
        "the same instant",
        async () => Math.abs((await now()) - stood) < 0.2 && (await text(".block-text")) === where,
      );
      must((await seen()) === eye, "the view has turned");
      must((await page.locator(".scene-bar:not(.below) select").inputValue()) === "depth", "the colouring has changed");
      await until("controls in Russian", async () =>
        /[а-яё]/i.test((await page.locator(".choices select").first().textContent()) ?? ""),
      );
      await page.click(".switch [lang=en]");
      await until("English", async () => (await text("[data-tab=summary]")) === "Summary");
      await ended();
    },
    async "loses the connection and comes back to the same instant"() {
      await page.locator(".slider").focus();
      await page.keyboard.press("End");
      await until("the end", async () => (await now()) > 1);
      const stood = await now(),
        where = await line();
      await kadr.lose();
      await until("the banner", () => page.locator(".banner").isVisible());
      await kadr.regain();
      await until("no banner", async () => !(await page.locator(".banner").isVisible()));
      await ended();
      await until("the same instant", async () => Math.abs((await now()) - stood) < 0.2 && (await line()) === where);
    },
    async "a reload keeps file and instant"() {
      await page.goto("about:blank");
      await page.goto(kadr.address()); // the restarted server has another token
      await ended();
      await page.locator(".slider").focus();
      await page.keyboard.press("End");
      await until("the end", async () => (await now()) > 1);
      const stood = await now();
      await until("the instant is kept", async () => Math.abs((await kept("open"))?.at - stood) < 0.2);
      await page.reload();
      await ended();
      await until("the same instant", async () => Math.abs((await now()) - stood) < 0.2);
    },
    async "saves, but not over what somebody else has changed"() {
      const add = async (comment) => {
        await add_line(comment);
        await until("unsaved", () => count(".dirty"));
        await page.keyboard.press("Control+s");
      };
      await add("(MINE)");
      await until("saved", async () => !(await count(".dirty")));
      await ended();
      kadr.change();
      await add("(CONFLICT)");
      await until("the question", () => count("dialog button.main"));
      await page.screenshot({ path: join(pictures, "conflict.png") });
      await page.click("dialog button.main");
      await until(
        "the one on the disk",
        async () => !(await count(".dirty")) && !(await page.locator(".cm-content").textContent()).includes("CONFLICT"),
      );
      await ended();
    },
    async "a reload keeps what was not saved"() {
      await add_line("(NOT SAVED)");
      await until("unsaved", () => count(".dirty"));
      await page.waitForTimeout(600); // it is saved a short time after the last key
      await page.reload();
      await ended();
      await until(
        "the text and its mark",
        async () => (await page.locator(".cm-content").textContent()).includes("NOT SAVED") && (await count(".dirty")),
      );
      await page.locator(".cm-content").focus();
      await page.keyboard.press("Control+End");
      for (let i = 0; i <= "(NOT SAVED)".length; i++) await page.keyboard.press("Backspace");
      await until(
        "the saved text again",
        async () => !(await page.locator(".cm-content").textContent()).includes("NOT") && !(await count(".dirty")),
      );
    },
  };
}
