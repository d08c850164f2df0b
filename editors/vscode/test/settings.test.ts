// Tests how settings become options of the command line.
import assert from "node:assert/strict";
import { homedir } from "node:os";
import { test } from "node:test";
import { choice_words, server_settings, settings_of, task_words } from "../src/settings";

const made = (given: Record<string, string>, folder?: string, editor = "en") =>
  settings_of((name) => given[name], folder, editor);

test("without settings the program of the search path decides everything", () => {
  const s = made({});
  assert.deepEqual(s, { path: "kadr", control: "", machine: "", setup: "", language: "en" });
  assert.deepEqual(choice_words(s), []);
});

test("paths begin at the folder of the workspace", () => {
  assert.equal(made({ setup: "sets/a.json" }, "/w").setup, "/w/sets/a.json");
  assert.equal(made({ setup: "/sets/a.json" }, "/w").setup, "/sets/a.json");
  assert.equal(made({ setup: "${workspaceFolder}/a.json" }, "/w").setup, "/w/a.json");
  assert.equal(made({ path: "~/bin/kadr" }).path, `${homedir()}/bin/kadr`);
  assert.equal(made({ path: "${workspaceFolder}/kadr" }, "/w").path, "/w/kadr");
});

test("the language is that of the editor unless another one is chosen", () => {
  assert.equal(made({}, undefined, "ru").language, "ru");
  assert.equal(made({}, undefined, "pt-BR").language, "en");
  assert.equal(made({ language: "en" }, undefined, "ru").language, "en");
  assert.equal(server_settings(made({ language: "ru" })).language, "ru");
});

test("a choice becomes options, each word apart", () => {
  const s = made({ control: "fanuc", machine: " my mill.toml ", setup: "a b.json" }, "/w");
  const options = ["--control", "fanuc", "--machine", "my mill.toml", "--setup", "/w/a b.json"];
  assert.deepEqual(choice_words(s), options);
  const words = ["check", "/w/a.nc", "--lang", "en", ...options, "--strict"];
  assert.deepEqual(task_words({ command: "check", file: "/w/a.nc", args: ["--strict"] }, s), words);
  assert.equal(task_words({ command: "check" }, s)[1], ".");
});
