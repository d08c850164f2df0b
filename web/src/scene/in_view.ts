// What of the path is in view, and how much of the screen it takes.
import { Box3, Frustum, Matrix4, Vector3 } from "three";
import type { Eye } from "./camera";

export class InView {
  private frustum = new Frustum();
  private projection = new Matrix4();
  private screen = new Box3();
  private corner = new Vector3();

  /// `place`: of the coordinates in which boxes are asked for.
  look(eye: Eye, place: Matrix4): void {
    const { projectionMatrix, matrixWorldInverse } = eye.camera;
    this.projection.multiplyMatrices(projectionMatrix, matrixWorldInverse).multiply(place);
    this.frustum.setFromProjectionMatrix(this.projection);
  }

  sees(box: Box3): boolean {
    return this.frustum.intersectsBox(box);
  }

  /// Returns which part of a box is on the screen, 0 to 1.
  part_of(box: Box3): number {
    const { screen, corner } = this;
    screen.makeEmpty();
    for (let i = 0; i < 8; i++)
      screen.expandByPoint(
        corner
          .set(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z)
          .applyMatrix4(this.projection),
      );
    const along = (least: number, most: number): number =>
      most - least > 1e-6 ? Math.max(0, Math.min(1, most) - Math.max(-1, least)) / (most - least) : 1;
    return along(screen.min.x, screen.max.x) * along(screen.min.y, screen.max.y);
  }
}
