// What hands do on the page in several steps: the cursor in a line, a new line, the mouse on a motion. Used by page.mjs.
import { looks_at, until } from "./browser.mjs";

export function hands_on(page) {
  const { text, toasts, line_shown } = looks_at(() => page);
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
        const same = await until("the same by the mouse", async () => (await tip()) === told[k], 5000).catch(
          () => false,
        );
        if (same) return at;
      }
    }
    throw new Error("no such motion found under the mouse");
  }

  return { now, line, not_served, click_line, add_line, find_motion };
}
