// "Edit program", in a real browser: feeds of one tool, a mirror image, a refusal with its line, taking over and undo.
// Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

export function edit_steps({ kadr, page, pictures }) {
  const { count, text, ended } = looks_at(() => page);
  const content = () => page.locator(".source .cm-content").textContent();
  const answered = async (what) => until(what, async () => (await count(".edit-told .good, .edit-told .error")) >= 1);
  const open_program = async (path) => {
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
  };
  const choose = async (edit) => {
    await page.selectOption(".edit [name=edit]", edit);
    await page.waitForTimeout(50);
  };
  return {
    async "edit: feeds of one tool by percent, next to the old text, proven"() {
      if (!kadr.edits) return "skipped: the made-up session edits nothing";
      await open_program(["docs", "two_tools.tap"]);
      await page.click(".topbar button:has-text('Edit program')");
      await choose("feed");
      await page.fill(".edit [name=percent]", "50");
      await page.selectOption(".edit [name=tool]", "1");
      await until("F100 in the new text", async () => /F100/.test((await text(".edit .merge")) ?? ""));
      await answered("the proof");
      must(/nothing else has changed/.test(await text(".edit-told")), `told: ${await text(".edit-told")}`);
      await page.screenshot({ path: join(pictures, "edit_feed.png") });
    },
    async "edit: taken over as one change that undo takes back"() {
      if (!kadr.edits) return "skipped: the made-up session edits nothing";
      await page.click(".edit button.main");
      await until(
        "the new feed in the editor",
        async () => /F100/.test(await content()) && !/F200/.test(await content()),
      );
      must(await count(".source .dirty"), "the text is not marked as unsaved");
      await page.keyboard.press("Control+z");
      await until("the old feed", async () => /F200/.test(await content()));
      must(!(await count(".source .dirty")), "the old text is not as saved");
    },
    async "edit: a mirror image with both paths in the view"() {
      if (!kadr.edits) return "skipped: the made-up session edits nothing";
      await page.click(".topbar button:has-text('Edit program')");
      await choose("mirror");
      await answered("the proof");
      must(/G42/.test((await text(".edit .merge")) ?? ""), "the side of the compensation is the old one");
      await page.click(".edit button:has-text('Show both paths')");
      await page.waitForTimeout(500);
      await page.screenshot({ path: join(pictures, "edit_mirror.png") });
    },
    async "edit: refused with the line; a click shows it"() {
      if (!kadr.edits) return "skipped: the made-up session edits nothing";
      await choose("reverse");
      await page.fill(".edit [name=from]", "7");
      await page.fill(".edit [name=to]", "9");
      await until("a refusal", async () => /Z-3/.test((await text(".edit-refused")) ?? ""));
      must(await page.locator(".edit button.main").isDisabled(), "a refused edit can be taken over");
      await page.screenshot({ path: join(pictures, "edit_refused.png") });
      await page.locator(".edit-refused .link").first().click();
      await page.locator("dialog.docked .dialog-head button").last().click();
      await until("it closes", async () => !(await count("dialog")));
    },
    async "edit: an arc by three points is written, read by the control, inserted"() {
      if (!kadr.edits) return "skipped: the made-up session edits nothing";
      await open_program(["docs", "two_tools.tap"]);
      await page.locator(".source .cm-line", { hasText: "G40 X0 Y0" }).click();
      await until("its state", async () => (await text(".block-text"))?.includes("G40 X0 Y0"));
      await page.click(".topbar button:has-text('Edit program')");
      await page.click("dialog .dialog-head button:has-text('Write blocks')");
      await page.selectOption(".edit [name=blocks]", "arc");
      const figures = { from_x: "0", from_y: "0", through_x: "10", through_y: "10", to_x: "20", to_y: "0" };
      for (const [name, value] of Object.entries(figures)) await page.fill(`.edit [name=${name}]`, value);
      await until("the control has read it", async () => (await count(".edit-told .good")) === 1);
      must(/G2 .*I10/.test((await text(".edit .block-text")) ?? ""), `written: ${await text(".edit .block-text")}`);
      await page.screenshot({ path: join(pictures, "edit_blocks.png") });
      await page.click(".edit button.main");
      await until("the arc in the program", async () => /G2 .*I10/.test(await content()));
      await page.keyboard.press("Control+z");
      await until("the program without it", async () => !/I10/.test(await content()));
    },
    async "a programmer's day: an error found and mended, feeds, a mirror image, compared, saved"() {
      if (!kadr.edits) return "skipped: the made-up session edits nothing";
      const began = Date.now();
      let hands = 0;
      const click = async (what) => {
        hands++;
        await (typeof what === "string" ? page.click(what) : what.click());
      };
      const type = async (name, value) => {
        hands++;
        await page.fill(`.edit [name=${name}]`, value);
      };
      const edit = async (name) => {
        hands += 2; // the button, the choice
        await page.click(".topbar button:has-text('Edit program')");
        await choose(name);
      };
      await open_program(["docs", "two_tools.tap"]);
      hands += 2; // the folder, the file
      await click(page.locator(".source .cm-line", { hasText: "X20 F600" }));
      await page.keyboard.press("Home");
      await page.keyboard.type("G777 ");
      hands++;
      await until("the problem", async () => /G777/.test((await text(".problems")) ?? ""));
      for (let i = 0; i < 5; i++) await page.keyboard.press("Backspace");
      hands++;
      await until("no problem", async () => !/G777/.test((await text(".problems")) ?? ""));
      await edit("feed");
      await type("percent", "80");
      await page.selectOption(".edit [name=tool]", "1");
      hands++;
      await until("80 %", async () => /F480/.test((await text(".edit .merge")) ?? ""));
      await click(".edit button.main");
      await edit("mirror");
      await until("the image", async () => /G42/.test((await text(".edit .merge")) ?? ""));
      await click(".edit button:has-text('Show both paths')");
      await click(".edit button.main");
      await until("both edits", async () => /F480/.test(await content()) && /G42/.test(await content()));
      await page.keyboard.press("Control+s");
      hands++;
      await until("saved", async () => !(await count(".source .dirty")));
      must(/G42/.test(kadr.got(join("docs", "two_tools.tap"))), "the file on the disk is the old one");
      return `${hands} clicks and entries, ${((Date.now() - began) / 1000).toFixed(1)} s`;
    },
  };
}
