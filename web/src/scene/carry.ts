// The part as it is on the machine, rotated by the rotary axes. The path stays fixed in the part's own frame; the eye,
// and what belongs to the machine, rotate about it in the opposite direction.
import { Matrix4, Vector3 } from "three";
import type { Joint } from "../protocol/types";
import type { Point } from "./types";

/// Returns the transformation from the part as it is drawn to its position when the joints are at `positions`; both
/// relative to the picture's zero.
export function carry_of(joints: readonly Joint[], positions: readonly number[], zero: Point): Matrix4 {
  const from = chain(
    joints,
    joints.map((j) => j.from),
  ).invert();
  return new Matrix4()
    .makeTranslation(-zero[0], -zero[1], -zero[2])
    .multiply(chain(joints, positions))
    .multiply(from)
    .multiply(new Matrix4().makeTranslation(...zero));
}

function chain(joints: readonly Joint[], positions: readonly number[]): Matrix4 {
  const all = new Matrix4();
  joints.forEach((j, i) => {
    const d = new Vector3(...j.direction),
      at = positions[i] ?? j.from;
    if (!j.turns) return all.multiply(new Matrix4().makeTranslation(d.multiplyScalar(at)));
    const p = new Vector3(...j.through);
    all
      .multiply(new Matrix4().makeTranslation(p))
      .multiply(new Matrix4().makeRotationAxis(d, (at * Math.PI) / 180))
      .multiply(new Matrix4().makeTranslation(p.negate()));
  });
  return all;
}
