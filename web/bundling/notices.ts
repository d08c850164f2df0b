// Lists the packages that a bundle really contains, with their licences and notices, by the modules that the bundler
// read. A licence that may not be embedded stops the build.
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import type { Plugin } from "vite";

const allowed = ["MIT", "BSD-2-Clause", "BSD-3-Clause", "ISC", "Apache-2.0", "BSL-1.0", "0BSD"];

export interface Part {
  name: string;
  version: string;
  licence: string;
  text: string;
}

/// Writes the list into `file`, next to the served files.
export function notices(file: string): Plugin {
  return {
    name: "kadr-notices",
    generateBundle(_, bundle) {
      const folders = new Set<string>();
      for (const chunk of Object.values(bundle)) {
        if (chunk.type !== "chunk") continue;
        for (const id of chunk.moduleIds) {
          const folder = package_of(id);
          if (folder) folders.add(folder);
        }
      }
      for (const id of this.getModuleIds()) {
        const folder = /\.css/.test(id) ? package_of(id) : null;
        if (folder) folders.add(folder);
      } // styles leave no module in a chunk
      const parts = [...folders].map(part_of).sort((a, b) => a.name.localeCompare(b.name, "en"));
      if (!parts.length) throw new Error("no package is in the bundle");
      mkdirSync(dirname(file), { recursive: true });
      writeFileSync(file, JSON.stringify(parts, null, 1));
    },
  };
}

/// Returns the folder of the package that a module belongs to; null for our own modules.
export function package_of(id: string): string | null {
  const found = /^\0?(.*\/node_modules\/(?:@[^/]+\/)?[^/?]+)/.exec(id.replace(/\\/g, "/"));
  return found ? found[1]! : null;
}

export function part_of(folder: string): Part {
  const about = JSON.parse(readFileSync(join(folder, "package.json"), "utf8")) as {
    name: string;
    version: string;
    license?: string;
  };
  const licence = about.license ?? "";
  if (!is_allowed(licence))
    throw new Error(`${about.name} ${about.version}: its licence may not be embedded: ${licence || "none is named"}`);
  const file = readdirSync(folder)
    .sort()
    .find((name) => /^(licen[cs]e|copying|notice)/i.test(name));
  if (!file) throw new Error(`${about.name} ${about.version}: no text of its licence in ${folder}`);
  return { name: about.name, version: about.version, licence, text: readFileSync(join(folder, file), "utf8").trim() };
}

export function is_allowed(licence: string): boolean {
  return licence
    .replace(/[()]/g, "")
    .split(/\s+OR\s+/)
    .some((one) => allowed.includes(one.trim()));
}
