// The extension in a real editor: code-server (or another server of VS Code) in Chromium, with the extension installed.
//   node e2e/editor.mjs ADDRESS FOLDER PICTURES     FOLDER holds rounded_plate.nc of examples/fanuc; it is changed
// Checks findings, hover, the view of the path in both directions, and the debugger, and takes their pictures.
// PLAYWRIGHT: folder of the package playwright-core (default: that of the page's build).
import { createRequire } from "node:module";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [address, folder, pictures] = process.argv.slice(2);
const { chromium } = createRequire(import.meta.url)(process.env.PLAYWRIGHT ?? "playwright-core");
const profile = mkdtempSync(join(tmpdir(), "kadr-editor-"));
const context = await chromium.launchPersistentContext(profile, {
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  // As in web/e2e/browser.mjs: no software GPU for the page itself, only for WebGL.
  args: [
    "--no-sandbox",
    "--no-first-run",
    "--disable-gpu-compositing",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
  ],
  viewport: { width: 1400, height: 860 },
  locale: "en-GB",
});
const page = context.pages()[0] ?? (await context.newPage());
page.setDefaultTimeout(120_000);
let failed = 0;

async function step(name, f) {
  try {
    await f();
    console.log(`ok: ${name}`);
  } catch (e) {
    failed++;
    console.log(`FAILED: ${name}: ${e.message.split("\n")[0]}`);
    await page.screenshot({ path: join(pictures, `failed_${failed}.png`) });
  }
}
const must = (yes, what) => {
  if (!yes) throw new Error(what);
};
async function until(what, f, ms = 60_000) {
  for (const end = Date.now() + ms; ;) {
    const got = await f();
    if (got) return got;
    if (Date.now() > end) throw new Error(`no ${what} within ${ms} ms`);
    await new Promise((r) => setTimeout(r, 200));
  }
}
async function command(name) {
  await page.keyboard.press("F1");
  await page.locator(".quick-input-box input").first().fill(`>${name}`);
  await page.locator(".quick-input-list .monaco-list-row").first().waitFor();
  await page.keyboard.press("Enter");
}
async function go_to_line(line) {
  await page.keyboard.press("Control+g");
  await page.locator(".quick-input-box input").first().fill(`:${line}`);
  await page.keyboard.press("Enter");
}
const cursor_line = async () => Number(await page.locator(".line-numbers.active-line-number").first().innerText());
/// The keyboard goes to the program, not to the view.
const focus_program = () => page.keyboard.press("Control+1");
const picture = (name) => page.screenshot({ path: join(pictures, `${name}.png`) });
/// The frame of the report inside the frames of a webview.
async function view() {
  for (const frame of page.frames())
    if (
      await frame
        .locator(".scene-host canvas")
        .count()
        .catch(() => 0)
    )
      return frame;
  return null;
}

await step("the program opens", async () => {
  await page.goto(`${address}/?folder=${encodeURIComponent(folder)}`);
  await page.locator(".monaco-workbench").waitFor();
  await until("file", () => page.locator(".explorer-folders-view .monaco-list-row").count());
  await page.getByText("rounded_plate.nc", { exact: true }).first().dblclick();
  await page.locator(".monaco-editor .view-lines").first().waitFor();
  await until("language", async () => /^NC/.test(await page.locator("[id='status.editor.mode']").innerText()));
});
await step("the control that the text shows gives the colours", () =>
  until("language of the control", async () =>
    /^NC: .*Fanuc/.test(await page.locator("[id='status.editor.mode']").innerText()),
  ),
);
await step("a word is explained", async () => {
  const word = page.locator(".view-line", { hasText: "G41" }).locator("span", { hasText: "G41" }).last();
  await until("hover", async () => {
    await page.mouse.move(5, 5);
    await word.hover();
    return page
      .locator(".monaco-hover", { hasText: "tool radius compensation" })
      .first()
      .waitFor({ timeout: 5000 })
      .then(
        () => true,
        () => false,
      );
  });
  await picture("hover");
});
await step("a wrong word is underlined", async () => {
  await go_to_line(13);
  await page.keyboard.press("End");
  await page.keyboard.type(" Q");
  await page.locator(".squiggly-error").first().waitFor();
  for (let i = 0; i < 2; i++) await page.keyboard.press("Backspace");
  await until("end of the error", async () => !(await page.locator(".squiggly-error").count()));
});
await step("the path is shown, and follows the cursor", async () => {
  await command("Kadr: Show the path");
  const frame = await until("view", view);
  const clock = () => frame.locator(".clock").innerText();
  await until("path", async () => /[1-9]/.test(await clock()));
  await page
    .locator(".view-lines")
    .first()
    .click({ position: { x: 300, y: 300 } });
  await go_to_line(12);
  const before = await clock();
  await go_to_line(17);
  await until("other instant", async () => (await clock()) !== before);
  await go_to_line(11);
  await page.keyboard.press("Control+b"); // more room for the picture
  await new Promise((r) => setTimeout(r, 2000));
  await picture("path");
});
await step("the cursor follows the view", async () => {
  const frame = await view();
  const before = await cursor_line();
  await frame.locator(".play button").nth(3).click();
  await until("other line", async () => (await cursor_line()) > before);
});
await step("a program is debugged", async () => {
  await focus_program();
  await go_to_line(10);
  await command("Debug: Toggle Breakpoint");
  await page.keyboard.press("F5");
  await page.locator(".debug-toolbar").waitFor();
  await until("stop on entry", () =>
    page.locator(".debug-top-stack-frame-line, .debug-call-stack .stack-frame").count(),
  );
  await page.keyboard.press("F5");
  await until(
    "stop at the breakpoint",
    async () => (await page.locator(".debug-top-stack-frame-line").count()) && (await cursor_line()) === 10,
  );
  await new Promise((r) => setTimeout(r, 1500));
  await picture("debugger");
  await command("Debug: Stop");
});
await context.close();
rmSync(profile, { recursive: true, force: true });
process.exit(failed ? 1 : 0);
