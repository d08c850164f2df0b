// Tests what the page shows of lathes: diameters, the half section, the blank, inserts.
import { beforeEach, describe, expect, it, vi } from "vitest";
import { axis_name, factor, widest } from "../src/model/diameters";
import { cylinder_of, extent_of, stock_of_cylinder } from "../src/model/stock";
import { with_inserts } from "../src/model/tool_shape";
import { take_program_unit } from "../src/model/units";
import { area2, faces_of, hatching, is_inside, outline, size_of, type SectionPoint } from "../src/scene/section";
import { insert_mesh, section_view, quarter_planes } from "../src/scene/turned_view";
import { light } from "../src/scene/colours";
import { set_language } from "../src/texts/texts";
import { axis_value, point_told, surface_figure } from "../src/ui/figures";
import { Box3, type Mesh } from "three";

beforeEach(() => {
  vi.stubGlobal("document", { documentElement: {} });
  set_language("en");
  take_program_unit("none", "mm");
});

const square: SectionPoint[] = [
  [0, 0],
  [10, 0],
  [10, 10],
  [0, 10],
];
const hole: SectionPoint[] = [
  [2, 2],
  [2, 4],
  [4, 4],
  [4, 2],
];

describe("diameters", () => {
  it("are twice the length of the axes that have them, with a sign", () => {
    expect([axis_value("X", 12.5, ["X"]), axis_value("Z", 12.5, ["X"]), axis_value("X", 12.5)]).toEqual([
      "25.000",
      "12.500",
      "12.500",
    ]);
    expect([axis_name("X", ["X"]), axis_name("Z", ["X"]), axis_name("C", ["C"])]).toEqual(["X Ø", "Z", "C"]);
    expect(factor("C", ["C"])).toBe(1); // degrees are no diameter
    expect(axis_value("X", undefined, ["X"])).toBe("–");
    expect(widest(-3, 2)).toBe(6);
  });

  it("are told at a point, in inches too", () => {
    expect(point_told([10, 0, -5], ["X"], ["X", "Z"])).toBe("X Ø 20.000  Z -5.000");
    expect(point_told([1, 2, 3], [], ["X", "Y", "Z"], "Δ")).toBe("ΔX 1.000  ΔY 2.000  ΔZ 3.000");
    take_program_unit("inch.nc", "inch");
    expect(point_told([12.7, 0, 25.4], ["X"], ["X", "Z"])).toBe("X Ø 1.0000  Z 1.0000");
    expect(surface_figure(30.48)).toBe("100"); // ft/min
  });
});

describe("the half section", () => {
  it("has faces with holes", () => {
    expect([area2(square), area2(hole)]).toEqual([200, -8]);
    expect([is_inside([3, 3], hole), is_inside([5, 3], hole)]).toEqual([true, false]);
    const faces = faces_of([hole, square]);
    expect(faces).toEqual([{ outer: square, holes: [hole] }]);
  });

  it("is hatched inside only, evenly", () => {
    const ends = hatching([square, hole], 1);
    expect(ends.length % 2).toBe(0);
    let along = 0;
    for (let i = 0; i < ends.length; i += 2) {
      const [a, b] = [ends[i]!, ends[i + 1]!];
      expect(b[1] - b[0]).toBeCloseTo(a[1] - a[0], 9); // 45°
      const middle: SectionPoint = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
      expect(is_inside(middle, square) && !is_inside(middle, hole)).toBe(true);
      along += Math.hypot(b[0] - a[0], b[1] - a[1]);
    }
    // the length of all lines times their distance is the area
    expect((along * 1) / Math.SQRT2).toBeCloseTo(96, 0);
  });

  it("has no line on the axis", () => {
    expect(outline([square]).length).toBe(6);
    expect(size_of([square, hole])).toBe(10);
    expect(size_of([])).toBe(0);
  });

  it("lies in the planes through the axis, above it and towards the viewer", () => {
    const view = section_view(
      { section: [square], section_y: [square], edges: [[10, 10]] },
      5,
      light,
      quarter_planes(),
    );
    view.updateMatrixWorld(true);
    const [y0, x0] = view.children;
    const extent = (k: number): number[][] => {
      const box = new Box3().setFromObject(view.children[k]!);
      return [box.min.toArray(), box.max.toArray()].map((p) => p.map((v) => Math.round(v * 1e6) / 1e6 + 0));
    };
    expect([y0, x0].every(Boolean)).toBe(true);
    expect(extent(0)).toEqual([
      [0, 0, -5],
      [10, 0, 5],
    ]);
    expect(extent(1)).toEqual([
      [0, 0, -5],
      [0, 10, 5],
    ]);
    const [a, b] = quarter_planes();
    const gone = (x: number, y: number): boolean =>
      [a!, b!].every((p) => p.normal.x * x + p.normal.y * y + p.constant < 0);
    expect([gone(1, 1), gone(1, -1), gone(-1, 1), gone(-1, -1)]).toEqual([true, false, false, false]);
  });
});

describe("blank and inserts", () => {
  it("reads and writes a cylinder", () => {
    const bar = { from: -80, to: 1, diameter: 60, bore: 0 };
    expect(cylinder_of("cylinder:0,0,-80,1,60")).toEqual(bar);
    expect(stock_of_cylinder({ ...bar, bore: 20 })).toBe("cylinder:0,0,-80,1,60,20");
    expect(cylinder_of(stock_of_cylinder({ ...bar, bore: 20 }))).toEqual({ ...bar, bore: 20 });
    expect([cylinder_of("cylinder:5,0,-80,1,60"), cylinder_of("box:0,0,0,1,1,1"), cylinder_of("cylinder:x")]).toEqual([
      null,
      null,
      null,
    ]);
    expect(extent_of("cylinder:0,0,-80,1,60")).toEqual([
      [-30, -30, -80],
      [30, 30, 1],
    ]);
    expect(extent_of("box:0,0,0,1,2,3")).toEqual([
      [0, 0, 0],
      [1, 2, 3],
    ]);
  });

  it("draws the insert of its tool behind the plane of the section", () => {
    const insert = {
      tool: 1,
      part: "cutting" as const,
      outline: [
        [0, 0],
        [5, 1],
        [4, 6],
      ] as [number, number][],
    };
    const shape = { number: 1, cutting: [], shank: [], holder: [] };
    expect(with_inserts(shape, [insert, { ...insert, tool: 2 }]).inserts).toEqual([insert]);
    expect(with_inserts({ ...shape, number: 3 }, [insert]).inserts).toBeUndefined();
    const group = insert_mesh([insert], light);
    group.updateMatrixWorld(true);
    const box = new Box3().setFromObject(group.children[0] as Mesh);
    expect(box.min.toArray().map(Math.round)).toEqual([0, -4, 0]);
    expect(box.max.toArray().map((v) => Math.round(v) + 0)).toEqual([5, 0, 6]);
  });
});
