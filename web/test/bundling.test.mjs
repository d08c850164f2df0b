// Tests that the contents of the one file stay in their elements, and that a package which may not be embedded stops
// the build.
import { describe, expect, it } from "vitest";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { inlined, safe_script } from "../bundling/inlined.ts";
import { is_allowed, package_of, part_of } from "../bundling/notices.ts";

describe("the file in one piece", () => {
  it("has no end of a script in a script", () => {
    const code = 'const a = "</script>", b = "<!-- c", d = /<\\/SCRIPT/;';
    const safe = safe_script(code);
    expect(safe).not.toMatch(/<\/script/i);
    expect(safe).not.toContain("<!--");
    expect(Function(`${safe} return a + b;`)()).toBe("</script><!-- c");
  });
  it("holds script and style, and says their hashes", () => {
    const bundle = {
      "r.html": {
        type: "asset",
        source:
          '<html><head><meta charset="utf-8"><script type="module" crossorigin src="./a.js"></script>' +
          '<link rel="stylesheet" crossorigin href="./a.css"></head><body></body></html>',
      },
      "a.js": { type: "chunk", code: "let $ = '$&';" },
      "a.css": { type: "asset", source: "p{}" },
    };
    inlined("r.html").generateBundle({}, bundle);
    expect(Object.keys(bundle)).toEqual(["r.html"]);
    const html = bundle["r.html"].source;
    expect(html).toContain("<script type=\"module\">let $ = '$&';</script>");
    expect(html).not.toMatch(/src=|href=/);
    expect(html).toMatch(/default-src 'none'; script-src 'sha256-[^']+'; style-src 'sha256-[^']+'/);
  });
});

describe("licences", () => {
  it("are of the kinds that may be embedded", () => {
    for (const good of ["MIT", "(MIT OR GPL-3.0)", "Apache-2.0", "BSD-3-Clause", "BSL-1.0"])
      expect(is_allowed(good)).toBe(true);
    for (const bad of ["GPL-3.0", "MIT AND GPL-3.0", "", "LGPL-2.1", "MPL-2.0"]) expect(is_allowed(bad)).toBe(false);
  });
  it("belong to packages", () => {
    expect(package_of("/x/node_modules/@codemirror/view/dist/index.js")).toBe("/x/node_modules/@codemirror/view");
    expect(package_of("\0/x/node_modules/three/build/three.module.js?v=1")).toBe("/x/node_modules/three");
    expect(package_of("/x/src/page.ts")).toBeNull();
  });
  it("are refused where they may not, or say nothing", () => {
    const folder = mkdtempSync(join(tmpdir(), "kadr-part-"));
    writeFileSync(join(folder, "package.json"), JSON.stringify({ name: "p", version: "1", license: "GPL-3.0" }));
    expect(() => part_of(folder)).toThrow(/may not be embedded: GPL/);
    writeFileSync(join(folder, "package.json"), JSON.stringify({ name: "p", version: "1", license: "MIT" }));
    expect(() => part_of(folder)).toThrow(/no text of its licence/);
    writeFileSync(join(folder, "LICENSE"), "MIT text");
    expect(part_of(folder)).toEqual({ name: "p", version: "1", licence: "MIT", text: "MIT text" });
  });
});
