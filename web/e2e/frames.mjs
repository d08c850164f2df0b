// Measures the pictures per second while a long path is rotated, moved and zoomed: node e2e/frames.mjs [SEGMENTS]
// [PICTURES]. The path comes from a mock session.
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { browser, until } from "./browser.mjs";
import { long_session } from "./long_path.mjs";
import { serve_session } from "./socket_server.mjs";

const segments = Number(process.argv[2] ?? 5_000_000),
  pictures = process.argv[3];
const server = await serve_session(long_session(segments));
const { page, errors, close } = await browser();

/// Starts to record the time of each picture, and each task of the page's thread above 50 ms.
const watch = () =>
  page.evaluate(() => {
    const w = (window.watched = { frames: [], tasks: [], on: true });
    const frame = (t) => {
      w.frames.push(t);
      if (w.on) requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
    w.observer = new PerformanceObserver((l) => {
      for (const e of l.getEntries()) w.tasks.push(e.duration);
    });
    w.observer.observe({ type: "longtask" });
  });
const watched = (name) =>
  page.evaluate((what) => {
    const w = window.watched;
    w.on = false;
    w.observer.disconnect();
    const gaps = w.frames
        .slice(1)
        .map((t, i) => t - w.frames[i])
        .sort((a, b) => a - b),
      all = gaps.reduce((a, b) => a + b, 0);
    return {
      what,
      pictures: gaps.length,
      per_second: gaps.length / (all / 1000),
      median: gaps[gaps.length >> 1],
      most: gaps[gaps.length - 1],
      longest_task: Math.max(0, ...w.tasks),
      tasks: w.tasks.length,
    };
  }, name);
const tell = (r) =>
  console.log(
    `${r.what.padEnd(18)} ${r.per_second.toFixed(1).padStart(6)} pictures/s, median ${r.median.toFixed(0)} ms, longest ${r.most.toFixed(0)} ms; ` +
      `tasks above 50 ms: ${r.tasks}, longest ${r.longest_task.toFixed(0)} ms`,
  );
const thinned = () => page.locator(".scene-thinned").textContent();

async function drag(button, seconds) {
  const box = await page.locator(".scene-host canvas").boundingBox(),
    [x, y] = [box.x + box.width / 2, box.y + box.height / 2],
    end = Date.now() + 1000 * seconds;
  await page.mouse.move(x, y);
  await page.mouse.down({ button });
  for (let i = 0; Date.now() < end; i++) await page.mouse.move(x + 150 * Math.sin(i / 40), y + 60 * Math.sin(i / 25));
  await page.mouse.up({ button });
}

const results = [];
async function measure(name, what) {
  await watch();
  await what();
  results.push(await watched(name));
  tell(results.at(-1));
}

try {
  const begin = Date.now();
  await page.goto(server.address);
  await measure("while it comes", () => until("the run's end", () => page.locator(".run-told.ended").count(), 180_000));
  console.log(`${segments} segments came in ${((Date.now() - begin) / 1000).toFixed(1)} s; said: ${await thinned()}`);
  await page.waitForTimeout(1500);
  await measure("turning", () => drag("left", 4));
  console.log(`said: ${await thinned()}`);
  await measure("moving", () => drag("right", 3));
  await measure("resting", () => page.waitForTimeout(1500));
  console.log(`said: ${await thinned()}`);
  await measure("zooming", async () => {
    for (let i = 0; i < 30; i++) {
      await page.mouse.wheel(0, i < 15 ? -100 : 100);
      await page.waitForTimeout(50);
    }
  });
  await measure("hovering", async () => {
    const box = await page.locator(".scene-host canvas").boundingBox();
    for (let i = 0; i < 60; i++) {
      await page.mouse.move(box.x + 200 + 5 * i, box.y + 300 + i);
      await page.waitForTimeout(16);
    }
  });
  await measure("slider", async () => {
    const box = await page.locator(".slider").boundingBox();
    await page.mouse.move(box.x + 50, box.y + box.height - 9);
    await page.mouse.down();
    for (let i = 0; i < 100; i++) {
      await page.mouse.move(box.x + 50 + 10 * i, box.y + box.height - 9);
      await page.waitForTimeout(16);
    }
    await page.mouse.up();
  });
  if (pictures) {
    mkdirSync(pictures, { recursive: true });
    await page.screenshot({ path: join(pictures, "frames.png") });
  }
} finally {
  if (errors.length) console.log("errors:", errors);
  await close();
  server.close();
}
process.exit(errors.length ? 1 : 0);
