// The server under test: KADR names the program, and a copy of its examples is served. Without KADR the mock session
// answers. DIST: a built page that replaces the one inside the program.
import { spawn } from "node:child_process";
import { appendFileSync, cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { serve_page } from "../test/mock-server.mjs";
import { session } from "../test/mock-session.mjs";

export async function server(examples) {
  return process.env.KADR ? real(process.env.KADR, examples) : made_up();
}

/// Serves the page's files from a folder, for a page that is newer than the program.
export async function page_from(page, dist) {
  if (dist)
    await page.route(/^http:\/\/127\.0\.0\.1:\d+\/[\w.-]*$/, (route) => {
      const name = new URL(route.request().url()).pathname.slice(1) || "index.html";
      return name === "session" || name === "health" ? route.continue() : route.fulfill({ path: join(dist, name) });
    });
}

/// Programs for which there is no example: a stated work offset, inches, an offset that two tools share.
const our_own = {
  "zero.nc": [
    "%",
    "O0001 (ZERO STATED)",
    "G21 G90 G54 G17 G40 G49 G80",
    "T1 M6",
    "S1000 M3",
    "G0 G43 H3 X0 Y0 Z50.",
    "G1 Z0. F500.",
    "X40.",
    "G0 Z50.",
    "T2 M6",
    "G0 G43 H3 X-20. Y0. Z50.",
    "G1 Z0. F500.",
    "G41 D2 X0. Y0.",
    "Y30.",
    "X40.",
    "G40 X40. Y30.",
    "Y38.",
    "M30",
    "%",
  ].join("\n"),
  // For the operator's day: an M0 with its reason, long enough to be held.
  "day.nc": [
    "%",
    "O0003 (OPERATORS DAY)",
    "N10 G21 G90 G54 G17 G40 G49 G80",
    "N20 T1 M6",
    "N30 S2000 M3",
    "N40 G0 X0 Y0 Z10.",
    "N50 M0 (CLAMP THE PART)",
    ...Array.from({ length: 12 }, (_, i) => `N${60 + 10 * i} G1 X${i % 2 ? 0 : 60}. Y${3 * i}. F1200.`),
    "N180 G0 Z50.",
    "N190 M30",
    "%",
  ].join("\n"),
  // For a real machine: long enough to be held.
  "real.nc": [
    "G21 G90 G17 G54",
    "M3 S500",
    ...Array.from({ length: 20 }, (_, i) => `G1 X${i % 2 ? 0 : 60}. Y${i}. F1800`),
    "M5",
    "M30",
  ].join("\n"),
  "zero.json": JSON.stringify({
    work_offsets: { G54: { X: -100, Y: -50, Z: -300 } },
    offsets: { 2: { radius: 8 }, 3: { length: 80 } },
  }),
  // An alarm that is out of view when the text begins at its first line.
  "alarm.nc": [
    "%",
    "O0004 (ALARM IN LINE 63)",
    "N10 G21 G90 G54 G17 G40 G49 G80",
    ...Array.from({ length: 59 }, (_, i) => `N${20 + 10 * i} G0 X${i % 2}.`),
    "N610 G777 X5.",
    "N620 M30",
    "%",
  ].join("\n"),
  "inch.nc": [
    "%",
    "O0002 (INCHES)",
    "G20 G90 G54 G17 G40 G49 G80",
    "T1 M6",
    "G0 X0 Y0 Z1.",
    "G1 Z-0.5 F10.",
    "X3.2",
    "M30",
    "%",
  ].join("\n"),
};

/// Starts the double of a Grbl controller that was built with the program; null if it was not.
async function grbl_double(kadr) {
  const program = join(dirname(kadr), "tests", "grbl_double");
  if (!existsSync(program)) return null;
  const child = spawn(program, { stdio: ["pipe", "pipe", "inherit"] });
  const port = await new Promise((yes) => child.stdout.once("data", (d) => yes(String(d).trim())));
  child.stdout.on("data", () => {});
  return { port, tell: (line) => child.stdin.write(`${line}\n`), end: () => child.kill("SIGKILL") };
}

export async function real(kadr, examples) {
  const folder = mkdtempSync(join(tmpdir(), "kadr-examples-"));
  cpSync(examples, folder, { recursive: true });
  if (existsSync(join(folder, "cut")))
    writeFileSync(
      join(folder, "cut", "xss.nc"),
      "%\n(</script><img src=x onerror=boom()>)\nN10 G21 G90\nN20 G0 X0 Y0\nN30 G1 X10 F100\nM30\n%\n",
    );
  for (const [name, text] of Object.entries(our_own)) writeFileSync(join(folder, name), text);
  const double = await grbl_double(kadr),
    drives = double ? ["--drive", double.port, "--drive-log", join(tmpdir(), `kadr-drive-${process.pid}.log`)] : [];
  let child,
    address = "";
  const start = (port, ...more) =>
    new Promise((yes, no) => {
      child = spawn(kadr, ["serve", folder, "--no-browser", "--port", String(port), ...drives, ...more], {
        stdio: ["ignore", "pipe", "inherit"],
      });
      let said = "";
      child.stdout.on("data", (d) => {
        said += d;
        const found = /kadr serve: (http:\/\/127\.0\.0\.1:(\d+)\/\S*)/.exec(said);
        if (found) yes(found);
      });
      child.once("exit", (code) => no(new Error(`kadr serve ended with ${code}: ${said}`)));
    });
  const stop = () =>
    new Promise((yes) => {
      if (child.exitCode !== null) return yes();
      child.once("exit", yes);
      child.kill("SIGKILL");
    });
  const [, first, port] = await start(0);
  address = first;
  return {
    address: () => address,
    edits: true,
    prepare: (page) => page_from(page, process.env.DIST),
    put: (name, text) => writeFileSync(join(folder, name), text),
    got: (name) => readFileSync(join(folder, name), "utf8"),
    folder,
    path: ["cut", "plate.nc"],
    line: "N60 G777 Z0",
    before: "N60 G1 Z0 F400",
    change: () => appendFileSync(join(folder, "cut", "plate.nc"), "(somebody else)\n"),
    lose: stop,
    regain: async () => {
      address = (await start(Number(port), "--open"))[1]; // it has another token: a page that was open may only watch
    },
    double,
    close: async () => {
      await stop();
      double?.end();
      rmSync(folder, { recursive: true, force: true });
    },
  };
}

async function made_up() {
  const files = await serve_page(fileURLToPath(new URL("../dist", import.meta.url)));
  let lost = false,
    open = [];
  return {
    address: () => `${files.address}#token=abc`,
    path: ["plate.nc"],
    line: "N60 G1 Z-1",
    before: "N60 G1 Z-[6-#1] F400",
    prepare: (page) =>
      page.routeWebSocket(/\/session$/, (ws) => {
        if (lost) return void ws.close();
        open.push(ws);
        ws.onMessage(
          session((m) => {
            try {
              ws.send(typeof m === "string" ? m : Buffer.from(m));
            } catch {
              /* the page was closed */
            }
          }),
        );
      }),
    change: () => {}, // the mock session refuses a text that contains CONFLICT
    lose: async () => {
      lost = true;
      for (const ws of open.splice(0)) await ws.close();
    },
    regain: async () => {
      lost = false;
    },
    close: async () => files.close(),
  };
}
