// Compares pictures of the page with those of e2e/pictures, at which a person has looked. Means of small squares are
// compared: another antialiasing changes none of them much, another text or place does. PICTURES=new writes new ones:
// look at each, and put the date into e2e/pictures/README.md.
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { must } from "./browser.mjs";

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

export function compares({ page, pictures }) {
  const wrong = []; // what differs
  async function compare(name) {
    await page.mouse.move(1, 1);
    await page.evaluate(() => document.activeElement?.blur());
    await page.waitForTimeout(400);
    const shot = await page.screenshot({ animations: "disabled" }),
      now = await page.evaluate(shrink, [[...shot], square, true]),
      file = join(folder, `${name}.png`);
    if (process.env.PICTURES === "new") {
      writeFileSync(file, Buffer.from(now.png));
      execFileSync("pngquant", ["--force", "--output", file, "64", file]); // a palette of 64 colours
      const { size } = statSync(file);
      return must(size < most_bytes, `${name} has ${size} bytes`);
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
  /// Fails with all that differs since the last call.
  const must_be_same = () => {
    const told = wrong.splice(0).join(" ## ");
    must(!told, told);
  };
  return { compare, must_be_same };
}
