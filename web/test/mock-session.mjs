// The mock session itself: one function per question. `send` accepts text or an ArrayBuffer.
import { part_frame, path_frame, program } from "./mock-server.mjs";

const long_lines = 3_000_000;
const saved = new Map(); // new files of the folder: bytes of tapes
const svg =
  '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 300 200" width="300" height="200">' +
  '<rect x="20" y="20" width="260" height="160" fill="none" stroke="#20262e" stroke-width="3"/>' +
  '<circle cx="150" cy="100" r="60" fill="none" stroke="#1f6feb"/></svg>';
const problem = (line, more) => ({
  id: "feed_missing",
  severity: "alarm",
  number: 1070,
  text: "No feed for motion at feed",
  hint: "Give F in this block or before",
  file: "",
  line,
  column: 1,
  end_column: 8,
  block: "",
  calls: [],
  ...more,
});

export function session(send) {
  let lang = "en",
    open = null,
    path = null,
    text = program,
    stopped = false;
  const event = (name, body) => send(JSON.stringify({ event: name, ...body }));
  const box = [
    [-20, -20, -15],
    [20, 20, 0],
  ];
  const marks = () => [
    { at: 0, kind: "tool", line: 4, text: "T1" },
    { at: path.seconds * 0.4, kind: "warning", line: 9, text: "" },
    { at: path.seconds * 0.58, kind: "stop", line: 14, text: "TURN THE PART" },
    { at: path.seconds * 0.6, kind: "tool", line: 15, text: "T2" },
    { at: path.seconds, kind: "end", line: 20, text: "" },
  ];
  const check = (t) =>
    t.split("\n").flatMap((l, i) =>
      /G1\b(?!.*F)/.test(l)
        ? [
            problem(i + 1, {
              text: lang === "ru" ? "Не задана подача" : "No feed for motion at feed",
              hint: lang === "ru" ? "Задайте F в этом кадре или раньше" : undefined,
              ...(lang === "en" ? { hint: "Give F in this block or before" } : {}),
              fix: {
                text: lang === "ru" ? "Добавить F400" : "Add F400",
                line: i + 1,
                from: l.length + 1,
                to: l.length + 1,
                insert: " F400",
              },
            }),
          ]
        : [],
    );

  async function run() {
    stopped = false;
    for (let i = 1; i <= 4 && !stopped; i++) {
      event("progress", { part: i / 4, blocks: i * 10, seconds: i * 8 });
      await new Promise((r) => setTimeout(r, 30));
    }
    send(path.frame.slice(0));
    for (let k = 0; k < 3; k++)
      event("alarm", {
        at: path.seconds * 0.4 + k,
        problem: problem(9, {
          id: "deep_plunge",
          severity: "warning",
          number: 0,
          text: "Plunges at full feed",
          hint: "Use a helix or a ramp",
        }),
      });
    event("done", {
      state: stopped ? "cancelled" : "ended",
      seconds: path.seconds,
      blocks: path.blocks,
      vertices: path.all.length,
      zero: [0, 0, 0],
      joints: [],
      extents: {
        cutting: box,
        all: [
          [-20, -20, -15],
          [20, 20, 100],
        ],
      },
      distances: { cutting: 402.3, rapid: 812.4 },
      times: { cutting: 30.1, rapid: 4.4, dwell: 0, tools: 6 },
      tools: [
        { tool: 1, from: 0, seconds: path.seconds * 0.6, name: "END MILL 10", radius: 5, length: 82.5 },
        {
          tool: 2,
          from: path.seconds * 0.6,
          seconds: path.seconds * 0.4,
          name: "DRILL 6.8",
          radius: 3.4,
          length: 120.25,
        },
      ],
      marks: marks(),
      axes: ["X", "Y", "Z"],
      units: "mm",
    });
  }

  function state_at(w) {
    let time = 0,
      number = 5,
      line = 0,
      at = null,
      from = 0;
    for (const m of path.all) {
      from = time;
      time += m[7];
      if (m[0] !== line || m[2] !== 4) number++;
      line = m[0];
      at = { m, number };
      if (w.number !== undefined ? number >= w.number : time >= w.at) break;
    }
    const [l, tool, , feed, x, y, z, s] = at.m,
      now = w.at ?? time;
    return {
      at: now,
      number: at.number,
      line: l,
      column: 1,
      file: 0,
      file_name: "",
      block: "",
      text: text.split("\n")[l - 1] ?? "",
      pass: l === 10 ? Math.max(1, Math.round(-z)) : 1,
      depth: 0,
      calls: [],
      position: { X: x, Y: y, Z: z },
      machine: { X: x + 300, Y: y + 200, Z: z - 250 },
      togo: { X: 0, Y: 0, Z: Math.max(0, time - now) },
      feed,
      speed: s ? 640 : 0,
      rpm: 3500,
      tool,
      modal: ["G1", "G17", "G90", "G21", "G94", "G54", "G40", "G43", "G80", "M3", "M8"].map((code, i) => ({
        group: `group ${i + 1}`,
        code,
        changed: i === 0 && l === 9,
      })),
      offsets: { T: tool, D: tool, H: tool, radius: 5, length: { Z: 82.5 } },
      zero: { X: 300, Y: 200, Z: -250 },
      variables: [
        { name: "#1", value: 6 + z, changed: l === 9 },
        { name: "#100", value: 12.5, changed: false },
      ],
      limits: "corner",
      seconds: from,
      left: path.seconds - now,
    };
  }

  const answers = {
    hello: (q) => {
      lang = q.lang;
      return {
        version: "0.9",
        folder: "examples",
        may_change: true,
        last: null,
        controls: [
          { id: "mach3", name: "Mach3" },
          { id: "fanuc", name: "Fanuc 0i" },
          { id: "linuxcnc", name: "LinuxCNC" },
          { id: "grbl", name: "Grbl 1.1" },
        ],
        machines: ["mill3"],
      };
    },
    language: (q) => {
      lang = q.lang;
      return {};
    },
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
    open: (q) => {
      open = q.file;
      text = q.text ?? program;
      path = path_frame();
      setTimeout(run, 10);
      const long = open === "long.nc";
      return {
        file: q.file,
        size: text.length,
        digest: "d1",
        encoding: "utf-8",
        control: { id: q.control ?? "mach3", name: "Mach3", guessed: !q.control, why: "%" },
        machine: q.machine ?? null,
        setup: q.setup ?? null,
        editable: !long,
        lines: long ? long_lines : text.split("\n").length,
        ...(long ? {} : { text }),
      };
    },
    source: (q) => ({
      lines: Array.from(
        { length: Math.min(q.count, long_lines - q.from + 1) },
        (_, i) => `N${q.from + i} G1 X${((q.from + i) % 80) - 40}.5 Y${(q.from + i) % 60} F800`,
      ),
    }),
    state: (q) => state_at(q),
    passes: (q) => {
      const numbers = q.line === 10 ? [9, 11, 13, 15, 17] : [state_of_line(q.line)];
      return {
        passes: numbers.filter(Boolean).map((number) => {
          const at = state_at({ number }).at;
          return { from: at, to: at + 1, number };
        }),
        count: numbers.length,
      };
    },
    check: (q) => ({ problems: check(q.text) }),
    explain: (q) => ({
      words: [...(q.text ?? "").matchAll(/[A-Z]\s*-?[\d.]+/g)].map((m) => ({
        from: m.index + 1,
        to: m.index + 1 + m[0].length,
        code: m[0],
        title: lang === "ru" ? "слово" : "word",
        text: lang === "ru" ? "Что оно значит на этом УЧПУ" : "What it means on this control",
      })),
    }),
    cut: () => {
      void cut();
      return {};
    },
    part: () => {
      send(part_frame());
      return { stock: 96000, left: 91234.5, triangles: 12, seconds: 0.1, cell: 0.25 };
    },
    proposals: () => ({
      stock: "box:-40,-30,-20,40,30,0",
      tools: [
        {
          number: 1,
          kind: "flat",
          diameter: 10,
          flute_length: 22,
          length: 50,
          holder: [
            [32, 0],
            [40, 12],
            [40, 45],
          ],
          name: "END MILL 10",
          from: "comment, line 4",
          known: true,
        },
        {
          number: 2,
          kind: "drill",
          diameter: 6.8,
          angle: 118,
          flute_length: 60,
          length: 80,
          name: "DRILL 6.8",
          from: "comment, line 15",
          known: false,
        },
      ],
    }),
    sheet: () => ({
      program: open,
      control: "Mach3",
      machine: null,
      date: "2026-11-25",
      zeros: [{ name: "G54", values: { X: 300, Y: 200, Z: -250 } }],
      tools: [
        {
          number: 1,
          name: "END MILL 10",
          radius: 5,
          length: 82.5,
          corrector: "D1 H1",
          seconds: 26,
          lines: [4],
          outline: [],
          comment: "END MILL 10",
        },
        {
          number: 2,
          name: "DRILL 6.8",
          radius: 3.4,
          length: 120.25,
          corrector: "H2",
          seconds: 14,
          lines: [15],
          outline: [],
          comment: "DRILL 6.8",
        },
      ],
      extents: { cutting: box, all: box },
      seconds: 40,
      comments: [{ line: 2, text: "PLATE 80 X 60 </script><img src=x onerror=alert(1)>" }],
      stops: [{ line: 14, text: "TURN THE PART", at: 25 }],
    }),
    read: () => ({ text: "G0 X0\n", digest: "d", encoding: "utf-8" }),
    compare: () => {
      const spot = { line: 9, file: 0, number: 8, at: 1, to_line: 10, to_number: 9, to_at: 2 };
      const d = { kind: "way", text: "another way, up to 2 mm apart", distance: 2, a: spot, b: spot };
      setTimeout(() => send(path_frame(2, 1).frame), 10);
      return {
        same: false,
        text: "1 differences, up to 2 mm apart",
        tolerance: 0.001,
        deviation: 2,
        moves: [9, 9],
        first: d,
        differences: [d],
        more: 0,
        lost: false,
      };
    },
    save: (q) => {
      if (q.digest === "old" || /CONFLICT/.test(q.text) || (q.digest === null && saved.has(q.file)))
        throw { text: "changed since", changed: true };
      saved.set(q.file, q.bytes ?? "");
      if (q.text !== undefined) text = q.text;
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
        ? { bytes: btoa(q.text ?? text), rows: text.length, name: "cover.tape" }
        : saved.get(q.file)
          ? { text: atob(saved.get(q.file)), code: "iso", lies: "", faults: [], more: 0, name: "cover_2.nc" }
          : (() => {
              throw { text: `${q.file}: is no image of a punched tape` };
            })(),
    convert: (q) => {
      const lines = text.split("\n"),
        line = lines.findIndex((l) => l.includes("G1")) + 1;
      const tries = [
        "as it stands",
        "with offsets and radius compensation as codes",
        "with the path of the tool's centre",
        "with all offsets calculated in",
      ].map((way, i) => ({
        as: ["as_it_stands", "contours", "lengths", "plain"][i],
        way,
        text: "This control has no code for change_tool",
        line,
        file: 0,
        file_name: "",
        line_text: lines[line - 1],
        written_line: 0,
        written_text: "",
      }));
      if (q.to === "grbl")
        return {
          text: "not converted: no way of writing it for that control could be proven equal",
          tolerance: 0.0009,
          written: null,
          tries,
        };
      return {
        text: "equal: 12 motions, greatest distance 0.0000 mm",
        tolerance: 0.0009,
        tries: tries.slice(0, 1),
        written: {
          proven: true,
          as: "contours",
          way: tries[1].way,
          program: "G21 G90\nG1 X10 F100\nM30\n",
          setup: "{}\n",
          note: "",
          written_out: [],
          name: `plate-${q.to}.nc`,
        },
      };
    },
    stop: () => {
      stopped = true;
      return {};
    },
  };
  const state_of_line = (line) => {
    let number = 5,
      last = 0;
    for (const m of path.all) {
      if (m[0] !== last || m[2] !== 4) number++;
      last = m[0];
      if (m[0] === line) return number;
    }
    return 0;
  };
  async function cut() {
    for (let i = 1; i <= 3; i++) {
      event("cutting", { part: i / 3 });
      await new Promise((r) => setTimeout(r, 30));
    }
    event("finding", {
      id: "rapid_in_stock",
      severity: "alarm",
      number: "",
      hint: "Lift the tool before it goes on.",
      column: 1,
      end_column: 5,
      text: "Tool 1 goes 8 mm deep through material at rapid",
      line: 13,
      block: "N100",
      file: 0,
      calls: [],
      at: path.seconds * 0.55,
      place: [0, 0, -4],
      depth: 8,
      tool: 1,
    });
    event("cut", {
      stock: 96000,
      left: 91234.5,
      removed: 4765.5,
      resolution: 0.25,
      marks: [{ at: path.seconds * 0.55, kind: "alarm", line: 13, text: "rapid_in_stock" }],
    });
  }
  return (message) => {
    const q = JSON.parse(message);
    try {
      send(JSON.stringify({ re: q.id, ...answers[q.do](q) }));
    } catch (e) {
      send(JSON.stringify({ re: q.id, error: { text: e.text ?? e.message, changed: e.changed } }));
    }
  };
}
