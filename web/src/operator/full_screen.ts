// The whole screen of the device for the operator's screen. Only where the browser leaves the key Esc to the page: else
// Esc would leave the full screen instead of holding the machine.
import { t } from "../texts/texts";
import { button } from "../ui/dom";
import { icon } from "../ui/icons";
import { set } from "../ui/update";

type Locked = Navigator & { keyboard?: { lock(keys: string[]): Promise<void>; unlock(): void } };
const keyboard = (): Locked["keyboard"] => (navigator as Locked).keyboard;

export class FullScreen {
  readonly element = button(icon("full"), () => void this.toggle(), { class: "icon" });

  constructor() {
    this.element.hidden = !document.fullscreenEnabled || !keyboard();
    document.addEventListener("fullscreenchange", () => {
      if (!document.fullscreenElement) keyboard()?.unlock();
      this.draw();
    });
  }

  draw(): void {
    set(this.element, "aria-pressed", String(Boolean(document.fullscreenElement)));
    for (const name of ["title", "aria-label"]) set(this.element, name, t("op_fullscreen"));
  }
  leave(): void {
    if (document.fullscreenElement) void document.exitFullscreen();
  }

  private async toggle(): Promise<void> {
    if (document.fullscreenElement) return this.leave();
    try {
      await document.documentElement.requestFullscreen();
      await keyboard()!.lock(["Escape"]);
    } catch {
      this.leave(); // without the lock Esc would not hold
    }
  }
}
