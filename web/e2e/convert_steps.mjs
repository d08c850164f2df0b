// Converting a program for another control, in a real browser: refused with the locations, proven and saved. Used by
// page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

export function convert_steps({ kadr, page, pictures }) {
  const { count, text, ended } = looks_at(() => page);
  const told = () => text(".convert-told");
  const begin = async (to) => {
    await page.selectOption(".convert [name=to]", to);
    await page.click(".convert form button.main");
    await until(
      `an answer for ${to}`,
      async () => (await count(".convert-told .good, .convert-told .error")) === 1 && !(await count(".convert-clock")),
    );
  };
  const open_with_dialog = async (path) => {
    await page.goto(kadr.address());
    await page.reload();
    await until("the files", () => count(".file-row"));
    await page.click(".crumbs button >> nth=0");
    for (const name of path) {
      await until(name, () => count(`.file-name:text-is("${name}")`));
      await page.locator(".file-row", { has: page.locator(`.file-name:text-is("${name}")`) }).click();
    }
    await until("its name", async () => (await text(".topbar .file")) === path.join("/"));
    await ended();
    await page.locator('.files-verbs button[data-needs="program"]').last().focus();
    await page.keyboard.press("Enter");
    await until("the choice of a control has the focus", () =>
      page.evaluate(() => document.activeElement?.name === "to"),
    );
  };
  return {
    async "convert: refused with the places, a click shows the line"() {
      await open_with_dialog(["gost", "plate.nc"]);
      await begin("correctors");
      must(/not converted/.test(await told()), `told: ${await told()}`);
      must(
        (await count(".convert-tries b")) >= 4 &&
          (await count(".convert-tries li")) >= 1 &&
          !(await count(".convert-written")),
        "not all ways are told",
      );
      const link = page.locator(".convert-tries .link").last(),
        line = /(\d+)/.exec(await link.textContent())[1];
      const wanted = await page.locator(".convert-tries li").last().locator("p code").first().textContent();
      await link.click();
      await until(
        `line ${line} in the source`,
        async () =>
          (await page.locator(".cm-content").textContent()).includes(wanted) &&
          (await page.locator(".cm-activeLine, .cm-running").allTextContents()).some((t) => t.trim() === wanted.trim()),
      );
      must(
        await page.evaluate(() => {
          const s = document.querySelector(".source-host").getBoundingClientRect(),
            d = document.querySelector("dialog.docked").getBoundingClientRect();
          return d.left >= s.left + 100;
        }),
        "the dialogue hides the source",
      );
      await page.screenshot({ path: join(pictures, "convert_refused.png") });
      await page.check(".convert [name=force]");
      await until("the answer to another wish goes", async () => !(await count(".convert-tries")));
    },
    async "convert: proven, kept with its set-up, opened by that control"() {
      await open_with_dialog(kadr.path);
      await begin("linuxcnc");
      must(/equal: \d+ motions/.test(await told()), `told: ${await told()}`);
      const file = await page.locator(".convert-written input").first().inputValue();
      must(file.endsWith("plate-linuxcnc.nc"), `the name: ${file}`);
      must((await page.locator(".convert-written pre").first().textContent()).includes("G1"), "no program is shown");
      for (const more of await page.locator(".convert details summary").all()) await more.click();
      await page.screenshot({ path: join(pictures, "convert.png") });
      await page.click(".convert-written button:has-text('Save'):not(.main)");
      await until("it is in the list", () => count('.file-row .file-name:text-is("plate-linuxcnc.nc")'));
      must(await count("dialog .convert"), "the dialogue has gone");
      await page.click(".convert-written button.main");
      await until("its name", async () => !(await count("dialog")) && (await text(".topbar .file")) === file);
      await ended();
      must((await page.locator(".topbar select").first().inputValue()) === "linuxcnc", "another control");
      must(!(await count(".run-told.stopped")), "it does not run");
    },
  };
}
