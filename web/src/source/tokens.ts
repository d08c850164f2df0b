// The words of a line of G-code, for colouring only: comments, N, G, M, axes, variables, O words. The meaning of a
// word comes from the control, not from this table.
import { is_klartext, klartext_token } from "./klartext";
import type { TokenKind } from "./token_kind";

const keywords =
  "IF THEN ELSE GOTO WHILE DO END ELSEIF ENDIF ENDWHILE SUB ENDSUB CALL RETURN REPEAT ENDREPEAT " +
  "DEF DEFINE PROC EXTERN RET FOR TO ENDFOR LOOP ENDLOOP UNTIL CASE OF DEFAULT GOTOF GOTOB GOTOC REPEATB MCALL " +
  "EQ NE GT GE LT LE AND OR XOR MOD SIN COS TAN ATAN ASIN ACOS SQRT ABS FIX FUP ROUND LN EXP";
const rules: [TokenKind, RegExp][] = [
  ["comment", /^\([^)]*\)?/],
  ["comment", /^;.*/],
  ["program", /^"[^"]*"?/],
  // Controls whose blocks have names: CR=5, $P_UIFR[1,X,TR]=10, CYCLE81(20,0,2)
  ["variable", /^[A-Z_$][A-Z_]\w*(?=(?:\[[^\]]*\])?\s*=(?!=))/i],
  ["keyword", /^[A-Z_][A-Z_]\w*(?=\()/i],
  ["variable", /^#(?:<[^>]*>?|\[|\d+)?/],
  ["keyword", new RegExp(`^(?:${keywords.replaceAll(" ", "|")})(?![A-Z])\\d*`, "i")],
  ["program", /^[O:](?:<[^>]*>|\d+)?/i],
  ["label", /^N\s*\d+/i],
  ["motion", /^G\s*\d+(?:\.\d+)?/i],
  ["function", /^M\s*\d+/i],
  ["feed", /^[FST]\s*[-+]?[\d.]*/i],
  ["axis", /^[XYZABCUVWIJKRDHPQLE]\s*[-+]?[\d.]*/i],
  ["number", /^[-+]?(?:\d+\.?\d*|\.\d+)/],
];

let asked = "",
  answer = false;
/// The line is asked once for each of its tokens.
function klartext_line(line: string): boolean {
  if (line !== asked) [asked, answer] = [line, is_klartext(line)];
  return answer;
}

/// Returns the token that starts at `from`; white space and everything else is a token of one character without a
/// kind.
export function token_at(line: string, from: number): { kind: TokenKind; length: number } {
  if (klartext_line(line)) return klartext_token(line, from);
  const rest = line.slice(from, from + 400);
  for (const [kind, rule] of rules) {
    if (kind === "comment" && rest[0] === "(" && opens_arguments(line, from)) continue;
    const found = rule.exec(rest);
    if (found && found[0].length > 0)
      return { kind, length: kind === "comment" ? comment_length(line, from, found[0].length) : found[0].length };
  }
  return { kind: "", length: 1 };
}

/// True for a parenthesis that is no comment: CYCLE81(20,0,2), X=IC(5), R1=(R2+1)*2, IF (R1>3). Blocks of other controls have none of
/// these: their names have one letter, and their expressions brackets.
export function opens_arguments(line: string, at: number): boolean {
  const before = line.slice(Math.max(0, at - 60), at);
  if (/\b(?:END|DO|GOTO|THEN|ELSE|END\w+)\d*\s*$/i.test(before)) return false;
  return /(?:[A-Z_][A-Z_]\w*|[=+*/<>,([])\s*$/i.test(before);
}

/// A comment may be longer than the window that the rules see.
function comment_length(line: string, from: number, found: number): number {
  if (found < 400) return found;
  const end = line[from] === "(" ? line.indexOf(")", from) : -1;
  return (end < 0 ? line.length : end + 1) - from;
}
