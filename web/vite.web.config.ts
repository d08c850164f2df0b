// The page without a server, as a folder for any static host: dev/web builds it, and says where the engine is
// (KADR_ENGINE) and what release it is (KADR_VERSION).
import { defineConfig } from "vite";
import { engine, installed, policy } from "./bundling/alone";
import { notices } from "./bundling/notices";

export default defineConfig({
  base: "./",
  plugins: [
    notices("report/web-parts.json"),
    engine(process.env.KADR_ENGINE ?? "../build/web"),
    policy(),
    installed(process.env.KADR_VERSION ?? "0"),
  ],
  resolve: {
    alias: [{ find: /^.*\/protocol\/way$/, replacement: new URL("src/engine/way.ts", import.meta.url).pathname }],
  },
  build: {
    target: "es2022",
    outDir: "site",
    modulePreload: false,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2000,
    rollupOptions: {
      output: {
        inlineDynamicImports: true,
        entryFileNames: "page.js",
        assetFileNames: "[name][extname]",
      },
    },
  },
});
