// Plugins of Vite for the page without a server: its engine, the policy that forbids connections, what makes it
// installable, and the page as one file.
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { transformWithEsbuild, type Plugin, type Rollup } from "vite";

const worker = new URL("../src/engine/worker.ts", import.meta.url).pathname;

/// Emscripten's script and the worker's, which are one script, and the WebAssembly.
export function engine(from: string): Plugin {
  return {
    name: "kadr-engine",
    async generateBundle() {
      const glue = readFileSync(join(from, "kadr_page.js"), "utf8"),
        own = await transformWithEsbuild(readFileSync(worker, "utf8"), worker, { minify: true, target: "es2022" });
      this.emitFile({ type: "asset", fileName: "engine.js", source: `${glue}\n{${own.code}}\n` });
      this.emitFile({ type: "asset", fileName: "kadr_page.wasm", source: readFileSync(join(from, "kadr_page.wasm")) });
      for (const name of ["report.html", "licences.txt"])
        this.emitFile({ type: "asset", fileName: name, source: readFileSync(join("report", name)) });
    },
  };
}

const rules = (scripts: string, styles: string, connect: string): string =>
  `default-src 'none'; script-src ${scripts} 'wasm-unsafe-eval'; worker-src 'self' blob:; style-src ${styles}; ` +
  `img-src 'self' blob:; connect-src ${connect}; manifest-src 'self'; base-uri 'none'; form-action 'none'`;

const with_policy = (html: string, text: string): string =>
  html.replace(
    '<meta charset="utf-8">',
    () => `<meta charset="utf-8">\n<meta http-equiv="Content-Security-Policy" content="${text}">`,
  );

/// The page may load its own parts; then it forbids itself even that (src/engine/parts.ts).
export function policy(): Plugin {
  return {
    name: "kadr-policy",
    transformIndexHtml: (html) =>
      with_policy(html, rules("'self' blob:", "'self' 'unsafe-inline'", "'self' blob:")).replace(
        "</head>",
        '<link rel="manifest" href="manifest.webmanifest">\n</head>',
      ),
  };
}

const own_files = ["manifest.webmanifest", "icon-192.png", "icon-512.png"];

/// The service worker knows the parts of this build by their contents, so that another build replaces them together.
export function installed(version: string): Plugin {
  return {
    name: "kadr-installed",
    enforce: "post",
    generateBundle(_, bundle) {
      for (const name of own_files)
        this.emitFile({
          type: "asset",
          fileName: name,
          source: readFileSync(new URL(`../alone/${name}`, import.meta.url)),
        });
      const parts = Object.values(bundle).filter((f) => !f.fileName.endsWith(".map")),
        hash = createHash("sha256");
      for (const part of parts) hash.update(part.fileName).update(content_of(part));
      const names = [...new Set([...parts.map((f) => f.fileName), "icon.svg"])],
        text = readFileSync(new URL("../src/engine/offline.js", import.meta.url), "utf8")
          .replace("KADR_NAME", JSON.stringify(`kadr-${version}-${hash.digest("hex").slice(0, 16)}`))
          .replace("KADR_PARTS", JSON.stringify(names));
      this.emitFile({ type: "asset", fileName: "offline.js", source: text });
    },
  };
}

const content_of = (part: Rollup.OutputAsset | Rollup.OutputChunk): string | Uint8Array =>
  part.type === "chunk" ? part.code : part.source;

/// Unpacks the script of the page, and begins it. The policy of the page names both scripts by their hashes.
const unpacks =
  'const packed=document.getElementById("kadr-page-script").textContent,' +
  "bytes=Uint8Array.from(atob(packed),(c)=>c.charCodeAt(0))," +
  'unpacked=new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")),' +
  'script=document.createElement("script");' +
  'script.type="module";script.textContent=await new Response(unpacked).text();document.body.append(script);';

/// Puts everything into the HTML: a file that opens by a double click, and may connect to nothing at all.
export function one_file(): Plugin {
  return {
    name: "kadr-one-file",
    enforce: "post",
    generateBundle(_, bundle) {
      const html = bundle["index.html"];
      if (html?.type !== "asset") throw new Error("index.html was not built");
      const take = (name: string): string | Uint8Array => {
        const part = bundle[name];
        if (!part) throw new Error(`${name} was not built`);
        delete bundle[name];
        return content_of(part);
      };
      const packed = (name: string, id: string): string =>
        `<script type="text/plain" id="${id}">${gzipSync(take(name), { level: 9 }).toString("base64")}</script>\n`;
      const script = String(content_of(bundle["page.js"]!)),
        style = String(take(Object.keys(bundle).find((name) => name.endsWith(".css")) ?? "a style")),
        hash = (code: string): string => `'sha256-${createHash("sha256").update(code).digest("base64")}'`,
        parts =
          packed("page.js", "kadr-page-script") +
          packed("engine.js", "kadr-engine-script") +
          packed("kadr_page.wasm", "kadr-engine-wasm") +
          packed("report.html", "kadr-engine-report") +
          packed("licences.txt", "kadr-engine-licences");
      let text = String(html.source);
      text = text
        .replace(/<script type="module"[^>]*><\/script>/, "")
        .replace(/<link rel="(stylesheet|icon|manifest)"[^>]*>/g, "");
      text = text.replace("</head>", () => `<style>${style}</style>\n</head>`);
      text = text.replace("</body>", () => `${parts}<script type="module">${unpacks}</script>\n</body>`);
      html.source = with_policy(text, rules(`${hash(unpacks)} ${hash(script)} blob:`, "'unsafe-inline'", "blob:"));
      html.fileName = "kadr.html";
    },
  };
}
