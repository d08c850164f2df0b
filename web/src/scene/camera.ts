// The viewpoint: a target, two angles, half the height of the picture in mm. Z is up; on a lathe X is up and Z to the right.
import { Box3, Matrix4, OrthographicCamera, PerspectiveCamera, Quaternion, Vector3 } from "three";
import type { Point } from "./types";

const fov = 30,
  quarter = Math.PI / 2,
  iso_pitch = Math.atan(1 / Math.SQRT2);
const directions: Record<string, [number, number]> = {
  front: [0, 0],
  right: [quarter, 0],
  back: [2 * quarter, 0],
  left: [-quarter, 0],
  top: [0, quarter],
  bottom: [0, -quarter],
  iso: [quarter / 2, iso_pitch],
};

/// The rotation of the views of a mill to those of a lathe: the front view has Z to the right and X up, as lathes show their part.
const lathe_views = new Quaternion().setFromRotationMatrix(
  new Matrix4().makeBasis(new Vector3(0, 0, 1), new Vector3(0, -1, 0), new Vector3(1, 0, 0)),
);

/// Target, angles and box are in machine coordinates; the camera is in the part's frame, in which everything is drawn.
export class Eye {
  readonly target = new Vector3();
  readonly carry = new Matrix4(); // from the part's frame to the machine's (carry.ts)
  readonly carry_back = new Matrix4();
  half = 100;
  flat = true;
  readonly turned = new Quaternion(); // from the axes of a mill's views to the machine's axes
  private yaw = quarter / 2;
  private pitch = iso_pitch;
  private width = 1;
  private height = 1;
  private least = new Vector3(-50, -50, -50);
  private greatest = new Vector3(50, 50, 50);
  private parallel = new OrthographicCamera();
  private pointed = new PerspectiveCamera(fov);

  get camera(): OrthographicCamera | PerspectiveCamera {
    return this.flat ? this.parallel : this.pointed;
  }
  get mm_per_pixel(): number {
    return (2 * this.half) / this.height;
  }
  get right(): Vector3 {
    return new Vector3(Math.cos(this.yaw), Math.sin(this.yaw), 0).applyQuaternion(this.turned);
  }
  get towards(): Vector3 {
    return new Vector3(
      Math.cos(this.pitch) * Math.sin(this.yaw),
      -Math.cos(this.pitch) * Math.cos(this.yaw),
      Math.sin(this.pitch),
    ).applyQuaternion(this.turned);
  }
  get up(): Vector3 {
    return this.towards.cross(this.right);
  }

  /// Shows the views as a lathe does, or as a mill does.
  set_lathe(on: boolean): void {
    this.turned.copy(on ? lathe_views : new Quaternion());
  }
  set_carry(carry: Matrix4): void {
    this.carry_back.copy(this.carry.copy(carry)).invert();
  }
  size(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
  }
  /// A box in the part's frame, like all other boxes passed in, and one in the machine's.
  around(least: Point, greatest: Point, also: Box3): void {
    const b = this.on_machine(least, greatest).union(also);
    this.least.copy(b.min);
    this.greatest.copy(b.max);
  }
  private on_machine(least: Point, greatest: Point): Box3 {
    return new Box3(new Vector3(...least), new Vector3(...greatest)).applyMatrix4(this.carry);
  }
  look(view: string): void {
    [this.yaw, this.pitch] = directions[view] ?? [this.yaw, this.pitch];
  }
  /// Looks from the side that `towards` points to.
  look_from(side: Point): void {
    const [x, y, z] = new Vector3(...side).applyQuaternion(this.turned.clone().invert()).toArray();
    if (Math.hypot(x, y) > 1e-9) this.yaw = Math.atan2(x, -y);
    this.pitch = Math.atan2(z, Math.hypot(x, y));
  }

  /// Rotates by pixels about `pivot`, which keeps its position on the screen.
  turn(dx: number, dy: number, pivot: Vector3): void {
    const offset = this.target.clone().sub(pivot);
    const [r, u, t] = [offset.dot(this.right), offset.dot(this.up), offset.dot(this.towards)];
    this.yaw -= dx * 0.008; // radians per pixel: half a revolution over some 400 pixels
    this.pitch = Math.min(quarter, Math.max(-quarter, this.pitch + dy * 0.008));
    this.target.copy(pivot).addScaledVector(this.right, r).addScaledVector(this.up, u).addScaledVector(this.towards, t);
  }

  shift(dx: number, dy: number): void {
    this.target.addScaledVector(this.right, -dx * this.mm_per_pixel).addScaledVector(this.up, dy * this.mm_per_pixel);
  }

  /// Zooms by `factor` about the position x, y of the screen, which keeps its content.
  zoom(factor: number, x: number, y: number): void {
    const before = this.mm_per_pixel;
    this.half = Math.min(1e6, Math.max(0.005, this.half * factor));
    const by = before - this.mm_per_pixel;
    this.target
      .addScaledVector(this.right, (x - this.width / 2) * by)
      .addScaledVector(this.up, (this.height / 2 - y) * by);
  }

  /// Fits the box into the picture, with a margin for the tool bars.
  fit(least: Point, greatest: Point): void {
    const { min: a, max: b } = this.on_machine(least, greatest),
      size = b.clone().sub(a);
    const spread = (axis: Vector3): number =>
      (Math.abs(axis.x * size.x) + Math.abs(axis.y * size.y) + Math.abs(axis.z * size.z)) / 2;
    this.target.copy(a).add(b).multiplyScalar(0.5);
    this.half = Math.max(0.5, 1.25 * Math.max(spread(this.up), (spread(this.right) * this.height) / this.width));
  }

  /// Returns the camera for the current view; near and far enclose everything.
  update(): void {
    const centre = this.least.clone().add(this.greatest).multiplyScalar(0.5);
    const reach = 1.2 * this.least.distanceTo(this.greatest) + this.target.distanceTo(centre) + 2 * this.half,
      c = this.camera;
    const away = this.flat ? reach : this.half / Math.tan((fov / 2) * (Math.PI / 180));
    c.position.copy(this.target).addScaledVector(this.towards, away);
    c.up.copy(this.up);
    c.matrixAutoUpdate = true; // lookAt() uses the camera's position in its matrix
    c.lookAt(this.target);
    c.near = this.flat ? 0 : Math.max(away / 200, away - reach);
    c.far = away + reach;
    const aspect = this.width / this.height;
    if (c instanceof OrthographicCamera) {
      c.left = -this.half * aspect;
      c.right = this.half * aspect;
      c.top = this.half;
      c.bottom = -this.half;
    } else c.aspect = aspect;
    c.updateProjectionMatrix();
    c.matrixAutoUpdate = false;
    c.updateMatrix();
    c.matrix.premultiply(this.carry_back);
    c.updateMatrixWorld(true);
  }
}
