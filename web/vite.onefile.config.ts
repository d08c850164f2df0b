// The page without a server as one HTML file: kadr.html, which opens from the disk.
import { defineConfig, mergeConfig, type UserConfig } from "vite";
import { engine, one_file } from "./bundling/alone";
import { notices } from "./bundling/notices";
import site from "./vite.web.config";

const { plugins: _, ...rest } = site as UserConfig;

export default defineConfig(
  mergeConfig(rest, {
    publicDir: false,
    plugins: [notices("report/web-parts.json"), engine(process.env.KADR_ENGINE ?? "../build/web"), one_file()],
    build: { outDir: "site", emptyOutDir: false, cssCodeSplit: false },
  }),
);
