// A wheel as on a pendant: turned by scrolling over it or by dragging around it. One click is one step of the axis.
import { remember, remembered } from "../model/memory";
import { t } from "../texts/texts";
import { button, fill, h } from "../ui/dom";

const clicks_a_turn = 50,
  scroll_a_click = 50; // px

export class Wheel {
  private element = h("div", { class: "wheel-part" });
  private dial = h("div", { class: "wheel", role: "slider", tabindex: "0", "aria-valuenow": "0" });
  private hand = h("span", { class: "wheel-hand" });
  private axis = remembered<string>("op_wheel", "X");
  private clicks = 0;
  private rest = 0; // of a click
  private last = 0; // angle, degrees

  constructor(private turned: (axis: string, clicks: number) => void) {
    this.dial.append(this.hand);
    this.dial.addEventListener(
      "wheel",
      (e) => {
        e.preventDefault();
        this.turn(-e.deltaY / scroll_a_click);
      },
      { passive: false },
    );
    this.dial.addEventListener("pointerdown", (e) => {
      this.dial.setPointerCapture(e.pointerId);
      this.rest = 0;
      this.last = this.angle(e);
    });
    this.dial.addEventListener("pointermove", (e) => {
      if (!this.dial.hasPointerCapture(e.pointerId)) return;
      const now = this.angle(e),
        by = ((now - this.last + 540) % 360) - 180;
      this.last = now;
      this.turn((by * clicks_a_turn) / 360);
    });
    this.dial.addEventListener("lostpointercapture", () => {
      this.rest = 0; // a part of a click must not come with a later turn, perhaps of another axis
    });
    this.dial.addEventListener("keydown", (e) => {
      const by = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[e.key];
      if (!by) return;
      e.preventDefault();
      e.stopPropagation();
      this.turn(by);
    });
  }

  draw(axes: string[]): HTMLElement {
    if (!axes.includes(this.axis)) this.axis = axes[0] ?? "";
    const one = (axis: string): HTMLElement =>
      button(
        axis,
        () => {
          this.axis = axis;
          this.rest = 0;
          remember("op_wheel", axis);
          this.draw(axes);
        },
        { "aria-pressed": this.axis === axis, "aria-label": `${t("op_wheel")}: ${axis}` },
      );
    this.dial.setAttribute("aria-label", `${t("op_wheel")}: ${this.axis}`);
    this.dial.title = t("op_wheel_long");
    fill(this.element, this.dial, h("div", { class: "row" }, ...axes.map(one)));
    return this.element;
  }

  private angle(e: PointerEvent): number {
    const box = this.dial.getBoundingClientRect();
    return (180 / Math.PI) * Math.atan2(e.clientY - (box.top + box.height / 2), e.clientX - (box.left + box.width / 2));
  }

  private turn(by: number): void {
    this.rest += by;
    const whole = Math.trunc(this.rest);
    if (!whole) return;
    this.rest -= whole;
    this.clicks += whole;
    this.hand.style.transform = `rotate(${(360 * this.clicks) / clicks_a_turn}deg)`;
    this.dial.setAttribute("aria-valuenow", String(this.clicks));
    this.turned(this.axis, whole);
  }
}
