// Tests what a report inside an editor and the editor say to each other.
import { describe, expect, it } from "vitest";
import { EditorLink, type FromView } from "../src/report/editor";

function made(): { link: EditorLink; said: FromView[]; lines: number[]; reports: string[] } {
  const said: FromView[] = [],
    lines: number[] = [],
    reports: string[] = [];
  const link = new EditorLink({ postMessage: (m) => said.push(m) });
  link.on_line.on((line) => lines.push(line));
  link.on_report.on((text) => reports.push(text));
  link.show(4); // the first instant
  expect(said.splice(0)).toEqual([{ kind: "ready" }]);
  return { link, said, lines, reports };
}

describe("the view in an editor", () => {
  it("goes to the line of the cursor, and does not send the cursor there again", () => {
    const { link, said, lines } = made();
    link.take({ kind: "line", line: 7 });
    link.show(7);
    expect(lines).toEqual([7]);
    expect(said).toEqual([]);
  });
  it("moves the cursor when another instant is shown, and does not follow that move", () => {
    const { link, said, lines } = made();
    link.show(9);
    link.take({ kind: "line", line: 9 });
    expect(said).toEqual([{ kind: "line", line: 9, file: "", picked: false }]);
    expect(lines).toEqual([]);
    link.take({ kind: "line", line: 3 });
    link.show(9);
    expect(lines).toEqual([3]);
    expect(said).toHaveLength(2);
  });
  it("does not move the cursor when the next report is shown", () => {
    const { link, said, lines } = made();
    link.take({ kind: "line", line: 7 });
    link.opening();
    link.show(8);
    link.take({ kind: "line", line: 7 });
    expect(said).toEqual([{ kind: "ready" }]);
    expect(lines).toEqual([7, 7]);
  });
  it("tells of a click, also in a called file", () => {
    const { link, said } = made();
    link.pick(4, "");
    link.show(4);
    link.pick(2, "sub.nc");
    expect(said).toEqual([
      { kind: "line", line: 4, file: "", picked: true },
      { kind: "line", line: 2, file: "sub.nc", picked: true },
    ]);
  });
  it("takes the next report, and ignores what is no message of an editor", () => {
    const { link, lines, reports } = made();
    link.take({ kind: "report", text: "eNo=" });
    for (const wrong of [
      null,
      5,
      "line",
      {},
      { kind: "line" },
      { kind: "line", line: "4" },
      { kind: "report", text: 1 },
    ])
      link.take(wrong);
    expect(reports).toEqual(["eNo="]);
    expect(lines).toEqual([]);
  });
  it("is not there in a browser", () => {
    expect(EditorLink.of_window()).toBeNull();
  });
});
