// What a user does, in a real browser: node e2e/page.mjs [EXAMPLES] [PICTURES]; KADR=…/kadr for the real server, GROUP=…
// for one group of steps, STEPS=… for the steps of these names. Exit status 1 if a step fails. Waits are for conditions,
// with long limits: a busy machine is slow, not wrong. UNTIL_FAILURE=1 ends at the first step that fails. Steps that the server
// does not support are skipped with a message.
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { access_steps } from "./access_steps.mjs";
import { browser, looks_at, must, until } from "./browser.mjs";
import { convert_steps } from "./convert_steps.mjs";
import { edit_steps } from "./edit_steps.mjs";
import { making_steps } from "./making_steps.mjs";
import { channel_steps } from "./channel_steps.mjs";
import { finger_steps } from "./finger_steps.mjs";
import { panel_steps } from "./panel_steps.mjs";
import { program_steps } from "./program_steps.mjs";
import { real_steps } from "./real_steps.mjs";
import { restart_steps } from "./restart_steps.mjs";
import { table_steps } from "./table_steps.mjs";
import { hand_steps } from "./hand_steps.mjs";
import { screen_steps } from "./screen_steps.mjs";
import { setup_steps } from "./setup_steps.mjs";
import { rotary_steps } from "./rotary_steps.mjs";
import { file_steps } from "./file_steps.mjs";
import { live_steps } from "./live_steps.mjs";
import { figure_steps } from "./figure_steps.mjs";
import { lathe_steps } from "./lathe_steps.mjs";
import { list_steps } from "./list_steps.mjs";
import { operator_day } from "./operator_day.mjs";
import { operator_steps } from "./operator_steps.mjs";
import { outline_steps } from "./outline_steps.mjs";
import { picture_steps } from "./picture_steps.mjs";
import { server } from "./server.mjs";
import { text_steps } from "./text_steps.mjs";

const examples = process.argv[2] ?? fileURLToPath(new URL("../../examples", import.meta.url));
const pictures = process.argv[3] ?? "/tmp/kadr-page";
mkdirSync(pictures, { recursive: true });
const kadr = await server(examples);
const { page, errors, close } = await browser();
await kadr.prepare(page);
const { count, toasts } = looks_at(() => page);

const only = process.env.STEPS; // parts of step names, separated by |: only these steps run
const wanted = process.env.GROUP; // the name of a group of steps: only its steps run
const first = {
  async "opens, and takes the token out of the address"() {
    await page.goto(kadr.address());
    await until("files", () => count(".file-row"));
    must(!page.url().includes("token"), "the token is still in the address");
  },
};
const alone = only || (wanted && wanted !== "view"); // no program is open when a group begins
const place = { kadr, page, pictures, examples, only: alone };
// Each group runs alone, in a browser of its own (tests/page_in_browser.py), or all of them in this order. The build reads
// this line: each name is a test.
const group_names = [
  "view",
  "files",
  "text",
  "figures",
  "setup",
  "panel",
  "live",
  "making",
  "hand",
  "operator",
  "real",
];
const groups = {
  view: { ...program_steps(place), ...rotary_steps({ kadr, page, pictures, only }) },
  files: file_steps(place),
  text: { ...text_steps(place), ...edit_steps(place), ...outline_steps(place) },
  figures: { ...figure_steps(place), ...lathe_steps(place) },
  setup: setup_steps(place),
  panel: {
    ...list_steps(place),
    ...restart_steps(place),
    ...table_steps(place),
    ...channel_steps(place),
    ...panel_steps(place),
  },
  live: live_steps(place),
  making: {
    ...making_steps(place),
    ...convert_steps(place),
    ...finger_steps({ kadr, browser: page.context().browser(), pictures }),
  },
  hand: { ...hand_steps(place), ...screen_steps(place) },
  operator: {
    ...operator_steps(place),
    ...access_steps(place),
    ...picture_steps(place),
    ...operator_day({ kadr, browser: page.context().browser(), pictures }),
  },
  real: real_steps(place),
};
must(String(Object.keys(groups)) === String(group_names), "group_names does not name the groups");
const chosen = Object.entries(groups).filter(([name]) => !wanted || name === wanted);
if (!chosen.length) throw new Error(`no group ${wanted}: ${Object.keys(groups).join(", ")}`);
const steps = Object.assign({}, first, ...chosen.map(([, of_group]) => of_group));

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
    if (process.env.UNTIL_FAILURE) break; // the steps that follow find another page than they expect, and wait for it in vain
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
