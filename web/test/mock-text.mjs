// What the mock session says about the text of its program: problems, explanations, another version, another control.
import { path_frame } from "./mock-program.mjs";
import { problem } from "./mock-problem.mjs";

export const long_lines = 3_000_000;

const check = (s, t) =>
  t.split("\n").flatMap((l, i) =>
    /G1\b(?!.*F)/.test(l)
      ? [
          problem(i + 1, {
            text: s.lang === "ru" ? "Не задана подача" : "No feed for motion at feed",
            hint: s.lang === "ru" ? "Задайте F в этом кадре или раньше" : undefined,
            ...(s.lang === "en" ? { hint: "Give F in this block or before" } : {}),
            fix: {
              text: s.lang === "ru" ? "Добавить F400" : "Add F400",
              line: i + 1,
              from: l.length + 1,
              to: l.length + 1,
              insert: " F400",
            },
          }),
        ]
      : [],
  );

export const text_answers = (s) => ({
  source: (q) => ({
    lines: Array.from(
      { length: Math.min(q.count, long_lines - q.from + 1) },
      (_, i) => `N${q.from + i} G1 X${((q.from + i) % 80) - 40}.5 Y${(q.from + i) % 60} F800`,
    ),
  }),
  check: (q) => ({ problems: check(s, q.text) }),
  explain: (q) => ({
    words: [...(q.text ?? "").matchAll(/[A-Z]\s*-?[\d.]+/g)].map((m) => ({
      from: m.index + 1,
      to: m.index + 1 + m[0].length,
      code: m[0],
      title: s.lang === "ru" ? "слово" : "word",
      text: s.lang === "ru" ? "Что оно значит на этом УЧПУ" : "What it means on this control",
    })),
  }),
  outline: (q) => {
    const lines = (q.text ?? "").split("\n"),
      tools = lines.flatMap((l, i) => (/\bT(\d+)/.test(l) ? [{ name: `T${/\bT(\d+)/.exec(l)[1]}`, line: i + 1 }] : []));
    const entries = tools.map((tool, i) => ({
      kind: "tool",
      ...tool,
      last: (tools[i + 1]?.line ?? lines.length + 1) - 1,
      depth: 1,
    }));
    return {
      entries: [{ kind: "program", name: "O1", line: 1, last: lines.length, depth: 0 }, ...entries],
      more: false,
    };
  },
  compare: () => {
    const spot = { line: 9, file: 0, number: 8, at: 1, to_line: 10, to_number: 9, to_at: 2 };
    const d = { kind: "way", text: "another way, up to 2 mm apart", distance: 2, a: spot, b: spot };
    setTimeout(() => s.send(path_frame(2, 1).frame), 10);
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
  convert: (q) => {
    const lines = s.text.split("\n"),
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
});
