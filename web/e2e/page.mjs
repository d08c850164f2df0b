// What a user does, in a real browser: node e2e/page.mjs [EXAMPLES] [PICTURES]; KADR=…/kadr for the real server. Exit
// status 1 if a step fails. Waits are for conditions, with long limits: a busy machine is slow, not wrong. Steps that
// the server does not support are skipped with a message.
import { mkdirSync, statSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { browser, looks_at, must, until } from "./browser.mjs";
import { convert_steps } from "./convert_steps.mjs";
import { making_steps } from "./making_steps.mjs";
import { finger_steps, panel_steps } from "./panel_steps.mjs";
import { figure_steps } from "./figure_steps.mjs";
import { lathe_steps } from "./lathe_steps.mjs";
import { list_steps } from "./list_steps.mjs";
import { server } from "./server.mjs";
import { text_steps } from "./text_steps.mjs";

const examples = process.argv[2] ?? fileURLToPath(new URL("../../examples", import.meta.url));
const pictures = process.argv[3] ?? "/tmp/kadr-page";
mkdirSync(pictures, { recursive: true });
const kadr = await server(examples);
const { page, errors, close } = await browser();
await kadr.prepare(page);
const { count, text, ended, toasts, line_shown, kept, settled_view } = looks_at(() => page);
const now = async () => Number(await page.locator(".slider").getAttribute("aria-valuenow"));
const line = () => text(".state .block-told .dim");
const not_served = async () => /not served|ещё нет|не обслуж/i.test(await toasts());
/// Puts the cursor into a line of the text. The text may scroll to the slider's line while the mouse moves; then it
/// tries again.
async function click_line(begins) {
  await page.locator(".slider").focus();
  await page.keyboard.press("Home");
  await until("the start", async () => (await now()) === 0 && (await line_shown()) !== "");
  await until(`the cursor in ${begins}`, async () => {
    await page
      .locator(".cm-line", { hasText: begins })
      .first()
      .click({ position: { x: 30, y: 8 }, timeout: 5000 })
      .catch(() => {});
    return ((await page.locator(".cm-activeLine").first().textContent()) ?? "").startsWith(begins);
  });
}
/// Adds a last line. It presses Enter: the effect of a line feed in typed text would depend on the browser.
async function add_line(told) {
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+End");
  await page.keyboard.press("Enter");
  await page.keyboard.insertText(told);
}
/// Returns the text that the view shows at each of these positions, by synthetic pointer events: one position per
/// picture.
const told_at = (places) =>
  page.evaluate(async (all) => {
    const canvas = document.querySelector(".scene-host canvas"),
      tip = document.querySelector(".scene-tip"),
      told = [];
    for (const [clientX, clientY] of all) {
      canvas.dispatchEvent(new PointerEvent("pointermove", { clientX, clientY, pointerId: 1, bubbles: true }));
      await new Promise((r) => requestAnimationFrame(r));
      told.push(tip.hidden ? null : tip.textContent);
    }
    return told;
  }, places);
/// Moves the mouse over the view to a motion that `wanted` accepts; returns its position. The positions are from a
/// grid, each far from the next, so that few need to be tried.
async function find_motion(wanted = () => true) {
  const box = await page.locator(".scene-host canvas").boundingBox(),
    [columns, rows, step, batch] = [30, 24, 443, 20]; // step: no divisor in common with the number of positions
  const places = Array.from({ length: columns * rows }, (_, i) => (i * step) % (columns * rows)).map((k) => [
    box.x + (0.2 + 0.02 * (k % columns)) * box.width,
    box.y + (0.15 + 0.03 * Math.floor(k / columns)) * box.height,
  ]);
  for (let i = 0; i < places.length; i += batch) {
    const some = places.slice(i, i + batch),
      told = await told_at(some);
    for (const [k, at] of some.entries()) {
      if (told[k] === null || !wanted(told[k])) continue;
      await page.mouse.move(...at);
      const tip = () => page.locator(".scene-tip").evaluate((e) => (e.hidden ? null : e.textContent));
      const same = await until("the same by the mouse", async () => (await tip()) === told[k], 5000).catch(() => false);
      if (same) return at;
    }
  }
  throw new Error("no such motion found under the mouse");
}

const only = process.env.STEPS; // parts of step names, separated by |: only these steps run
const steps = {
  async "opens, and takes the token out of the address"() {
    await page.goto(kadr.address());
    await until("files", () => count(".file-row"));
    must(!page.url().includes("token"), "the token is still in the address");
  },
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
    if (!(await count('.file-name:text-is("xss.nc")'))) return "skipped: the made-up session has it in its one program";
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
  async "a long block does not push the figures out of the pane"() {
    const wide = await page.evaluate(() => {
      const block = document.querySelector(".block-text"),
        pane = block.closest(".pane-body"),
        was = block.textContent;
      block.textContent = "G1 X[#5*COS[#121]-#101*#2] Y[#5*SIN[#121]-#101*#3] ".repeat(4);
      const over = pane.scrollWidth - pane.clientWidth;
      block.textContent = was;
      return over;
    });
    must(wide <= 0, `${wide} px beyond the pane`);
  },
  async "views, cube, perspective, colours with their figures"() {
    await page.keyboard.press("6");
    await until("three faces", async () => (await count(".cube-face")) === 3);
    await page.locator(".cube-face", { hasText: "Top" }).first().click();
    await until("the cube has turned", async () => (await count(".cube-face")) === 1);
    await page.keyboard.press("6");
    for (const [value, told] of [
      ["speed", /mm\/min/],
      ["depth", /mm/],
      ["slowed", /100/],
      ["time", /\d:\d\d/],
      ["tool", /T1/],
      ["kind", /feed/],
    ]) {
      await page.selectOption(".scene-bar:not(.below) select", value);
      await until(`the legend of ${value}`, async () =>
        told.test((await page.locator(".scene-legend").textContent()) ?? ""),
      );
    }
    await page.click(".scene-bar button:has-text('Ortho')");
    await until("perspective", () => count(".scene-bar button:has-text('Persp')"));
    await find_motion();
    await page.click(".scene-bar button:has-text('Persp')");
    must(await count(".flag-start"), "no flag at the start");
    must(await count(".flag-end"), "no flag at the end");
  },
  async "turns, moves and zooms with the mouse and with two fingers"() {
    const canvas = page.locator(".scene-host canvas"),
      box = await canvas.boundingBox(),
      [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const seen = async () =>
      page.evaluate(() =>
        [...document.querySelectorAll(".flag-sign")].map((e) => e.style.transform + e.style.visibility).join(),
      );
    const changes = async (name, act) => {
      const before = await seen();
      await act();
      await until(name, async () => (await seen()) !== before);
    };
    await changes("turned", async () => {
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 60, y + 30, { steps: 4 });
      await page.mouse.up();
    });
    await changes("moved", async () => {
      await page.mouse.move(x, y);
      await page.mouse.down({ button: "right" });
      await page.mouse.move(x + 60, y, { steps: 4 });
      await page.mouse.up({ button: "right" });
    });
    await changes("zoomed", () => page.mouse.wheel(0, -240));
    const cdp = await page.context().newCDPSession(page),
      fingers = (type, points) =>
        cdp.send("Input.dispatchTouchEvent", {
          type,
          touchPoints: points.map(([px, py], id) => ({ x: px, y: py, id })),
        });
    await changes("pinched", async () => {
      await fingers("touchStart", [[x - 40, y]]);
      await fingers("touchStart", [
        [x - 40, y],
        [x + 40, y],
      ]);
      for (let i = 1; i <= 5; i++)
        await fingers("touchMove", [
          [x - 40 - 12 * i, y],
          [x + 40 + 12 * i, y],
        ]);
      await fingers("touchEnd", []);
    });
    await changes("moved by two fingers", async () => {
      await fingers("touchStart", [[x - 40, y]]);
      await fingers("touchStart", [
        [x - 40, y],
        [x + 40, y],
      ]);
      for (let i = 1; i <= 5; i++)
        await fingers("touchMove", [
          [x - 40, y + 10 * i],
          [x + 40, y + 10 * i],
        ]);
      await fingers("touchEnd", []);
    });
    await page.locator(".slider").focus();
    await page.keyboard.press("f");
  },
  async "a picture as PNG"() {
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.click(".scene-bar.below button:has-text('PNG')"),
    ]);
    const file = join(pictures, "view.png");
    await download.saveAs(file);
    must(statSync(file).size > 3000, "the picture is empty");
  },
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
    if (await count("details.problem-group.alarm:not([open])")) await page.click("details.problem-group.alarm summary");
    await until("its hint", async () => (await text(".problems .alarm .hint")).length > 5);
    await page.screenshot({ path: join(pictures, "alarm.png") });
    for (let i = 0; i < 5 && (await count(".dirty")); i++) {
      await page.locator(".cm-content").focus();
      await page.keyboard.press("Control+z");
    }
    await until("the old text", async () => !(await count(".dirty")));
    await until("no alarm any more", async () => !(await count(".problems .alarm")));
  },
  async "cuts, shows the part at an instant"() {
    await page.click("[data-tab=cut_tab]");
    await until("the form", () => count(".cut-run button"));
    await page.click(".cut-run button");
    await until("what is left", async () => (await count(".cut .facts")) || (await not_served()), 120_000);
    if (await not_served()) return "skipped: not served yet";
    await page.keyboard.press("Escape");
    await page.locator(".slider").focus();
    await page.keyboard.press("End");
    await until(
      "the part at the end",
      async () => /\d/.test((await page.locator(".cut .note").allTextContents()).join(" ")),
      60_000,
    );
    await until("the end", async () => (await now()) > 1);
    await settled_view(); // the previous part may still arrive
    const whole = (await page.locator(".cut .note").allTextContents()).join(" ");
    await page.keyboard.press("Home");
    await until(
      "another part at the start",
      async () => (await page.locator(".cut .note").allTextContents()).join(" ") !== whole,
      60_000,
    );
    await page.screenshot({ path: join(pictures, "cut.png") });
  },
  async "section and measuring"() {
    await page.selectOption(".scene-bar.below select", "0");
    await until("the place of the section", async () => /X/.test(await text(".section-told")));
    const told = await text(".section-told");
    await page.locator(".scene-bar.below input[type=range]").fill("0.8");
    await until("another place", async () => (await text(".section-told")) !== told);
    await page.click(".scene-bar.below button.icon");
    await page.selectOption(".scene-bar.below select", "");
    await page.locator(".slider").focus();
    await page.keyboard.press("1");
    await page.keyboard.press("m");
    must((await text(".scene-told")).length > 5, "measuring does not say how");
    const first = await find_motion((t) => /feed/.test(t)),
      line_of = async () => /line (\d+)/.exec((await page.locator(".scene-tip").textContent()) ?? "")?.[1];
    const here = await line_of();
    await page.mouse.click(...first);
    await until("the first end", async () => /now the second/.test(await text(".scene-told")));
    const second = await find_motion((t) => !t.startsWith(`line ${here} `) && /feed|arc/.test(t));
    await page.mouse.click(...second);
    await until("the distance", async () => /Distance \d+\.\d{3}/.test(await text(".scene-told")));
    const arc = await find_motion((t) => / R \d/.test(t)).catch(() => null);
    if (arc) {
      await page.mouse.click(...arc);
      await until("an end of the arc or its centre", async () => /Centre R|Point/.test(await text(".scene-told")));
    }
    await page.keyboard.press("Escape");
    must((await text(".scene-told")) === "", "measuring does not end");
  },
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
  async "two versions side by side"() {
    await page.click(".topbar button:has-text('Compare')");
    await until("the other programs", () => count(".compare option"));
    await page.selectOption(".compare select", { index: 0 });
    await page.click(".compare button.main");
    await until(
      "what differs",
      async () => (await not_served()) || !["", "Comparing…"].includes(((await text(".compare .note")) ?? "").trim()),
      60_000,
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
  async "rotary axes turn the part, and what is cut of it"() {
    if (!process.env.KADR) return "skipped: the made-up session has no rotary axes";
    await page.goto(`${new URL(kadr.address()).origin}/`);
    await until("the files", () => count(".file-row"));
    if (!only) await ended(); // the program that was open before the reload has opened again, with its folder
    await page.click(".crumbs button >> nth=0");
    for (const name of ["five-axes", "trunnion_drilling.nct"]) await page.click(`.file-row:has-text('${name}')`);
    await ended();
    for (const [which, value] of [
      ["control", "nct"],
      ["machine", "table-table"],
    ]) {
      await page.selectOption(`.choices select[aria-label='${which === "control" ? "Control" : "Machine"}']`, value);
      await page.waitForTimeout(300);
      await ended();
    }
    await page.fill(".choices input", "five-axes/trunnion_drilling.json");
    await page.keyboard.press("Enter");
    await until("the program without an alarm", () => count(".run-told.ended"), 60_000);
    const slider = await page.locator(".slider").boundingBox();
    await page.mouse.click(slider.x + 0.62 * slider.width, slider.y + slider.height / 2);
    const tick = async () => {
      await page.click(".filters summary");
      await page.locator(".filters label:has-text('The part turns')").click();
      await page.click(".filters summary"); // the list covers the view, and would be in its picture
      await page.locator(".slider").hover();
    };
    await page.locator(".slider").hover();
    const turned = await settled_view();
    await page.screenshot({ path: join(pictures, "turned.png") });
    await tick();
    await until("the part does not turn any more", async () => !(await settled_view()).equals(turned));
    await page.screenshot({ path: join(pictures, "not_turned.png") });
    await tick();
    await until("it turns again", async () => (await settled_view()).equals(turned));
    await page.click("[data-tab=cut_tab]");
    await until("the form", () => count(".cut-run button"));
    await page.click(".cut-run button");
    await until("what is left", () => count(".cut .facts"), 120_000);
    await page.screenshot({ path: join(pictures, "turned_cut.png") });
  },
  ...text_steps({ kadr, page, pictures, only }),
  ...figure_steps({ kadr, page, pictures, only }),
  ...lathe_steps({ kadr, page, pictures, only }),
  ...list_steps({ kadr, page, pictures, examples, only }),
  ...panel_steps({ kadr, page, pictures, only }),
  ...making_steps({ kadr, page, pictures }),
  ...convert_steps({ kadr, page, pictures }),
  ...finger_steps({ kadr, browser: page.context().browser(), pictures }),
};

let passed = 0,
  failed = 0,
  skipped = 0;
for (const [name, step] of Object.entries(steps)) {
  if (only && !only.split("|").some((part) => name.includes(part)) && !name.startsWith("opens")) continue;
  const begin = Date.now();
  try {
    const note = await step();
    if (/^skipped/.test(note ?? "")) skipped++;
    else passed++;
    console.log(`ok    ${name}${note ? ` (${note})` : ""}  ${Date.now() - begin} ms`);
  } catch (e) {
    failed++;
    console.log(`FAIL  ${name}: ${e.message.split("\n")[0]}; said: ${await toasts().catch(() => "")}`);
    await page.screenshot({ path: join(pictures, `fail_${failed}.png`) }).catch(() => {});
  }
}
if (errors.length) {
  failed++;
  console.log("errors on the page:", errors);
}
await close();
await kadr.close();
console.log(`${passed} passed, ${failed} failed${skipped ? `, ${skipped} skipped` : ""}`);
process.exit(failed ? 1 : 0);
