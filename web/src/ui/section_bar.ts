// The section through the part: which plane, where, which side; a turned part in half section.
import type { App } from "../model/app";
import type { Scene } from "../scene/scene";
import { t } from "../texts/texts";
import { button, fill, h, option } from "./dom";
import { length_told } from "./figures";
import { icon } from "./icons";

export class SectionBar {
  readonly element = h("div", { class: "scene-bar below" });
  private is_lathe = false;
  private section: { axis: 0 | 1 | 2 | "half" | null; part: number; flip: boolean } = {
    axis: null,
    part: 0.5,
    flip: false,
  };

  /// `more`: what follows in the bar.
  constructor(
    private app: App,
    private scene: () => Scene | null,
    private more: () => HTMLElement[],
  ) {}

  draw(): void {
    const { section } = this,
      box = this.app.done?.extents.all,
      is_plane = section.axis !== null && section.axis !== "half";
    const change = (): void => this.cut_through();
    const axis = h(
      "select",
      {
        "aria-label": t("section"),
        title: t("section"),
        onchange: () => {
          section.axis = axis.value === "" ? null : axis.value === "half" ? "half" : (Number(axis.value) as 0 | 1 | 2);
          change();
          this.draw();
        },
      },
      option("", t("section_none"), section.axis === null),
      ...(this.is_lathe ? [option("half", t("section_half"), section.axis === "half")] : []),
      ...[0, 1, 2].map((i) => option(String(i), `${t("section")} ${"XYZ"[i]}`, section.axis === i)),
    );
    const at = h("input", {
      type: "range",
      min: "0",
      max: "1",
      step: "0.002",
      value: String(section.part),
      "aria-label": t("section_at"),
      oninput: () => {
        section.part = Number(at.value);
        change();
      },
    });
    fill(
      this.element,
      axis,
      is_plane && box && at,
      is_plane &&
        button(
          icon("flip"),
          () => {
            section.flip = !section.flip;
            change();
          },
          { class: "icon", title: t("section_flip"), "aria-label": t("section_flip") },
        ),
      is_plane && h("span", { class: "section-told" }),
      ...this.more(),
    );
    change();
  }

  /// A lathe's part is shown in half section, until the user chooses otherwise.
  show_lathe(on: boolean): void {
    this.scene()?.setLathe(on);
    if (on === this.is_lathe) return;
    this.is_lathe = on;
    this.section.axis = on ? "half" : null;
    this.draw();
  }

  private cut_through(): void {
    const { axis, part, flip } = this.section,
      box = this.app.done?.extents.all;
    if (axis === "half") return this.scene()?.setHalf();
    if (axis === null || !box) return this.scene()?.setSection(null, 0, false);
    const margin = 5,
      low = box[0][axis]! - margin,
      high = box[1][axis]! + margin; // mm: the blank is slightly larger than the path
    const at = low + part * (high - low);
    this.scene()?.setSection(axis, at, flip);
    const told = this.element.querySelector(".section-told");
    if (told) told.textContent = `${"XYZ"[axis]} ${length_told(at)}`;
  }
}
