// The page is one folder of files without names of versions in them: the server embeds it as the control files are.
import { defineConfig } from "vite";
import { notices } from "./bundling/notices";

export default defineConfig({
  base: "./",
  plugins: [notices("report/page-parts.json")],
  build: {
    target: "es2022",
    outDir: "dist",
    assetsInlineLimit: 0, // nothing by data: address: the page's policy of content forbids it
    chunkSizeWarningLimit: 2000,
    rollupOptions: {
      output: { entryFileNames: "page.js", chunkFileNames: "[name].js", assetFileNames: "[name][extname]" },
    },
  },
  server: { proxy: { "/session": { target: "ws://127.0.0.1:8437", ws: true } } },
});
