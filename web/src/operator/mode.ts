// Goes into the operator's screen and out of it. The choice is kept for this device; `?operator` in the address goes in.
import { remember, remembered } from "../model/memory";
import { Signal } from "../model/signal";

const wanted_by = (search: string): boolean => new URLSearchParams(search).has("operator");

export class OperatorMode {
  on: boolean;
  readonly on_change = new Signal<boolean>();

  constructor(search: string) {
    this.on = wanted_by(search) || remembered("operator_screen", false);
    if (this.on) remember("operator_screen", true);
  }

  set(on: boolean): void {
    if (on === this.on) return;
    this.on = on;
    remember("operator_screen", on);
    this.on_change.emit(on);
  }
}
