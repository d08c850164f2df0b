// Firefox as it is, driven by its own protocol, Marionette: JSON with its length before it, over TCP. Without a display it
// draws nothing in 3D: xvfb-run gives it one. Used by alone_firefox.mjs.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";

const port = 20_000 + (process.pid % 20_000);
const settings = {
  "marionette.port": port,
  "app.update.enabled": false,
  "datareporting.policy.dataSubmissionEnabled": false,
  "network.captive-portal-service.enabled": false,
  "network.connectivity-service.enabled": false,
  "browser.shell.checkDefaultBrowser": false,
  "browser.aboutwelcome.enabled": false,
  "webgl.force-enabled": true,
};

const wait = (ms) => new Promise((yes) => setTimeout(yes, ms));

export async function firefox(program = process.env.FIREFOX ?? "/usr/bin/firefox-esr") {
  const profile = mkdtempSync(join(tmpdir(), "kadr-firefox-"));
  const lines = Object.entries(settings).map(([k, v]) => `user_pref(${JSON.stringify(k)}, ${JSON.stringify(v)});`);
  writeFileSync(join(profile, "user.js"), lines.join("\n"));
  const shown = process.env.DISPLAY ? ["-width", "1600", "-height", "1000"] : ["-headless"];
  const env = {
    ...process.env,
    LIBGL_ALWAYS_SOFTWARE: "1",
    HOME: profile,
    MOZ_HEADLESS_WIDTH: "1600",
    MOZ_HEADLESS_HEIGHT: "1000",
  };
  const browser = spawn(program, [...shown, "-marionette", "-no-remote", "-profile", profile], {
    stdio: "ignore",
    env,
  });
  process.on("exit", () => browser.kill("SIGKILL")); // after an error too
  const socket = await connected();
  const waiting = new Map();
  let bytes = Buffer.alloc(0),
    next = 0;
  socket.on("data", (more) => {
    bytes = Buffer.concat([bytes, more]);
    for (;;) {
      const colon = bytes.indexOf(":"),
        size = Number(bytes.subarray(0, colon));
      if (colon < 0 || bytes.length < colon + 1 + size) return;
      const message = JSON.parse(bytes.subarray(colon + 1, colon + 1 + size));
      bytes = bytes.subarray(colon + 1 + size);
      if (!Array.isArray(message)) continue; // its greeting
      const [, id, error, result] = message,
        { yes, no } = waiting.get(id);
      if (error) no(new Error(`${error.error}: ${error.message}`));
      else yes(result);
    }
  });
  const ask = (name, of = {}) =>
    new Promise((yes, no) => {
      const id = next++,
        text = JSON.stringify([0, id, name, of]);
      waiting.set(id, { yes, no });
      socket.write(`${Buffer.byteLength(text)}:${text}`);
    });
  const { capabilities } = await ask("WebDriver:NewSession", { capabilities: { alwaysMatch: {} } });
  await ask("WebDriver:SetTimeouts", { script: 600_000, pageLoad: 300_000 });
  return {
    version: capabilities.browserVersion,
    go: (url) => ask("WebDriver:Navigate", { url }),
    /// Runs a function with arguments on the page; returns what it returns.
    run: async (what, ...args) =>
      await ask("WebDriver:ExecuteAsyncScript", {
        script: `const done = arguments[arguments.length - 1], args = [...arguments].slice(0, -1);
          Promise.resolve((${what})(...args)).then((value) => done({ value }), (e) => done({ error: String(e) }));`,
        args,
      }).then(({ value }) => {
        if (value.error) throw new Error(value.error);
        return value.value;
      }),
    shot: async (path) => {
      const { value } = await ask("WebDriver:TakeScreenshot", { full: false });
      writeFileSync(path, Buffer.from(value, "base64"));
    },
    close: async () => {
      await ask("Marionette:Quit", { flags: ["eForceQuit"] }).catch(() => {});
      socket.destroy();
      if (browser.exitCode === null) await Promise.race([new Promise((yes) => browser.on("exit", yes)), wait(5000)]);
      browser.kill("SIGKILL");
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };

  async function connected() {
    for (let tries = 0; tries < 600; tries++) {
      const socket = connect(port, "127.0.0.1");
      const there = await new Promise((yes) => {
        socket.once("connect", () => yes(true));
        socket.once("error", () => yes(false));
      });
      if (there) return socket;
      await wait(200);
    }
    throw new Error("Firefox does not answer");
  }
}
