// The page for people who cannot see it or use no mouse: axe-core finds no serious or critical violation on the page,
// the operator's screen and open dialogues, in both themes. Used by page.mjs.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { looks_at, must, until } from "./browser.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

export function access_steps({ kadr, page }) {
  const { count, ended } = looks_at(() => page);
  /// Returns the serious and critical violations of what is shown now, each with its first places.
  async function violations(where) {
    await page.evaluate(axe);
    return page.evaluate(async (name) => {
      const found = await window.axe.run(document, { resultTypes: ["violations"] });
      return found.violations
        .filter((v) => ["serious", "critical"].includes(v.impact))
        .map((v) => {
          const places = v.nodes.slice(0, 3).map((n) => `${n.html.slice(0, 120)} [${n.any[0]?.message ?? ""}]`);
          return `${name}: ${v.id} (${v.impact}, ${v.nodes.length}) ${places.join(" | ")}`;
        });
    }, where);
  }
  const dark = (on) =>
    page.evaluate((is) => {
      document.documentElement.dataset.theme = is ? "dark" : "light";
    }, on);
  async function clean(...wheres) {
    const all = [];
    for (const [name, go] of wheres) {
      await go();
      for (const theme of ["light", "dark"]) {
        await dark(theme === "dark");
        await page.waitForTimeout(200); // colours change softly
        all.push(...(await violations(`${name}, ${theme}`)));
      }
      await dark(false);
    }
    must(!all.length, all.join(" ## "));
  }
  const dialog = (button) => [
    button,
    async () => {
      await page.keyboard.press("Escape");
      await until("no dialogue", async () => !(await count("dialog[open]")));
      await page.click(`button:has-text('${button}') >> visible=true`);
      await until("a dialogue", () => count("dialog[open]"));
      await page.waitForTimeout(300);
    },
  ];
  const open_step = async () => {
    if (await count(".crumbs button")) await page.click(".crumbs button >> nth=0");
    for (const name of ["cut", "step.nc"]) await page.click(`.file-row:has(.file-name:text-is("${name}"))`);
  };
  return {
    async "no serious fault of access: the page and its tabs"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await page.goto(`${new URL(kadr.address()).origin}/`);
      await until("the files", () => count(".file-row"));
      await clean(["nothing open", async () => {}]);
      await open_step();
      await ended();
      const tab = (name) => [name, () => page.click(`.page [data-tab=${name}]`)];
      await clean(tab("problems"), tab("summary"), tab("cut_tab"), tab("panel"));
      await page.click(".operator button:has-text('Switch on')");
      await until("it is on", () => count(".operator .mode.standing"));
      for (const details of ["tables", "restart", "watches", "shift"]) await page.click(`.${details} > summary`);
      await clean(["panel, all open", () => page.waitForTimeout(500)]);
    },
    async "no serious fault of access: dialogues"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await clean(
        ["keys", () => page.click(".topbar [aria-label='Keys']")],
        dialog("Set-up sheet"),
        dialog("Compare"),
        dialog("New from a drawing"),
        dialog("To tape"),
        dialog("Convert to another control"),
      );
      await page.keyboard.press("Escape");
    },
    async "no serious fault of access: the operator's screen"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      await page.setViewportSize({ width: 1024, height: 768 });
      await page.goto(`${new URL(kadr.address()).origin}/?operator`);
      await until("the screen", () => page.locator(".operator-screen").isVisible());
      await clean(["off", async () => {}]);
      await page.click(".program-tab button:has-text('Files')");
      await open_step();
      await page.click(".big-keys button:has-text('Switch on')");
      await until("it stands", () => count(".screen-head .mode.standing"));
      const tab = (name) => [name, () => page.click(`.operator-screen [data-tab=${name}]`)];
      await clean(...["op_program", "op_manual", "op_tool_zero", "op_messages", "op_restart"].map(tab));
      await page.keyboard.press("F1");
      await until("emergency", () => count(".screen-head .mode.emergency"));
      await clean(["emergency stop", async () => {}]);
      await page.click(".big-keys button:has-text('Reset')");
      await until("it stands", () => count(".screen-head .mode.standing"));
      await page.keyboard.press("o");
      await page.setViewportSize({ width: 1600, height: 1000 });
    },
  };
}
