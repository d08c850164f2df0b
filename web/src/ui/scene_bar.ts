// The tool bar of the 3D view: from where it looks, what the colours mean, perspective, and what is shown.
import type { App } from "../model/app";
import { remember, remembered } from "../model/memory";
import type { ColourBy, Scene, SceneFilter } from "../scene/scene";
import { t } from "../texts/texts";
import { button, fill, h, option } from "./dom";
import { filter_form } from "./filters";

const colours: ColourBy[] = ["kind", "tool", "feed", "speed", "slowed", "time", "depth"];
const views = ["top", "front", "left", "right", "back", "bottom", "iso", "fit"] as const;

export interface SceneBarVerbs {
  filter(): SceneFilter;
  set_filter(f: Partial<SceneFilter>): void;
  /// Colours stand for something else.
  coloured(): void;
}

export class SceneBar {
  readonly element = h("div", { class: "scene-bar", role: "toolbar" });
  colour = remembered<ColourBy>("colour", "kind");
  private flat = remembered("orthographic", true);

  constructor(
    private app: App,
    private scene: () => Scene | null,
    private verbs: SceneBarVerbs,
  ) {}

  /// Gives a new view what was chosen before.
  apply(): void {
    this.scene()?.setColour(this.colour);
    this.scene()?.setProjection(this.flat);
  }

  draw(): void {
    this.element.setAttribute("aria-label", t("view_3d"));
    fill(
      this.element,
      ...views.map((v) => button(t(`view_${v}`), () => this.scene()?.view(v), { title: t(`view_${v}_long`) })),
      this.colour_choice(),
      button(t(this.flat ? "orthographic" : "perspective"), () => this.change_projection(), {
        title: t("projection"),
      }),
      filter_form(this.app, this.verbs.filter(), (f) => this.verbs.set_filter(f)),
    );
  }

  private colour_choice(): HTMLElement {
    const look = h(
      "select",
      {
        "aria-label": t("colour_by"),
        title: t("colour_by"),
        onchange: () => {
          this.colour = look.value as ColourBy;
          remember("colour", this.colour);
          this.scene()?.setColour(this.colour);
          this.verbs.coloured();
        },
      },
      ...colours.map((c) => option(c, t(`colour_${c}`), c === this.colour)),
    );
    return look;
  }

  private change_projection(): void {
    this.flat = !this.flat;
    remember("orthographic", this.flat);
    this.scene()?.setProjection(this.flat);
    this.draw();
  }
}
