// Measures the page without a server: how soon it is there, and how long programs take. Used by alone.mjs.
import { until } from "./browser.mjs";

function lines(count) {
  const all = ["G21 G90 G17", "S1000 M3", "G0 X0 Y0 Z5", "G1 Z-1 F500"];
  for (let n = 0, seed = 1; n < count; n++) {
    seed = (seed * 16807) % 2147483647;
    const z = -1 + (0.3 * seed) / 2147483647;
    all.push(`G1 X${((n % 1000) / 10).toFixed(3)} Y${(Math.floor(n / 1000) / 10).toFixed(3)} Z${z.toFixed(3)}`);
  }
  return [...all, "M30", ""].join("\n");
}

export async function alone_figures({ page, address, drop, ended }) {
  const told = [];
  for (const visit of ["second", "third"]) {
    await page.goto("about:blank");
    const begin = Date.now();
    await page.goto(address);
    await until("the files", () => page.locator(".file-row, .examples button").count());
    told.push(`${visit} visit: files and examples after ${Date.now() - begin} ms`);
  }
  for (const count of [100_000, 1_000_000]) {
    const name = `lines_${count}.nc`;
    await page.evaluate(() => {
      window.first_path = 0;
      const draw = WebGL2RenderingContext.prototype.drawArrays;
      WebGL2RenderingContext.prototype.drawArrays = function (mode, first, n) {
        draw.call(this, mode, first, n);
        if (mode === this.LINES && n > 500) window.first_path ||= performance.now();
      };
    });
    const begin = await page.evaluate(() => performance.now());
    await drop([[name, lines(count)]]);
    await until("it is open", async () => (await page.locator(".topbar .file").textContent()) === name);
    await ended();
    const [first, end] = await page.evaluate(() => [window.first_path, performance.now()]);
    told.push(`${count} lines: path after ${Math.round(first - begin)} ms, run after ${Math.round(end - begin)} ms`);
    await page.evaluate(() => (window.first_path = 0));
  }
  for (const line of told) console.log(`      ${line}`);
}
