// Limits of overrides, and comments of a line.
import { expect, it } from "vitest";
import { comments_of } from "../src/model/comments";
import { bounded_override, most_feed } from "../src/model/overrides";

it("overrides stay within their limits", () => {
  expect(bounded_override("override", 160, most_feed(false))).toBe(150);
  expect(bounded_override("override", 160, most_feed(true))).toBe(160);
  expect(bounded_override("override", 210, most_feed(true))).toBe(200);
  expect(bounded_override("override", -10, 150)).toBe(0);
  expect(bounded_override("rapid", 110, 150)).toBe(100);
  expect(bounded_override("spindle", 40, 150)).toBe(50);
  expect(bounded_override("spindle", 130, 150)).toBe(120);
});

it("comments are found in brackets and behind a semicolon", () => {
  expect(comments_of("M0 (TURN THE PART)")).toBe("TURN THE PART");
  expect(comments_of("N10 M0 ( A ) G4 (B) ; c (d)")).toBe("A B c (d)");
  expect(comments_of("M0 (not closed")).toBe("not closed");
  expect(comments_of("M0 ; (x)")).toBe("(x)");
  expect(comments_of("M0 ()")).toBe("");
  expect(comments_of("M0 R1=(2+3) ; TURN THE PART", "sinumerik")).toBe("TURN THE PART");
  expect(comments_of('MSG("A;B"<<(R1))', "sinumerik")).toBe("");
});
