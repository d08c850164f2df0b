// A turned part in half section: the quarter towards the viewer and above the axis is taken away, the cut faces are
// hatched, edges of the outside are lines. Also the insert of a turning tool.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  ExtrudeGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Plane,
  Shape,
  ShapeGeometry,
  Vector2,
  Vector3,
} from "three";
import type { Insert } from "../protocol/types";
import type { Theme } from "./colours";
import {
  faces_of,
  hatching,
  outline,
  size_of,
  type SectionPoint,
  type SectionPolygon,
  type TurnedSection,
} from "./section";

const hatch_lines = 70; // along the part
const around = 96; // chords of a circle
const insert_thickness = 4,
  holder_thickness = 14; // mm

/// What is taken away is on the outer side of both planes.
export const quarter_planes = (): Plane[] => [new Plane(new Vector3(-1, 0, 0), 0), new Plane(new Vector3(0, -1, 0), 0)];

/// The half plane X from the axis towards +X, seen from +Y, and the half plane from the axis towards +Y, seen from +X.
const on_y0 = new Matrix4().makeBasis(new Vector3(1, 0, 0), new Vector3(0, 0, 1), new Vector3(0, -1, 0));
const on_x0 = new Matrix4().makeBasis(new Vector3(0, 1, 0), new Vector3(0, 0, 1), new Vector3(1, 0, 0));

const shape_path = (p: SectionPolygon): Vector2[] => p.map(([r, z]) => new Vector2(r, z));

function lines(points: readonly SectionPoint[], colour: number, opacity: number): LineSegments {
  const at = new Float32Array(points.flatMap(([r, z]) => [r, z, 0]));
  return new LineSegments(
    new BufferGeometry().setAttribute("position", new BufferAttribute(at, 3)),
    new LineBasicMaterial({ color: colour, transparent: opacity < 1, opacity }),
  );
}

/// The cut face in the plane of `place`: filled, hatched, with its outline.
function face(polygons: readonly SectionPolygon[], place: Matrix4, theme: Theme): Group {
  const group = new Group(),
    step = size_of(polygons) / hatch_lines;
  const shapes = faces_of(polygons).map(({ outer, holes }) => {
    const shape = new Shape(shape_path(outer));
    shape.holes = holes.map((hole) => new Shape(shape_path(hole)));
    return shape;
  });
  group.add(
    new Mesh(
      new ShapeGeometry(shapes),
      new MeshBasicMaterial({
        color: theme.section,
        side: DoubleSide,
        polygonOffset: true,
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 1,
      }),
    ),
  );
  if (step > 0) group.add(lines(hatching(polygons, step), theme.ink, 0.35));
  group.add(lines(outline(polygons), theme.ink, 1));
  group.applyMatrix4(place);
  return group;
}

/// Circles around the axis at the edges of the surface.
function rings(edges: readonly SectionPoint[], theme: Theme, planes: Plane[]): LineSegments {
  const points: number[] = [];
  for (const [r, z] of edges)
    for (let i = 0; i < around; i++)
      for (const k of [i, i + 1]) {
        const a = (2 * Math.PI * k) / around;
        points.push(r * Math.cos(a), r * Math.sin(a), z);
      }
  return new LineSegments(
    new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(points), 3)),
    new LineBasicMaterial({ color: theme.ink, clippingPlanes: planes, clipIntersection: true }),
  );
}

/// `zero`: of the picture along Z.
export function section_view(s: TurnedSection, zero: number, theme: Theme, planes: Plane[]): Group {
  const group = new Group();
  group.add(face(s.section, on_y0, theme), face(s.section_y, on_x0, theme), rings(s.edges, theme, planes));
  group.position.z = -zero;
  return group;
}

/// The insert and the holder of a turning tool, with the programmed point at the origin. Its face is in the plane Y0.
export function insert_mesh(inserts: readonly Insert[], theme: Theme): Group {
  const group = new Group();
  for (const { part, outline: points } of inserts) {
    const holder = part === "holder";
    const body = new Mesh(
      new ExtrudeGeometry(new Shape(shape_path(points)), {
        depth: holder ? holder_thickness : insert_thickness,
        bevelEnabled: false,
      }),
      new MeshLambertMaterial({
        color: holder ? theme.holder : theme.tool,
        transparent: true,
        opacity: part === "cutting" ? 0.95 : 0.6,
        side: DoubleSide,
      }),
    );
    body.applyMatrix4(on_y0);
    group.add(body, contour(points, theme));
  }
  return group;
}

function contour(points: SectionPolygon, theme: Theme): LineSegments {
  const edges = lines(outline_of(points), theme.ink, 1);
  edges.applyMatrix4(on_y0);
  return edges;
}
const outline_of = (p: SectionPolygon): SectionPoint[] => p.flatMap((a, i) => [a, p[(i + 1) % p.length]!]);
