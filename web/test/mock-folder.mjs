// The folder of the mock session: its files, the new ones that are saved, programs made of drawings and tapes.
import { program } from "./mock-program.mjs";
import { problem } from "./mock-problem.mjs";

const saved = new Map(); // new files of the folder: bytes of tapes
const svg =
  '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 300 200" width="300" height="200">' +
  '<rect x="20" y="20" width="260" height="160" fill="none" stroke="#20262e" stroke-width="3"/>' +
  '<circle cx="150" cy="100" r="60" fill="none" stroke="#1f6feb"/></svg>';

export const folder_answers = (s) => ({
  files: (q) => ({
    entries: q.folder
      ? [{ name: "inner.nc", kind: "program", size: 512, modified: 0 }]
      : [
          { name: "fixtures", kind: "folder", size: 0, modified: 0 },
          { name: "long.nc", kind: "program", size: 104857600, modified: 0 },
          { name: "plate.nc", kind: "program", size: 733, modified: 0 },
          { name: "plate_2.nc", kind: "program", size: 735, modified: 0 },
          { name: "plate.json", kind: "setup", size: 96, modified: 0 },
          { name: "notes.txt", kind: "other", size: 20, modified: 0 },
          { name: "cover.txt", kind: "program", size: 200, modified: 0 },
          { name: "lever.dxf", kind: "other", size: 900, modified: 0 },
          ...[...saved.keys()].map((name) => ({ name, kind: "program", size: 99, modified: 0 })),
        ],
  }),
  read: () => ({ text: "G0 X0\n", digest: "d", encoding: "utf-8" }),
  save: (q) => {
    if (q.digest === "old" || /CONFLICT/.test(q.text) || (q.digest === null && saved.has(q.file)))
      throw { text: "changed since", changed: true };
    saved.set(q.file, q.bytes ?? "");
    if (q.text !== undefined) s.text = q.text;
    return { digest: "d2" };
  },
  mill: (q) => {
    if (!(q.depth > 0))
      return { problem: problem(0, { text: "--depth 0 is out of range" }), word: "depth", line_text: "" };
    const layers = Math.ceil(q.depth / (q.pass ?? q.depth));
    return {
      text: program,
      picture: svg,
      summary: [
        { name: "zone", value: "closed; islands: 2" },
        { name: "path", value: `2779.3 mm, ${layers} × Z, lifts: 0` },
      ],
      warning: "",
      name: saved.has("cover.nc") ? "cover_2.nc" : "cover.nc",
    };
  },
  tape: (q) =>
    q.way === "out"
      ? { bytes: btoa(q.text ?? s.text), rows: s.text.length, name: "cover.tape" }
      : saved.get(q.file)
        ? { text: atob(saved.get(q.file)), code: "iso", lies: "", faults: [], more: 0, name: "cover_2.nc" }
        : (() => {
            throw { text: `${q.file}: is no image of a punched tape` };
          })(),
});
