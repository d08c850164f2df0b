// Bundles the tests and runs them with node's own test runner: node test/run.mjs [FILE.test.ts…] (default: all).
// MODULES: the folder node_modules with esbuild and what the tests need (default: the extension's own). KADR: the
// program; without it what needs it is skipped.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url)),
  modules = process.env.MODULES ?? join(here, "..", "node_modules"),
  { build } = createRequire(import.meta.url)(join(modules, "esbuild"));
const wanted = process.argv.slice(2),
  all = readdirSync(here).filter((name) => name.endsWith(".test.ts"));
const out = mkdtempSync(join(tmpdir(), "kadr-extension-"));
try {
  const files = wanted.length ? wanted : all;
  await build({
    entryPoints: files.map((name) => join(here, name)),
    bundle: true,
    platform: "node",
    target: "node18",
    format: "cjs",
    external: ["vscode-textmate", "vscode-oniguruma", "@vscode/debugadapter-testsupport"],
    outExtension: { ".js": ".cjs" },
    outdir: out,
  });
  const made = files.map((name) => join(out, name.replace(/\.ts$/, ".cjs")));
  const env = { ...process.env, EXTENSION: join(here, ".."), NODE_PATH: modules };
  const ran = spawnSync(process.execPath, ["--test", ...made], { stdio: "inherit", env });
  process.exitCode = ran.status ?? 1;
} finally {
  rmSync(out, { recursive: true, force: true });
}
