// The one list of all problems: what the run met, what the current text of the editor would meet, what the cut hit.
// Every view of problems shows this list, or a part of it.
import type { Finding, Problem } from "../protocol/types";

export interface Listing {
  problems: Problem[]; // of the run
  checked: Problem[] | null; // of the current text in the editor
  findings: Finding[]; // of the cut
  text: string | null;
  ran: string | null;
  cut_text: string | null;
}

export const is_of_cut = (p: Problem): p is Finding => "place" in p;

/// Problems of the run belong to the text that was run: for any other text only the check counts. Collisions are known
/// only to the cut: they stay until the next cut, or until the program runs again for another reason than an edit.
export function listed(of: Listing): Problem[] {
  return [...of_text(of), ...of.findings];
}

/// Problems whose lines are lines of the current text in the editor.
export function of_shown_text(of: Listing): Problem[] {
  return of.text === of.cut_text ? listed(of) : of_text(of);
}

export const listed_of_cut = (of: Listing): Finding[] => listed(of).filter(is_of_cut);

function of_text({ problems, checked, text, ran }: Listing): Problem[] {
  if (!checked) return problems;
  return text === ran ? [...problems, ...checked.filter((c) => !problems.some((p) => is_same(p, c)))] : checked;
}

function is_same(a: Problem, b: Problem): boolean {
  return a.id === b.id && a.line === b.line && (a.file ?? 0) === (b.file ?? 0);
}
