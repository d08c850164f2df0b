// The words of a conversational block of a Heidenhain control, for colouring only.
import type { TokenKind } from "./token_kind";

const opening =
  "BEGIN PGM|END PGM|BLK FORM|TOOL CALL|TOOL DEF|CYCLE? DEF|CYCLE? CALL|CALL LBL|CALL PGM|CALL SELECTED|SEL \\w+|LBL|" +
  "FN *\\d+:|PLANE|PATTERN DEF|GLOBAL DEF|TCH PROBE|FUNCTION|TRANS DATUM|DECLARE STRING|CONTOUR DEF|APPR|DEP|STOP";
const motion = "LP|LN|L|CC|CTP|CT|CR|CP|C|RND|CHF|FLT|FL|FCT|FC|FPOL";

/// A block begins with its number, or none, and with a statement, a motion before a word, or Q5 = …
const block = new RegExp(
  `^\\s*/?\\s*(?:\\d+\\s+)?/?\\s*(?:(?:${opening})(?![A-Z0-9])|(?:${motion})\\s+(?:I?[XYZABCUVW][-+\\d.Q]|I?P[RA]|` +
    `R[-+0LR\\d]|F|LEN|AN|DR|M\\d|Q|\\d)|Q[LRS]?\\d+\\s*=|\\*\\s)`,
  "i",
);
const structure = /^\s*(?:\d+\s+)?\*/;

const rules: [TokenKind, RegExp][] = [
  ["comment", /^;.*/],
  ["program", /^"[^"]*"?/],
  ["variable", /^[-+]?Q[LRS]?\d+/i],
  ["keyword", new RegExp(`^(?:${opening})(?![A-Z])\\s*`, "i")],
  ["keyword", /^(?:REP|GOTO|IF|EQU|NE|GT|LT|DIV|SQRT|SIN|COS|TAN|POS|PAT|REL|STAY|MOVE|TURN|RESET|MM|INCH)(?![A-Z])/i],
  ["motion", new RegExp(`^(?:${motion})(?=\\s|$)`, "i")],
  ["feed", /^F\s*(?:MAX|AUTO|[UZT]?\s*[-+]?[\d.,]+|(?=[-+]?Q[LR]?\d))/i],
  ["feed", /^S\s*[-+]?[\d.]+/i],
  ["function", /^M\s*\d+/i],
  ["axis", /^(?:R0|RL|RR|DR[-+])(?![A-Z\d])/i],
  [
    "axis",
    /^I?(?:CC[XYZ]|P[RA]|DL|DR2?|LEN|CCA|AN|SP[ABC]|ROT|SCL|[XYZABCUVWRL])\s*(?:[-+]?[\d.,]+|(?=[-+]?Q[LRS]?\d))/i,
  ],
  ["number", /^[-+]?(?:\d+[.,]?\d*|[.,]\d+)/],
];

/// Returns true for a conversational block: a line of word addresses never looks like one.
export const is_klartext = (line: string): boolean => block.test(line);

/// Returns the token that starts at `from` of a conversational block.
export function klartext_token(line: string, from: number): { kind: TokenKind; length: number } {
  if (structure.test(line)) return { kind: from === 0 ? "comment" : "", length: from === 0 ? line.length : 1 };
  const rest = line.slice(from, from + 400);
  if (/^\s*\/?\s*$/.test(line.slice(0, from))) {
    const number = /^\d+(?=\s)/.exec(rest);
    if (number) return { kind: "label", length: number[0].length };
  }
  const inside = from > 0 && /[A-Z_]/i.test(line[from - 1]);
  for (const [kind, rule] of rules) {
    if (inside && kind !== "comment" && kind !== "program" && kind !== "number" && kind !== "variable") continue;
    const found = rule.exec(rest);
    if (found && found[0].length > 0) return { kind, length: found[0].trimEnd().length };
  }
  return { kind: "", length: 1 };
}
