// The report's viewer: one file, script and style inside, and a place for the data that `kadr report` fills.
import { defineConfig } from "vite";
import { inlined } from "./bundling/inlined";
import { notices } from "./bundling/notices";

export default defineConfig({
  base: "./",
  publicDir: false,
  plugins: [notices("report/report-parts.json"), inlined("report.html")],
  build: {
    target: "es2022",
    outDir: "report",
    emptyOutDir: false, // keeps the list of the page's packages, which exists already
    modulePreload: false,
    cssCodeSplit: false,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2000,
    rollupOptions: { input: "report.html", output: { inlineDynamicImports: true } },
  },
});
