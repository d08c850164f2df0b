// True if a run contains sentences, which are in the language of the time of the run.
import type { Done, Finding, Mark, Problem } from "../protocol/types";

export function has_texts(run: {
  running: boolean;
  problems: Problem[];
  findings: Finding[];
  done: Done | null;
  marks: Mark[];
}): boolean {
  return (
    run.running ||
    run.problems.length > 0 ||
    run.findings.length > 0 ||
    Boolean(run.done?.unstated) ||
    run.marks.some((m) => m.text !== "" && m.kind !== "tool" && m.kind !== "message")
  );
}
