// Pointer and wheel: the left button rotates about the point under it, right or Shift moves, the wheel zooms to the
// pointer; two fingers move and zoom.
import { Vector3 } from "three";
import type { Eye } from "./camera";

export interface ControlEvents {
  changed(): void;
  click(x: number, y: number): void;
  hover(x: number, y: number): void;
  leave(): void;
  pivot(x: number, y: number): Vector3 | null;
}

const still = 4; // pixels: a shorter movement is a click

export class Controls {
  private down = new Map<number, [number, number]>();
  private moved = 0;
  private moves = false;
  private pivot = new Vector3();

  constructor(
    private element: HTMLElement,
    private eye: Eye,
    private events: ControlEvents,
  ) {
    element.style.touchAction = "none";
    element.addEventListener("pointerdown", (e) => this.press(e));
    element.addEventListener("pointermove", (e) => this.move(e));
    element.addEventListener("pointerup", (e) => this.release(e));
    element.addEventListener("pointercancel", (e) => this.down.delete(e.pointerId));
    element.addEventListener("pointerleave", () => events.leave());
    element.addEventListener("contextmenu", (e) => e.preventDefault());
    element.addEventListener("wheel", (e) => this.wheel(e), { passive: false });
  }

  private place(e: MouseEvent): [number, number] {
    const box = this.element.getBoundingClientRect();
    return [e.clientX - box.left, e.clientY - box.top];
  }

  private press(e: PointerEvent): void {
    const at = this.place(e);
    this.element.setPointerCapture(e.pointerId);
    this.down.set(e.pointerId, at);
    this.moved = this.down.size > 1 ? still : 0;
    this.moves = e.button !== 0 || e.shiftKey;
    this.pivot.copy(this.events.pivot(...at) ?? this.eye.target);
    this.events.leave();
  }

  private move(e: PointerEvent): void {
    const at = this.place(e),
      before = this.down.get(e.pointerId);
    if (!before) return this.events.hover(...at);
    const dx = at[0] - before[0],
      dy = at[1] - before[1];
    this.moved += Math.hypot(dx, dy);
    if (this.moved < still && this.down.size === 1) return;
    if (this.down.size > 1) this.pinch(e.pointerId, before, at);
    else if (this.moves) this.eye.shift(dx, dy);
    else this.eye.turn(dx, dy, this.pivot);
    this.down.set(e.pointerId, at);
    this.events.changed();
  }

  private pinch(id: number, before: [number, number], at: [number, number]): void {
    const other = [...this.down].find(([i]) => i !== id)?.[1];
    if (!other) return;
    const gap = (p: [number, number]): number => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
    this.eye.shift((at[0] - before[0]) / 2, (at[1] - before[1]) / 2);
    this.eye.zoom(gap(before) / gap(at), (at[0] + other[0]) / 2, (at[1] + other[1]) / 2);
  }

  private release(e: PointerEvent): void {
    if (!this.down.delete(e.pointerId) || this.moved >= still || e.button !== 0) return;
    this.events.click(...this.place(e));
  }

  private wheel(e: WheelEvent): void {
    e.preventDefault();
    const lines = e.deltaMode === WheelEvent.DOM_DELTA_LINE ? 33 : 1; // a line of the wheel is some 33 pixels
    this.eye.zoom(Math.exp(Math.max(-300, Math.min(300, e.deltaY * lines)) * 0.0015), ...this.place(e));
    this.events.changed();
  }
}
