// Pictures of the operator's screen, compared with those of e2e/pictures, at which a person has looked. Means of small
// squares are compared: another antialiasing changes none of them much, another text or place does.
// PICTURES=new writes new ones: look at each, and put the date into e2e/pictures/README.md. Used by page.mjs.
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { looks_at, must, until } from "./browser.mjs";

const folder = fileURLToPath(new URL("pictures", import.meta.url)),
  square = 8, // px of the small picture
  most_off = 26, // of 255: how far the mean of a square may be off
  most_bytes = 60_000;

/// Runs in the page: the picture at half its size as a PNG, and the means of its squares.
const shrink = async ([bytes, size, halves]) => {
  const image = await createImageBitmap(new Blob([new Uint8Array(bytes)], { type: "image/png" }));
  const [w, h] = halves ? [image.width >> 1, image.height >> 1] : [image.width, image.height];
  const canvas = new OffscreenCanvas(w, h),
    context = canvas.getContext("2d", { willReadFrequently: true });
  context.imageSmoothingQuality = "high";
  context.drawImage(image, 0, 0, w, h);
  const { data } = context.getImageData(0, 0, w, h),
    means = [];
  for (let y = 0; y + size <= h; y += size)
    for (let x = 0; x + size <= w; x += size) {
      let sum = 0;
      for (let j = 0; j < size; j++)
        for (let i = 0; i < size; i++) {
          const at = 4 * ((y + j) * w + x + i);
          sum += data[at] + data[at + 1] + data[at + 2];
        }
      means.push(sum / (3 * size * size));
    }
  for (let i = 0; i < data.length; ++i) data[i] = Math.min(255, 17 * Math.round(data[i] / 17)); // fewer colours: a small file
  context.putImageData(new ImageData(data, w, h), 0, 0);
  const png = await (await canvas.convertToBlob({ type: "image/png" })).arrayBuffer();
  return { means, columns: Math.floor(w / size), png: [...new Uint8Array(png)] };
};

export function picture_steps({ kadr, page, pictures }) {
  const { count } = looks_at(() => page);
  const wrong = [];
  async function compare(name) {
    await page.mouse.move(1, 1);
    await page.evaluate(() => document.activeElement?.blur());
    await page.waitForTimeout(400);
    const shot = await page.screenshot({ animations: "disabled" }),
      now = await page.evaluate(shrink, [[...shot], square, true]),
      file = join(folder, `${name}.png`);
    if (process.env.PICTURES === "new") {
      must(now.png.length < most_bytes, `${name} has ${now.png.length} bytes`);
      return writeFileSync(file, Buffer.from(now.png));
    }
    writeFileSync(join(pictures, `${name}.png`), Buffer.from(now.png));
    if (!existsSync(file)) return wrong.push(`${name}: no picture`);
    const before = await page.evaluate(shrink, [[...readFileSync(file)], square, false]);
    if (before.means.length !== now.means.length) return wrong.push(`${name}: another size`);
    const off = now.means.map((v, i) => Math.abs(v - before.means[i])),
      worst = off.indexOf(Math.max(...off));
    if (off[worst] > most_off)
      wrong.push(
        `${name}: ${off.filter((v) => v > most_off).length} squares differ, by ${off[worst].toFixed(0)} at ` +
          `${2 * square * (worst % now.columns)}, ${2 * square * Math.floor(worst / now.columns)}`,
      );
  }
  return {
    async "the operator's screen looks as a person has seen it"() {
      if (!process.env.KADR) return "skipped: the made-up session has no machine";
      wrong.length = 0;
      await page.setViewportSize({ width: 1024, height: 768 });
      await page.goto(`${new URL(kadr.address()).origin}/?operator`);
      await until("the screen", () => page.locator(".operator-screen").isVisible());
      await page.click(".screen-head .file");
      const row = page.locator('.file-row:has(.file-name:text-is("zero.nc"))');
      await until("zero.nc", async () => {
        if ((await page.locator(".screen-head .file").textContent()) === "zero.nc") return true;
        if (await row.count()) await row.click({ timeout: 3000 }).catch(() => {});
        else if (await count(".crumbs button")) await page.click(".crumbs button >> nth=0"); // from that of the last program
        return page.waitForTimeout(500);
      });
      await until("its path", () => page.locator(".scene-host canvas").isVisible());
      await page.click(".big-keys button:has-text('Switch on'), .big-keys button:has-text('Load')");
      await until("it stands", () => count(".screen-head .mode.standing"));
      const style = await page.addStyleTag({ content: ".toasts { display: none }" }).catch(() => null);
      for (const lang of ["en", "ru"]) {
        await page.evaluate((to) => {
          const text = to === "en" ? "EN" : "РУ";
          [...document.querySelectorAll(".topbar .switch button")].find((b) => b.textContent === text).click();
        }, lang);
        await page.waitForTimeout(600);
        await page.click(".operator-screen [data-tab=op_program]");
        await page.click(".program-tab > .switch button >> nth=1"); // the text: a 3D view depends on the driver
        await compare(`operator_program_${lang}`);
        for (const tab of ["manual", "tool_zero", "restart"]) {
          await page.click(`.operator-screen [data-tab=op_${tab}]`);
          await compare(`operator_${tab}_${lang}`);
        }
      }
      await page.evaluate(() => {
        document.documentElement.dataset.theme = "dark";
      });
      await page.click(".operator-screen [data-tab=op_manual]");
      await compare("operator_manual_dark_ru");
      await page.evaluate(() => {
        document.documentElement.dataset.theme = "light";
        [...document.querySelectorAll(".topbar .switch button")].find((b) => b.textContent === "EN").click();
      });
      await style?.evaluate((e) => e.remove());
      await page.keyboard.press("o");
      await page.setViewportSize({ width: 1600, height: 1000 });
      must(!wrong.length, wrong.join(" ## "));
    },
  };
}
