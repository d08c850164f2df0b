// Puts the script and the style of a built page into its HTML, and adds a policy with their hashes so that nothing
// else may run: the file can be opened from anywhere.
import { createHash } from "node:crypto";
import type { Plugin } from "vite";

export function inlined(page: string): Plugin {
  return {
    name: "kadr-inlined",
    enforce: "post",
    generateBundle(_, bundle) {
      const html = bundle[page];
      if (html?.type !== "asset") throw new Error(`${page} was not built`);
      const hashes = { script: [] as string[], style: [] as string[] };
      let text = String(html.source);
      for (const [name, file] of Object.entries(bundle)) {
        if (file === html) continue;
        const script = file.type === "chunk";
        if (!script && !name.endsWith(".css")) continue;
        const inside = script ? safe_script(file.code) : safe_style(String(file.source));
        const kind = script ? "script" : "style";
        hashes[kind].push(`'sha256-${createHash("sha256").update(inside).digest("base64")}'`);
        const place = script
          ? new RegExp(`<script type="module"[^>]*src="\\./${escaped(name)}"[^>]*></script>`)
          : new RegExp(`<link rel="stylesheet"[^>]*href="\\./${escaped(name)}"[^>]*>`);
        if (!place.test(text)) throw new Error(`${name} has no place in ${page}`);
        text = text.replace(place, "");
        // The script goes to the end of the body, because it needs the data above it.
        text = script
          ? text.replace("</body>", () => `<script type="module">${inside}</script>\n</body>`)
          : text.replace("</head>", () => `<style>${inside}</style>\n</head>`);
        delete bundle[name];
      }
      const own = `script-src ${hashes.script.join(" ")}; style-src ${hashes.style.join(" ")}`;
      const policy = `default-src 'none'; ${own}; img-src blob:; base-uri 'none'; form-action 'none'`;
      html.source = text.replace(
        '<meta charset="utf-8">',
        `<meta charset="utf-8">\n<meta http-equiv="Content-Security-Policy" content="${policy}">`,
      );
    },
  };
}

const escaped = (s: string): string => s.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
/// Escapes text that would end the element or start a comment in it: in a string or a regular expression the backslash
/// changes nothing.
export const safe_script = (code: string): string => code.replace(/<\/(script)/gi, "<\\/$1").replace(/<!--/g, "<\\!--");
function safe_style(css: string): string {
  if (/<\/style/i.test(css)) throw new Error("a style sheet ends its element");
  return css;
}
