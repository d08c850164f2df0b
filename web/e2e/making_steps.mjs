// Programs from drawings, writing and reading tape, in a real browser. Used by page.mjs.
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";

export function making_steps({ kadr, page, pictures }) {
  const { count, text, ended } = looks_at(() => page);
  return {
    async "making: a new program from a drawing, by the keyboard alone"() {
      await page.goto(kadr.address());
      await page.reload(); // the same address with another token loads no new page
      await until("the files", () => count(".file-row"));
      await page.click(".crumbs button >> nth=0");
      await until("the folder that is served", async () => (await count(".crumbs button")) === 1); // the last open program opens its own folder
      const folder = (await count('.file-row.folder .file-name:text-is("mill")')) ? "mill/" : "";
      const focused = () => page.evaluate(() => document.activeElement?.name ?? "");
      const told = () => text(".mill-told");
      await page.locator(".files-verbs button >> nth=0").focus();
      await page.keyboard.press("Enter");
      await until("the drawings", () => count("dialog option[value$='cover.txt']"));
      await until("the list of drawings has the focus", async () => (await focused()) === "drawing");
      const chosen = () => page.locator("[name=drawing]").inputValue();
      await until("the drawing", async () => {
        await page.keyboard.type(`${folder}cover.txt`);
        if ((await chosen()) === `${folder}cover.txt`) return true;
        await page.waitForTimeout(1200); // waits until the input is forgotten: a busy browser was too slow for it
        return false;
      });
      const field = async (name, value) => {
        for (let i = 0; i < 30 && (await focused()) !== name; i++) await page.keyboard.press("Tab");
        must((await focused()) === name, `Tab does not reach ${name}`);
        await page.keyboard.press("Control+a");
        await page.keyboard.type(value);
      };
      await until("what is missing", async () => (await told()).includes("Tool diameter"));
      await field("tool_diameter", "12");
      await field("depth", "8");
      await field("pass", "4");
      await until("the picture", () => count(".mill-picture:not([hidden])"));
      await until(
        "two layers",
        async () =>
          (await text(".mill-summary")).includes("2 × Z") && (await text(".mill-summary")).includes("islands: 2"),
      );
      must(
        await page.evaluate(() => {
          const i = document.querySelector(".mill-picture");
          return i.complete && i.naturalWidth > 200;
        }),
        "the picture is none",
      );
      await page.keyboard.press("Shift+Tab");
      await page.keyboard.type("0"); // Tab has selected all of it
      await until(
        "it is out of range",
        async () =>
          (await told()).includes("Depth: out of range") && (await count("[name=depth][aria-invalid=true]")) === 1,
      );
      must(await page.locator(".mill-result button.main").isDisabled(), "what is no program can be saved");
      await field("depth", "8");
      await field("pass", "2,5");
      await until("four layers", async () => (await text(".mill-summary")).includes("4 × Z"));
      await until("not dimmed", async () => !(await count("dialog.making")));
      await page.locator("dialog").screenshot({ path: join(pictures, "making.png") });
      for (
        let i = 0;
        i < 30 && !(await page.evaluate(() => document.activeElement?.matches(".mill-result button.main")));
        i++
      )
        await page.keyboard.press("Tab");
      await page.keyboard.press("Enter");
      await until("its name", async () => (await text(".topbar .file")) === `${folder}cover.nc`);
      await until("the dialogue is gone", async () => !(await count("dialog")));
      await ended();
      must(!(await count(".run-told.stopped")), "it does not run");
      await until("it is in the list", () => count('.file-row[aria-current] .file-name:text-is("cover.nc")'));
    },
    async "making: what is there is replaced only when told"() {
      await page.locator(".files-verbs button >> nth=0").click();
      await until(
        "what was given last is there",
        async () =>
          (await page.locator("[name=depth]").inputValue()) === "8" &&
          (await page.locator(".mill-result input").inputValue()).endsWith("cover_2.nc"),
      );
      await page.fill(".mill-result input", (await page.locator(".mill-result input").inputValue()).replace("_2", ""));
      await page.click(".mill-result button.main");
      await until("it is asked", () => count("dialog:has-text('Replace it') button.main:has-text('Replace it')"));
      await page.keyboard.press("Escape");
      await until("it is told", async () => /another name/.test((await text(".mill-result [role=alert]")) ?? ""));
      must(await count("dialog .mill"), "the dialogue has gone");
      await page.click(".mill-result button.main");
      await page.click("button.main:has-text('Replace it')");
      await until(
        "it is open",
        async () => !(await count("dialog")) && (await text(".topbar .file")).endsWith("cover.nc"),
      );
      await ended();
    },
    async "making: tape out and in gives the same text"() {
      const source = () => page.locator(".cm-content").textContent();
      const before = await source(),
        verbs = page.locator(".files-verbs button");
      await verbs.nth(1).click();
      await until("rows", async () => /\d rows/.test((await text(".tape [role=status]")) ?? ""));
      const tape = await page.locator(".tape input[aria-label='Name of the file']").inputValue();
      must(tape.endsWith("cover.tape"), `the name: ${tape}`);
      await page.screenshot({ path: join(pictures, "to_tape.png") });
      await page.click(".tape button.main");
      await until("it is saved, and in the list", () => count('.file-row .file-name:text-is("cover.tape")'));
      await verbs.nth(2).click();
      await until("the tape in the list", () => count(`.tape option[value='${tape}']`));
      await page.selectOption(".tape select[aria-label=Tape]", tape);
      await until("its text", async () => !(await page.locator(".tape-text").isHidden()));
      await page.screenshot({ path: join(pictures, "from_tape.png") });
      await page.click(".tape button.main");
      await until(
        "it is open",
        async () => !(await count("dialog")) && /cover_\d.nc$/.test(await text(".topbar .file")),
      );
      await ended();
      await until("the same text", async () => (await source()) === before);
    },
  };
}
