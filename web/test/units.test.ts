// Tests figures in the shown unit: the program's own, until another is chosen for it.
import { beforeEach, expect, test, vi } from "vitest";
import { choose_unit, take_program_unit, unit } from "../src/model/units";
import { on_language, set_language } from "../src/texts/texts";
import { axis_value, feed, length, length_told, volume_told } from "../src/ui/figures";
import { ramp_figures } from "../src/ui/legend";

beforeEach(() => {
  vi.stubGlobal("document", { documentElement: {} });
  set_language("en");
  take_program_unit("none", "mm");
});

test("lengths, feeds and volumes are in the unit, degrees stay", () => {
  const all = (): string[] => [
    length(81.28),
    length_told(-25.4),
    feed(254, 1),
    axis_value("X", 25.4),
    axis_value("C", 25.4),
  ];
  expect(all()).toEqual(["81.280", "-25.400 mm", "254", "25.400", "25.400"]);
  take_program_unit("inch.nc", "inch");
  expect(all()).toEqual(["3.2000", "-1.0000 in", "10", "1.0000", "25.400"]);
  expect(volume_told(25.4 ** 3)).toBe("1 in³");
  expect(ramp_figures("feed", [254, 508])).toEqual(["10", "12.5", "15", "17.5", "20"]);
  expect(length(-0.00001)).toBe("0.0000");
  expect(length(undefined)).toBe("–");
  set_language("ru");
  expect(length_told(25.4)).toBe("1.0000 дюйм");
});

test("what is chosen holds for the program, run as often as it is", () => {
  let written = 0;
  const off = on_language(() => written++);
  take_program_unit("a.nc", "inch");
  expect([unit(), written]).toEqual(["inch", 1]);
  choose_unit("mm");
  take_program_unit("a.nc", "inch");
  expect([unit(), written]).toEqual(["mm", 2]);
  take_program_unit("b.nc", "inch");
  expect([unit(), written]).toEqual(["inch", 3]);
  take_program_unit("b.nc", "inch");
  expect(written).toBe(3);
  off();
});
