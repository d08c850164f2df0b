// Tests names for copies, and what an upload sends.
import { expect, test } from "vitest";
import { base64, folder_part, free_name, name_part } from "../src/model/file_names";

test("a free name counts up, whatever the case", () => {
  expect(free_name("part.nc", new Set())).toBe("part.nc");
  expect(free_name("part.nc", new Set(["sub/PART.nc"]))).toBe("part_2.nc");
  expect(free_name("part_2.nc", new Set(["part.nc", "part_2.nc", "part_3.nc"]))).toBe("part_4.nc");
  expect(free_name("O1001", new Set(["O1001"]))).toBe("O1001_2");
});

test("folders and names", () => {
  expect([folder_part("a/b/c.nc"), name_part("a/b/c.nc")]).toEqual(["a/b", "c.nc"]);
  expect([folder_part("c.nc"), name_part("c.nc")]).toEqual(["", "c.nc"]);
});

test("bytes as base64, more of them than one call can take", () => {
  const bytes = Uint8Array.from({ length: 100_000 }, (_, i) => i % 256);
  const back = atob(base64(bytes));
  expect(back.length).toBe(bytes.length);
  expect(bytes.every((byte, i) => back.charCodeAt(i) === byte)).toBe(true);
});
