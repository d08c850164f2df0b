// A real machine at its panel: the double of a Grbl controller behind a pseudo-terminal. Used by page.mjs.
import { join } from "node:path";
import { at_panel } from "./at_panel.mjs";
import { looks_at, must, until } from "./browser.mjs";

const skipped = "skipped: there is no double of a controller";
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

export function real_steps(place) {
  const { kadr, page, pictures } = place,
    { count, text } = looks_at(() => page),
    panel = at_panel(place);
  const double = () => kadr.double;
  const shows = (what) => until(what, async () => ((await text(".operator")) ?? "").includes(what));

  /// A picture of the page, with that part of the pane in view.
  async function picture(name, part) {
    await page
      .locator(part)
      .first()
      .evaluate((e) => e.scrollIntoView({ block: "start" }));
    await page.screenshot({ path: join(pictures, name) });
  }

  async function switch_on() {
    await panel.open("real.nc");
    await page.click("[data-tab=panel]");
    await page.click(".real-machine > summary");
    await page.selectOption(".real-machine select", double().port);
    await page.click(".real-machine button:has-text('Compare')");
    await until("the proof", () => count(".proof tr.equal"));
  }

  return {
    async "a real machine: the port, the proof, the panel"() {
      if (!double()) return skipped;
      double().tell("set 32 1");
      await switch_on();
      await until("laser mode is refused", () => count(".proof tr.refused:has-text('laser')"));
      must(
        await page.locator(".real-machine button:has-text('Switch the real')").isDisabled(),
        "a refused row must be accepted",
      );
      await picture("real_proof.png", ".real-machine");
      double().tell("set 32 0");
      await page.click(".real-machine button:has-text('Compare')");
      await until(
        "nothing is refused",
        async () => (await count(".proof tr.equal")) && !(await count(".proof tr.refused")),
      );
      await page.click(".real-machine button:has-text('Switch the real')");
      await panel.mode("standing");
      await shows("Idle");
      await panel.key("Start");
      await panel.mode("running");
      await until("it moves", async () => (await panel.position("X")) > 2);
      await panel.key("Hold");
      await panel.mode("held");
      await picture("real_panel.png", ".operator-head");
      const there = await panel.position("X");
      await sleep(400);
      must(Math.abs((await panel.position("X")) - there) < 0.01, "held, and it moves");
      await panel.key("Start");
      await panel.mode("running");
      await panel.stop_and_reset();
      must((await text("button.emergency")) === "Stop", "it is no emergency stop");
      must(!(await page.locator(".operator button:has-text('Undo')").isVisible()), "a real machine cannot go back");
    },
    async "a page that nobody sees holds the real machine"() {
      if (!double()) return skipped;
      await panel.key("Start");
      await panel.mode("running");
      const hide = (hidden) =>
        page.evaluate((is) => Object.defineProperty(document, "hidden", { configurable: true, get: () => is }), hidden);
      await hide(true);
      await sleep(4500);
      await hide(false);
      await panel.mode("held");
      await shows("has not been heard");
      await panel.key("Start");
      await panel.mode("running");
    },
    async "a pulled cable is an alarm, and nothing goes on by itself"() {
      if (!double()) return skipped;
      double().tell("unplug");
      await panel.mode("alarm");
      await shows("No connection");
      must(await page.locator(".operator-keys button:has-text('Start')").isDisabled(), "Start after a pulled cable");
      await picture("real_lost.png", ".operator-head");
      await panel.switch_off();
    },
  };
}
