// What a user does with files: new, another name, the trash and back, dropped on the page; nothing unsaved is lost, and
// what others change on the disk is noticed. Used by page.mjs.
import { appendFileSync, existsSync, mkdirSync, readdirSync, readFileSync, unlinkSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { looks_at, must, until } from "./browser.mjs";
import { hands_on } from "./hands.mjs";

const skipped = "skipped: the made-up session has no folder";

export function file_steps({ kadr, page, pictures, only }) {
  const { count, text, ended, toasts } = looks_at(() => page);
  const { add_line } = hands_on(page);
  const doc = () => page.locator(".cm-content").textContent();
  const row = (name) => page.locator(`.file-row:has(.file-name:text-is("${name}"))`);
  const on_disk = (name) => join(kadr.folder, "files", name);
  const program = (comment) => `%\nO0001 (${comment})\nG21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX20 F300\nG0 Z5\nM30\n%\n`;
  async function in_folder() {
    mkdirSync(join(kadr.folder, "files"), { recursive: true });
    writeFileSync(on_disk("one.nc"), program("ONE"));
    await page.goto(`${new URL(kadr.address()).origin}/`);
    await until("the files", () => count(".file-row"));
    if (!only) await ended();
    await page.click(".crumbs button >> nth=0");
    await row("files").click();
    await until("the folder", () => row("one.nc").count());
  }
  async function open(name) {
    await row(name).click();
    await until(`the text of ${name}`, async () => (await text(".source .pane-title")).includes(name));
    await ended();
  }
  const menu = async (name, verb) => {
    await page.click(`.file-list li:has(.file-name:text-is("${name}")) .file-menu`);
    await page.click(`.row-menu button:has-text("${verb}")`);
  };
  const type_name = async (name) => {
    await until("the dialogue", () => count(".name-dialog input"));
    await page.fill(".name-dialog input", name);
    await page.keyboard.press("Enter");
  };
  const dropped = (files) =>
    page.evaluate((all) => {
      const data = new DataTransfer();
      for (const [name, content] of all) data.items.add(new File([content], name));
      for (const kind of ["dragover", "drop"])
        document
          .querySelector(".scene")
          .dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
    }, files);

  return {
    async "a new program begins as its control requires; a bad name is told beside it"() {
      if (!kadr.folder) return skipped;
      await in_folder();
      await page.click(".files button:has-text('New…')");
      await until("the dialogue", () => count(".name-dialog select"));
      await page.selectOption(".name-dialog select", "haas");
      for (const bad of ["../out.nc", "CON.nc", "a:b.nc", "part.exe", "ONE.NC"]) {
        await page.fill(".name-dialog input", bad);
        await page.keyboard.press("Enter");
        await until(`${bad} refused`, async () => ((await text(".name-dialog .error")) ?? "").length > 5);
      }
      await page.screenshot({ path: join(pictures, "new_program.png") });
      await type_name("fresh.nc");
      await until("opened", async () => (await text(".source .pane-title")).includes("files/fresh.nc"));
      await ended();
      must(/^%O00001N10 G17 G90/.test(await doc()), `not as a Haas wants it: ${await doc()}`);
      must((await page.locator(".choices select").first().inputValue()) === "haas", "another control");
    },
    async "another name, a copy, the trash, and back"() {
      if (!kadr.folder) return skipped;
      await menu("fresh.nc", "Rename");
      await type_name("renamed.nc");
      await until("its new name", async () => (await text(".source .pane-title")).includes("files/renamed.nc"));
      must(existsSync(on_disk("renamed.nc")) && !existsSync(on_disk("fresh.nc")), "not renamed on the disk");
      await ended();
      await menu("renamed.nc", "Duplicate");
      await type_name("copy.nc");
      await until("the copy", () => row("copy.nc").count());
      await row("copy.nc").focus();
      await page.keyboard.press("Delete");
      await until("it is gone", async () => !(await row("copy.nc").count()));
      must(readdirSync(join(kadr.folder, ".kadr-trash")).length === 1, "it is not in the trash");
      await page.screenshot({ path: join(pictures, "deleted.png") });
      await page.locator(".slider").focus();
      await page.keyboard.press("Shift+Slash");
      await until("help", () => count("dialog:modal"));
      await page.click(".toast:has-text('trash') button"); // a dialogue does not cover it
      await page.keyboard.press("Escape");
      await until("help is closed", async () => !(await count("dialog")));
      await until("it is back", () => row("copy.nc").count());
      must(existsSync(on_disk("copy.nc")), "not back on the disk");
    },
    async "the trash: put back, deleted for good"() {
      if (!kadr.folder) return skipped;
      for (const name of ["copy.nc", "one.nc"]) {
        await row(name).focus();
        await page.keyboard.press("Delete");
        await until(`${name} is gone`, async () => !(await row(name).count()));
      }
      await page.click(".files-verbs button:has-text('Trash')");
      await until("both", async () => (await count(".trash tbody tr")) === 2);
      await page.screenshot({ path: join(pictures, "trash.png") });
      await page.click(".trash tr:has-text('one.nc') button:has-text('Put back')");
      await until("one left", async () => (await count(".trash tbody tr")) === 1);
      must(existsSync(on_disk("one.nc")), "not back on the disk");
      await page.click(".dialog-head button:has-text('Empty')");
      await page.click(".dialog-body button:has-text('Empty the trash')");
      await until("empty", async () => !(await count(".trash tbody tr")));
      must(!readdirSync(join(kadr.folder, ".kadr-trash")).length, "the file is not gone");
      await page.keyboard.press("Escape");
      await until("closed", async () => !(await count(".trash")));
      writeFileSync(on_disk("copy.nc"), program("COPY"));
    },
    async "the report of the open program is saved as a file"() {
      if (!kadr.folder) return skipped;
      const [saved] = await Promise.all([
        page.waitForEvent("download"),
        page.click(".topbar button:has-text('Report')"),
      ]);
      const file = join(pictures, "page_report.html");
      await saved.saveAs(file);
      must(saved.suggestedFilename() === "renamed.html", `its name: ${saved.suggestedFilename()}`);
      const html = readFileSync(file, "utf8");
      must(html.startsWith("<!doctype html>") && html.includes("kadr-data"), "no report");
    },
    async "dropped on the page: copied and opened; a second of its name is asked about"() {
      if (!kadr.folder) return skipped;
      await dropped([["dropped.nc", program("DROPPED")]]);
      await until("opened", async () => (await text(".source .pane-title")).includes("files/dropped.nc"));
      await ended();
      must(readFileSync(on_disk("dropped.nc"), "utf8") === program("DROPPED"), "other bytes");
      await dropped([["dropped.nc", program("SECOND")]]);
      await page.click("dialog button:has-text('Keep both')");
      await until("the second", async () => (await text(".source .pane-title")).includes("files/dropped_2.nc"));
      await ended();
      await dropped([["dropped.nc", program("THIRD")]]);
      await page.click("dialog button:has-text('Replace')");
      await until("the third", async () => (await doc()).includes("THIRD"));
      await ended();
      await dropped([["photo.png", "x"]]);
      await until("refused", async () => /photo\.png/.test(await toasts()));
      must(!existsSync(on_disk("photo.png")), "a picture was copied");
    },
    async "renamed with unsaved changes, they go along and are saved under the new name"() {
      if (!kadr.folder) return skipped;
      await open("one.nc");
      await add_line("(NOT SAVED)");
      await until("unsaved", () => count(".dirty"));
      await menu("one.nc", "Rename");
      await type_name("two.nc");
      await until("its new name", async () => (await text(".source .pane-title")).includes("files/two.nc"));
      await ended();
      must((await count(".dirty")) && (await doc()).includes("NOT SAVED"), "the changes are lost");
      await page.waitForTimeout(500);
      await page.reload();
      await ended();
      await until("the changes", async () => (await doc()).includes("NOT SAVED"));
      await page.locator(".cm-content").focus();
      await page.keyboard.press("Control+s");
      await until("saved", async () => !(await count(".dirty")));
      must(readFileSync(on_disk("two.nc"), "utf8").includes("NOT SAVED"), "not on the disk");
      await ended();
    },
    async "changed on the disk: noticed, compared, taken; deleted there: saved again"() {
      if (!kadr.folder) return skipped;
      appendFileSync(on_disk("two.nc"), "(BY SOMEBODY)\n");
      await until("noticed", () => page.locator(".disk-notice").isVisible());
      await page.click(".disk-notice button:has-text('Compare')");
      await until("compared", async () => /differ|equal/i.test(await text(".compare .note")));
      await page.screenshot({ path: join(pictures, "disk.png") });
      await page.click("dialog.docked .dialog-head button");
      await page.click(".disk-notice button:has-text('Take it')");
      await until("taken", async () => (await doc()).includes("BY SOMEBODY") && !(await count(".dirty")));
      await until("no notice", async () => !(await page.locator(".disk-notice").isVisible()));
      await ended();
      await add_line("(MINE)");
      appendFileSync(on_disk("two.nc"), "(AGAIN)\n");
      await until("noticed", () => page.locator(".disk-notice").isVisible());
      await page.click(".disk-notice button:has-text('Keep mine')");
      await page.locator(".cm-content").focus();
      await page.keyboard.press("Control+s");
      await until("saved", async () => !(await count(".dirty")));
      must(/MINE/.test(readFileSync(on_disk("two.nc"), "utf8")), "mine is not on the disk");
      must(!/AGAIN/.test(readFileSync(on_disk("two.nc"), "utf8")), "not mine is on the disk");
      await ended();
      unlinkSync(on_disk("two.nc"));
      await until("told", () => page.locator(".disk-notice button:has-text('Save it again')").isVisible());
      await page.click(".disk-notice button");
      await until("it is there again", () => existsSync(on_disk("two.nc")));
      await until("no notice", async () => !(await page.locator(".disk-notice").isVisible()));
      await ended();
    },
    async "saved as another file, which is opened"() {
      if (!kadr.folder) return skipped;
      await add_line("(FOR THE OTHER)");
      await page.keyboard.press("Control+Shift+s");
      await type_name("other.nc");
      await until("opened", async () => (await text(".source .pane-title")).includes("files/other.nc"));
      await ended();
      must(readFileSync(on_disk("other.nc"), "utf8").includes("FOR THE OTHER"), "not on the disk");
      must(!readFileSync(on_disk("two.nc"), "utf8").includes("FOR THE OTHER"), "the first one has changed");
    },
  };
}
