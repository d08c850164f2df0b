// Tests the part of the time that slider and strip show, and the top of the strip's scale.
import { expect, test } from "vitest";
import { TimeWindow, top_of } from "../src/model/time_window";

test("instants and shares of the width are each other's inverse, within the bar", () => {
  const shown = new TimeWindow(() => 40);
  expect([shown.instant_at(0.25), shown.share_of(10)]).toEqual([10, 0.25]);
  expect([shown.instant_at(-1), shown.instant_at(2)]).toEqual([0, 40]);
  expect(new TimeWindow(() => 0).share_of(5)).toBe(0);
});

test("zooming keeps the instant under the mouse at its place, and never leaves the program", () => {
  const shown = new TimeWindow(() => 100);
  shown.zoom(0.5, 80);
  expect([shown.from, shown.seconds]).toEqual([40, 50]);
  expect(shown.share_of(80)).toBeCloseTo(0.8, 12);
  shown.zoom(0.5, 90);
  expect(shown.from + shown.seconds).toBeLessThanOrEqual(100);
  shown.move(5);
  expect(shown.from + shown.seconds).toBeCloseTo(100, 9);
  shown.move(-50);
  expect(shown.from).toBe(0);
  for (let i = 0; i < 50; i++) shown.zoom(0.5, 3);
  expect(shown.seconds).toBeCloseTo(0.05, 6);
  for (let i = 0; i < 50; i++) shown.zoom(2, 3);
  expect(shown.is_whole).toBe(true);
});

test("the window follows an instant that has left it", () => {
  const shown = new TimeWindow(() => 100);
  shown.zoom(0.1, 5);
  shown.follow(50);
  expect(shown.share_of(50)).toBeGreaterThanOrEqual(0);
  expect(shown.share_of(50)).toBeLessThanOrEqual(1);
});

test("one wrong feed does not flatten all others", () => {
  const usual = Array.from({ length: 200 }, (_, i) => 400 + i);
  expect(top_of(usual)).toBe(599);
  expect(top_of([...usual, 1_000_000])).toBeLessThan(1000);
  expect(top_of([NaN, 0])).toBe(1);
  expect(top_of([100, 200, 300])).toBe(300);
});
