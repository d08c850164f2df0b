// A plugin of Vite: the page must be small, so that it appears at once over the network of a workshop. A build whose
// files are larger when compressed fails.
import { gzipSync } from "node:zlib";
import type { Plugin } from "vite";

const most = 2_000_000; // bytes of all files, each compressed with gzip

export function at_most(limit = most): Plugin {
  return {
    name: "kadr-size",
    generateBundle(_options, files) {
      const sizes = Object.values(files).map((f) => gzipSync(f.type === "chunk" ? f.code : f.source).length),
        all = sizes.reduce((a, b) => a + b, 0);
      if (all > limit) this.error(`the page has ${all} bytes compressed; at most ${limit} are allowed`);
    },
  };
}
