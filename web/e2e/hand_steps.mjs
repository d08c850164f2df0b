// Axes by hand at the operator's screen: wheel, keys of the keyboard, zero, ways to the zero and home. Used by page.mjs.
import { at_screen } from "./at_screen.mjs";
import { must, until } from "./browser.mjs";

export function hand_steps(place) {
  const { page } = place,
    screen = at_screen(place);
  const step = (size) => page.click(`.jog-choices .switch button:text-is('${size}')`);
  const jog = (axis, sign) => page.click(`button.jog[aria-label='${axis} ${sign}']`);
  async function jog_by_ten(axis) {
    const from = (await screen.position())[axis];
    await jog(axis, "+");
    await until(`${axis} 10 mm on`, async () => Math.abs((await screen.position())[axis] - from - 10) < 1e-6);
    await screen.rest();
  }
  const of_axis = (axis, name) => page.click(`.jog-rows button[aria-label^='${axis}: ']:text-is('${name}')`);
  const all = (name) => page.click(`.zeros button:has-text('${name}')`);
  const wheel_axis = (axis) => page.click(`button[aria-label='Wheel: ${axis}']`);
  const dial = async () => {
    const box = await page.locator(".wheel").boundingBox();
    return { x: box.x + box.width / 2, y: box.y + box.height / 2, r: box.width / 2 - 8 };
  };
  /// Turns the wheel by dragging, from one angle to another; degrees, clockwise from the right.
  async function drag(from, to) {
    const { x, y, r } = await dial(),
      at = (angle) => [x + r * Math.cos((angle * Math.PI) / 180), y + r * Math.sin((angle * Math.PI) / 180)];
    await page.mouse.move(...at(from));
    await page.mouse.down();
    for (let i = 1; i <= 20; i++) await page.mouse.move(...at(from + ((to - from) * i) / 20));
    await page.mouse.up();
    await page.mouse.move(...at(from)); // the wheel is no longer held
  }
  async function scroll(by) {
    const { x, y } = await dial();
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, by);
  }
  /// Holds a key until `has_moved`. On a busy machine the page renews the motion too late, and the machine stops by itself:
  /// then the key is pressed again, as a hand would.
  const hold_key = async (name, has_moved) => {
    for (let left = 20; ; left--) {
      await page.keyboard.down(name);
      const done = await until(`${name} moves its axis`, has_moved, left ? 5000 : 1).then(
        () => true,
        (error) => (left ? false : error),
      );
      await page.keyboard.up(name);
      if (done === true) return;
      if (done) throw done;
      await screen.mode("standing");
    }
  };
  const skipped = "skipped: the made-up session has no machine";

  return {
    async "the wheel by scroll, by drag and by arrow keys: one click is one step of its axis"() {
      if (!process.env.KADR) return skipped;
      await screen.open("zero.nc");
      await screen.tab("manual");
      await step("0.1");
      await wheel_axis("X");
      const { X, Y, Z } = await screen.position();
      await scroll(-150); // 50 px are a click
      await until("X three steps on", async () => Math.abs((await screen.position()).X - X - 0.3) < 1e-6);
      await screen.rest();
      await scroll(100);
      await until("two of them back", async () => Math.abs((await screen.position()).X - X - 0.1) < 1e-6);
      await screen.rest();
      await drag(-90, 93.6); // 7.2° are a click: 25 and a half
      await until("25 steps on", async () => Math.abs((await screen.position()).X - X - 2.6) < 1e-6);
      await screen.rest();
      await drag(0, -39.6); // five clicks and a half back: what is over of a click counts for no later turn
      await until("5 steps back", async () => Math.abs((await screen.position()).X - X - 2.1) < 1e-6);
      await screen.rest();
      await page.locator(".wheel").focus();
      await page.keyboard.press("ArrowUp"); // of the wheel: elsewhere it would move Y
      await page.keyboard.press("ArrowLeft");
      await page.keyboard.press("ArrowLeft");
      await until("a step back", async () => Math.abs((await screen.position()).X - X - 2) < 1e-6);
      await screen.rest();
      await screen.must_be({ X: X + 2, Y, Z }, "the other axes");
      await wheel_axis("Y");
      await step("Held");
      await scroll(-200);
      await until("hundredths of Y", async () => Math.abs((await screen.position()).Y - Y - 0.04) < 1e-6);
      await screen.rest();
      await screen.must_be({ X: X + 2, Y: Y + 0.04, Z }, "Y by the wheel");
    },
    async "zero of one axis and of all: they read 0 and stand still"() {
      if (!process.env.KADR) return skipped;
      await screen.open("zero.nc");
      await screen.tab("manual");
      await step("10");
      for (const axis of ["X", "Y", "Z"]) await jog_by_ten(axis);
      const before = await screen.position(),
        stands = await screen.position(1);
      must(before.X !== 0 && before.Y !== 0 && before.Z !== 0, `nothing to zero: ${JSON.stringify(before)}`);
      await of_axis("X", "Zero");
      await until("X reads 0", async () => (await screen.position()).X === 0);
      await screen.rest();
      await screen.must_be({ X: 0, Y: before.Y, Z: before.Z }, "after the zero of X");
      await all("Zero all");
      await until("all read 0", async () => Object.values(await screen.position()).every((v) => v === 0));
      await screen.rest();
      await screen.must_be(stands, "the machine has moved", 1);
      await jog_by_ten("Y");
      await screen.must_be({ X: 0, Y: 10, Z: 0 }, "beside the new zero");
    },
    async "to the zero: one axis alone; all of them with Z up first; home with Z first"() {
      if (!process.env.KADR) return skipped;
      await screen.open("zero.nc");
      await screen.tab("manual");
      await all("Zero all");
      await until("all read 0", async () => Object.values(await screen.position()).every((v) => v === 0));
      await step("10");
      for (const axis of ["X", "Y", "Z"]) await jog_by_ten(axis);
      await of_axis("Y", "→ 0");
      await until("Y at 0", async () => (await screen.position()).Y === 0);
      await screen.rest();
      await screen.must_be({ X: 10, Y: 0, Z: 10 }, "→ 0 of Y");
      let end = await screen.record();
      await all("Go to zero");
      await until("X at 0", async () => (await screen.position()).X === 0);
      await screen.rest();
      let way = await end();
      const top = (await screen.position()).Z;
      must(top >= 50, `Z ${top} is not over the path, which goes to 50`);
      const low = way.find((p) => Math.abs(p.X[0] - 10) > 0.0015 && p.Z[0] < top - 0.0015);
      must(!low, `X moved before Z was up: ${JSON.stringify(low)}`);
      end = await screen.record();
      await all("Home");
      await until("home", async () => Object.values(await screen.position(1)).every((v) => v === 0));
      way = await end();
      const [from] = way,
        early = way.find((p) => Math.abs(p.X[1] - from.X[1]) > 0.0015 && Math.abs(p.Z[1]) > 0.0015);
      must(!early, `X moved before Z was home: ${JSON.stringify(early)}`);
      must(from.X[1] !== 0 && from.Z[1] !== 0, `it was at home: ${JSON.stringify(from)}`);
    },
    async "a key of the keyboard moves its axis as long as it is held"() {
      if (!process.env.KADR) return skipped;
      await screen.open("zero.nc");
      await screen.tab("manual");
      await step("Held");
      await page.selectOption(".jog-choices select", "300");
      await page.locator(".screen-head .file").evaluate((e) => e.blur());
      const keys = [
        ["ArrowRight", "X", 1],
        ["ArrowLeft", "X", -1],
        ["ArrowUp", "Y", 1],
        ["ArrowDown", "Y", -1],
        ["PageUp", "Z", 1],
        ["PageDown", "Z", -1],
      ];
      for (const [name, axis, sign] of keys) {
        await screen.rest();
        const before = await screen.position();
        await hold_key(name, async () => sign * ((await screen.position())[axis] - before[axis]) > 1.5);
        await screen.mode("standing");
        await screen.rest();
        const after = await screen.position(),
          others = ["X", "Y", "Z"].filter((a) => a !== axis);
        must(sign * (after[axis] - before[axis]) > 1.5, `${name}: ${axis} has gone back`);
        must(
          others.every((a) => after[a] === before[a]),
          `${name} has moved another axis: ${JSON.stringify([before, after])}`,
        );
        await page.waitForTimeout(700); // it would be heard of for longer than the machine waits for the page
        must((await screen.position())[axis] === after[axis], `${name}: ${axis} moves after the release`);
      }
      const speed = async () =>
        Number((await page.textContent(".readout dl div:has(dt:text-is('V')) dd")).replace(/[^\d.]/g, ""));
      await page.keyboard.down("Shift");
      await hold_key("ArrowRight", async () => (await speed()) > 300); // F is 300 mm/min
      await page.keyboard.up("Shift");
      await screen.rest();
      const field = page.locator(".mdi-row .mdi").last();
      await field.click();
      const still = await screen.position();
      await page.keyboard.down("ArrowRight");
      await page.waitForTimeout(400);
      await page.keyboard.up("ArrowRight");
      await screen.must_be(still, "an arrow key in a field has moved an axis");
      await field.evaluate((e) => e.blur());
      for (let left = 20; left; left--) {
        await page.keyboard.down("ArrowLeft");
        if (await until("X moves", async () => (await screen.position()).X < still.X - 0.5, 5000).catch(() => false))
          break;
        must(left > 1, "ArrowLeft does not move X");
        await page.keyboard.up("ArrowLeft");
        await screen.mode("standing");
      }
      await page.evaluate(() => dispatchEvent(new Event("blur"))); // another window is in front: no keyup comes
      await screen.mode("standing");
      await page.keyboard.up("ArrowLeft");
    },
  };
}
