// The common parts of all browser tests: a browser with an empty profile, and a page that reports every error.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

const flags = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--disable-features=LocalNetworkAccessChecks,BlockInsecurePrivateNetworkRequests",
  "--disable-gpu-compositing", // no software GPU for the page itself, only for WebGL
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
];

/// How long a test waits for something that comes, in ms: long, because a busy machine is slow, not wrong.
const patience = 180_000;

export async function browser(size = { width: 1600, height: 1000 }) {
  const profile = mkdtempSync(join(tmpdir(), "kadr-browser-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: flags,
    viewport: size,
    locale: "en-GB",
    acceptDownloads: true,
  });
  const page = context.pages()[0] ?? (await context.newPage());
  page.setDefaultTimeout(patience);
  const errors = [];
  page.on("pageerror", (e) => errors.push(e.message));
  page.on("console", (m) => {
    if (m.type() === "error" && !/WebSocket connection|ERR_CONNECTION/.test(m.text())) errors.push(m.text());
  });
  const close = async () => {
    await context.close();
    rmSync(profile, { recursive: true, force: true });
  };
  return { context, page, errors, close };
}

/// Waits until `what` gives a true value; throws an error with `name` if it never does.
export async function until(name, what, ms = patience) {
  const end = Date.now() + ms;
  for (;;) {
    const got = await what();
    if (got) return got;
    if (Date.now() > end) throw new Error(`waited ${ms} ms for: ${name}`);
    await new Promise((r) => setTimeout(r, 50));
  }
}

export const must = (yes, what) => {
  if (!yes) throw new Error(what);
};
/// Helpers that look at the page which `of` returns at the moment.
export function looks_at(of) {
  const count = (what) => of().locator(what).count();
  const text = (what) => of().locator(what).first().textContent();
  const ended = () => until("the run's end", () => count(".run-told.ended, .run-told.stopped"));
  const toasts = async () => (await of().locator(".toast").allTextContents()).join(" | ");
  const line_shown = () =>
    of().evaluate(() => {
      const e = document.querySelector(".cm-running"),
        box = document.querySelector(".source-host").getBoundingClientRect(),
        b = e?.getBoundingClientRect();
      return b && b.top >= box.top - 1 && b.bottom <= box.bottom + 1 ? e.textContent : "";
    });
  /// Returns what this tab keeps for a reload (src/model/memory.ts).
  const kept = (name) => of().evaluate((key) => JSON.parse(sessionStorage.getItem(key) ?? "null"), `kadr.${name}`);
  /// Waits until the view no longer changes: answers to earlier requests may still arrive.
  const settled_view = async () => {
    let last = null;
    return until("the view stands", async () => {
      const before = last;
      await of().evaluate(() => new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r))));
      last = await of().locator(".scene-host").screenshot();
      await of().waitForTimeout(200); // the view is drawn finely only after a short time without a change
      return before?.equals(last) ? last : null;
    });
  };
  return { count, text, ended, toasts, line_shown, kept, settled_view };
}
