// Tests that cursor and view lead each other without an echo.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Follow, read_message } from "../src/follow";

test("a move is told once to the other side", () => {
  const follow = new Follow();
  assert.deepEqual(follow.begin(3), { kind: "line", line: 3 });
  assert.equal(follow.cursor(3), null);
  assert.deepEqual(follow.cursor(4), { kind: "line", line: 4 });
  assert.equal(follow.view(4), null);
  assert.equal(follow.view(9), 9);
  assert.equal(follow.cursor(9), null, "the cursor is there because the view has put it there");
  assert.deepEqual(follow.cursor(4), { kind: "line", line: 4 });
});

test("the next report gets the line again", () => {
  const follow = new Follow();
  follow.begin(3);
  assert.deepEqual(follow.begin(3), { kind: "line", line: 3 });
});

test("only messages of the view are read", () => {
  assert.deepEqual(read_message({ kind: "ready", more: 1 }), { kind: "ready" });
  const line = { kind: "line", line: 5, file: "", picked: true };
  assert.deepEqual(read_message(line), line);
  assert.deepEqual(read_message({ kind: "line", line: 5 }), { ...line, picked: false });
  for (const wrong of [null, 1, "line", {}, { kind: "line" }, { ...line, line: 0 }, { ...line, line: 1.5 }])
    assert.equal(read_message(wrong), null, JSON.stringify(wrong));
});
