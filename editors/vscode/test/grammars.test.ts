// Tests the grammars that dev/grammars has written, as editors read them (vscode-textmate): every code of a control is a
// code, comments are comments. KADR: the program, which lists the codes; REPOSITORY: its examples.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { before, test } from "node:test";
import { createOnigScanner, createOnigString, loadWASM } from "vscode-oniguruma";
import { INITIAL, parseRawGrammar, Registry, type IGrammar } from "vscode-textmate";

const root = process.env.EXTENSION!,
  kadr = process.env.KADR,
  folder = join(root, "syntaxes");
const skip = kadr && existsSync(folder) ? false : "KADR names no program, or dev/grammars has not been run";
const controls = skip ? [] : readdirSync(folder).map((name) => name.replace(".tmLanguage.json", ""));
const registry = new Registry({
  onigLib: Promise.resolve({ createOnigScanner, createOnigString }),
  loadGrammar: async (scope) => {
    const path = join(folder, `${scope.replace("source.", "")}.tmLanguage.json`);
    return parseRawGrammar(readFileSync(path, "utf8"), path);
  },
});
before(async () => {
  if (!skip) await loadWASM(readFileSync(join(dirname(require.resolve("vscode-oniguruma")), "onig.wasm")).buffer);
});

const grammar = async (control: string): Promise<IGrammar> => (await registry.loadGrammar(`source.${control}`))!;
/// Returns the text of each token of a line with its innermost scope.
const tokens = (g: IGrammar, line: string): [string, string][] =>
  g.tokenizeLine(line, INITIAL).tokens.map((x) => [line.slice(x.startIndex, x.endIndex), x.scopes.at(-1)!]);

test("every code that the program knows is one", { skip }, async () => {
  let count = 0;
  for (const control of controls.filter((x) => x !== "nc")) {
    const g = await grammar(control);
    const listed = spawnSync(kadr!, ["controls", control.replace("nc-", ""), "--lang", "en"], {
      encoding: "utf8",
    }).stdout;
    for (const [, code] of listed.matchAll(/^  ([GM]\d+(?:\.\d+)?) /gm)) {
      const kind = code!.startsWith("G") ? "keyword.control.preparatory.nc" : "support.function.auxiliary.nc";
      const own = g.tokenizeLine(`N5 ${code} X1`, INITIAL).tokens.find((x) => x.startIndex === 3)!;
      assert.equal(own.scopes.at(-1), kind, `${control} ${code}`);
      assert.equal(own.endIndex, 3 + code!.length, `${control} ${code}`);
      count++;
    }
  }
  assert.ok(count > 1000, String(count));
});

test("what a control does not have is no code of it", { skip }, async () => {
  assert.ok(!tokens(await grammar("nc-grbl"), "G41 X1").some(([, scope]) => /preparatory/.test(scope)));
  assert.ok(!tokens(await grammar("nc-fanuc"), "G1.7 X1").some(([, scope]) => /preparatory/.test(scope)));
});

test("comments, labels, variables, functions and numbers are told apart", { skip }, async () => {
  const expected: [string, string, string, RegExp][] = [
    ["nc-fanuc", "O0020(PART)", "PART", /^comment/],
    ["nc-fanuc", "O0020(PART)", "O0020", /^entity.name.function/],
    ["nc-fanuc", "N10 G01 X-5.", "N10", /^entity.name.label/],
    ["nc-fanuc", "N10 G01 X-5.", "G01", /preparatory/],
    ["nc-fanuc", "N10 G01 X-5.", "-5.", /^constant.numeric/],
    ["nc-fanuc", "IF[#100GE-4.]GOTO10", "#100", /^variable.other/],
    ["nc-fanuc", "IF[#100GE-4.]GOTO10", "GE", /^keyword.operator/],
    ["nc-fanuc", "IF[#100GE-4.]GOTO10", "GOTO", /^keyword.control/],
    ["nc-fanuc", "#1=SIN[30]", "SIN", /^support.function/],
    ["nc-linuxcnc", "o100 while [#<n> LT 5]", "while", /^keyword.control/],
    ["nc-linuxcnc", "o100 while [#<n> LT 5]", "#<n>", /^variable.other/],
    ["nc-linuxcnc", "G1 X1 ; rest", "; rest", /^comment/],
    ["nc-sinumerik", "CYCLE83(10,0,2,-20) ; deep", "CYCLE83", /cycle/],
    ["nc-sinumerik", 'MSG("G1 X5")', '"G1 X5"', /^string/],
    ["nc-sinumerik", "X=IC(R1)", "R1", /^variable.other/],
    ["nc-mach3", "G1 X1 // rest", "// rest", /^comment/],
    ["nc-s2c42", "L81 R0 100", "L81", /cycle/],
  ];
  for (const [control, line, text, scope] of expected) {
    const found = tokens(await grammar(control), line);
    assert.ok(
      found.some(([t, s]) => t.trim() === text && scope.test(s)),
      `${control}: ${line}: ${JSON.stringify(found)}`,
    );
  }
});

test("in the examples every word has a colour", { skip: skip || !process.env.REPOSITORY }, async () => {
  const examples = join(process.env.REPOSITORY!, "examples");
  let words = 0;
  for (const control of controls.map((x) => x.replace("nc-", "")).filter((x) => existsSync(join(examples, x)))) {
    const g = await grammar(`nc-${control}`);
    for (const name of readdirSync(join(examples, control)).filter((x) =>
      /\.(nc|ngc|tap|nct|mpf|spf|gcode)$/i.test(x),
    )) {
      let state = INITIAL;
      for (const line of readFileSync(join(examples, control, name), "utf8").split(/\r?\n/)) {
        const read = g.tokenizeLine(line, state);
        state = read.ruleStack;
        for (const x of read.tokens) {
          const text = line.slice(x.startIndex, x.endIndex);
          const plain = x.scopes.length === 1 && /(?<![A-Z_])[A-Z]\d/.test(text);
          assert.ok(!plain, `${control}/${name}: ${line}: ${text}`);
          words += Number(x.scopes.length > 1);
        }
      }
    }
  }
  assert.ok(words > 2000, String(words));
});
