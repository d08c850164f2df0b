// What the mock session does with its program: it runs, it is cut, it has a state at each instant. `s`: the session.
import { part_frame } from "./mock-program.mjs";
import { box, problem } from "./mock-problem.mjs";

const marks = (path) => [
  { at: 0, kind: "tool", line: 4, text: "T1" },
  { at: path.seconds * 0.4, kind: "warning", line: 9, text: "" },
  { at: path.seconds * 0.58, kind: "stop", line: 14, text: "TURN THE PART" },
  { at: path.seconds * 0.6, kind: "tool", line: 15, text: "T2" },
  { at: path.seconds, kind: "end", line: 20, text: "" },
];

export async function run(s) {
  s.stopped = false;
  for (let i = 1; i <= 4 && !s.stopped; i++) {
    s.event("progress", { part: i / 4, blocks: i * 10, seconds: i * 8 });
    await new Promise((r) => setTimeout(r, 30));
  }
  s.send(s.path.frame.slice(0));
  for (let k = 0; k < 3; k++)
    s.event("alarm", {
      at: s.path.seconds * 0.4 + k,
      problem: problem(9, {
        id: "deep_plunge",
        severity: "warning",
        number: 0,
        text: "Plunges at full feed",
        hint: "Use a helix or a ramp",
      }),
    });
  s.event("done", {
    state: s.stopped ? "cancelled" : "ended",
    seconds: s.path.seconds,
    blocks: s.path.blocks,
    vertices: s.path.all.length,
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
      { tool: 1, from: 0, seconds: s.path.seconds * 0.6, name: "END MILL 10", radius: 5, length: 82.5 },
      {
        tool: 2,
        from: s.path.seconds * 0.6,
        seconds: s.path.seconds * 0.4,
        name: "DRILL 6.8",
        radius: 3.4,
        length: 120.25,
      },
    ],
    marks: marks(s.path),
    axes: ["X", "Y", "Z"],
    units: "mm",
  });
}

async function cut(s) {
  for (let i = 1; i <= 3; i++) {
    s.event("cutting", { part: i / 3 });
    await new Promise((r) => setTimeout(r, 30));
  }
  s.event("finding", {
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
    at: s.path.seconds * 0.55,
    place: [0, 0, -4],
    depth: 8,
    tool: 1,
  });
  s.event("cut", {
    stock: 96000,
    left: 91234.5,
    removed: 4765.5,
    resolution: 0.25,
    marks: [{ at: s.path.seconds * 0.55, kind: "alarm", line: 13, text: "rapid_in_stock" }],
  });
}

function state_at(s, w) {
  let time = 0,
    number = 5,
    line = 0,
    at = null,
    from = 0;
  for (const m of s.path.all) {
    from = time;
    time += m[7];
    if (m[0] !== line || m[2] !== 4) number++;
    line = m[0];
    at = { m, number };
    if (w.number !== undefined ? number >= w.number : time >= w.at) break;
  }
  const [l, tool, , feed, x, y, z, seconds] = at.m,
    now = w.at ?? time;
  return {
    at: now,
    number: at.number,
    line: l,
    column: 1,
    file: 0,
    file_name: "",
    block: "",
    text: s.text.split("\n")[l - 1] ?? "",
    pass: l === 10 ? Math.max(1, Math.round(-z)) : 1,
    depth: 0,
    calls: [],
    position: { X: x, Y: y, Z: z },
    machine: { X: x + 300, Y: y + 200, Z: z - 250 },
    togo: { X: 0, Y: 0, Z: Math.max(0, time - now) },
    feed,
    speed: seconds ? 640 : 0,
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
    left: s.path.seconds - now,
  };
}

function state_of_line(s, line) {
  let number = 5,
    last = 0;
  for (const m of s.path.all) {
    if (m[0] !== last || m[2] !== 4) number++;
    last = m[0];
    if (m[0] === line) return number;
  }
  return 0;
}

export const run_answers = (s) => ({
  state: (q) => state_at(s, q),
  passes: (q) => {
    const numbers = q.line === 10 ? [9, 11, 13, 15, 17] : [state_of_line(s, q.line)];
    return {
      passes: numbers.filter(Boolean).map((number) => {
        const at = state_at(s, { number }).at;
        return { from: at, to: at + 1, number };
      }),
      count: numbers.length,
    };
  },
  cut: () => {
    void cut(s);
    return {};
  },
  part: () => {
    s.send(part_frame());
    return { stock: 96000, left: 91234.5, triangles: 12, seconds: 0.1, cell: 0.25 };
  },
});
