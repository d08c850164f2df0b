// The page is one folder of files without version hashes in their names: the server embeds it like the control files.
import { defineConfig } from "vite";
import { notices } from "./bundling/notices";
import { at_most } from "./bundling/size";

export default defineConfig({
  base: "./",
  plugins: [notices("report/page-parts.json"), at_most()],
  build: {
    target: "es2022",
    outDir: "dist",
    assetsInlineLimit: 0, // no data: addresses: the page's content security policy forbids them
    chunkSizeWarningLimit: 2000,
    rollupOptions: {
      output: { entryFileNames: "page.js", chunkFileNames: "[name].js", assetFileNames: "[name][extname]" },
    },
  },
  server: { proxy: { "/session": { target: "ws://127.0.0.1:8437", ws: true } } },
});
