// The half section of a turned part, as lathes show it: arithmetic of its polygons. A point is [radius, Z].
export type SectionPoint = readonly [number, number];
export type SectionPolygon = readonly SectionPoint[];
/// A polygon with the holes in it.
export interface SectionFace {
  outer: SectionPolygon;
  holes: SectionPolygon[];
}
export interface TurnedSection {
  section: readonly SectionPolygon[]; // by the plane Y0
  section_y: readonly SectionPolygon[]; // by the plane X0
  edges: SectionPolygon; // circles at which the surface has an edge
}

/// Returns twice the signed area; positive: counter-clockwise.
export function area2(p: SectionPolygon): number {
  let sum = 0;
  for (let i = 0; i < p.length; i++) {
    const a = p[i]!,
      b = p[(i + 1) % p.length]!;
    sum += a[0] * b[1] - b[0] * a[1];
  }
  return sum;
}

export function is_inside([x, z]: SectionPoint, p: SectionPolygon): boolean {
  let inside = false;
  for (let i = 0; i < p.length; i++) {
    const a = p[i]!,
      b = p[(i + 1) % p.length]!;
    if (a[1] > z !== b[1] > z && x < a[0] + ((b[0] - a[0]) * (z - a[1])) / (b[1] - a[1])) inside = !inside;
  }
  return inside;
}

/// Outer polygons are counter-clockwise, holes clockwise.
export function faces_of(polygons: readonly SectionPolygon[]): SectionFace[] {
  const faces = polygons
    .filter((p) => p.length >= 3 && area2(p) > 0)
    .map((outer): SectionFace => ({ outer, holes: [] }));
  for (const hole of polygons)
    if (hole.length >= 3 && area2(hole) < 0) faces.find((f) => is_inside(hole[0]!, f.outer))?.holes.push(hole);
  return faces;
}

/// Returns hatching at 45°, `step` mm apart: the ends of each line, one after the other.
export function hatching(polygons: readonly SectionPolygon[], step: number): SectionPoint[] {
  const lines = new Map<number, number[]>(); // by number of the line z - x = number · step: places x of crossings
  for (const p of polygons)
    for (let i = 0; i < p.length; i++) {
      const a = p[i]!,
        b = p[(i + 1) % p.length]!,
        from = (a[1] - a[0]) / step,
        to = (b[1] - b[0]) / step;
      // each line is crossed by the half-open interval of the edge: a corner counts once
      for (let n = Math.floor(Math.min(from, to)) + 1; n <= Math.floor(Math.max(from, to)); n++) {
        const x = a[0] + ((b[0] - a[0]) * (n - from)) / (to - from);
        lines.set(n, [...(lines.get(n) ?? []), x]);
      }
    }
  const out: SectionPoint[] = [];
  for (const [n, places] of lines) {
    places.sort((x, y) => x - y);
    for (let i = 0; i + 1 < places.length; i += 2)
      if (places[i]! < places[i + 1]!) for (const x of [places[i]!, places[i + 1]!]) out.push([x, x + n * step]);
  }
  return out;
}

/// Returns the ends of each edge of the polygons that is not on the axis, one after the other.
export function outline(polygons: readonly SectionPolygon[]): SectionPoint[] {
  const out: SectionPoint[] = [];
  for (const p of polygons)
    p.forEach((a, i) => {
      const b = p[(i + 1) % p.length]!;
      if (a[0] > 1e-6 || b[0] > 1e-6) out.push(a, b);
    });
  return out;
}

/// Returns the greatest extent of the polygons, mm.
export function size_of(polygons: readonly SectionPolygon[]): number {
  const all = polygons.flat();
  if (!all.length) return 0;
  const extent = (k: 0 | 1): number => Math.max(...all.map((p) => p[k])) - Math.min(...all.map((p) => p[k]));
  return Math.max(extent(0), extent(1));
}
