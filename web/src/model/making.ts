// Programs from drawings: the one that is requested now.
import type { Socket } from "../protocol/client";
import type { Milled } from "../protocol/types";
import { LongQuestion } from "./long_question";

export class Making extends LongQuestion<"mill"> {
  constructor(make: () => Socket) {
    super(make, "mill");
  }

  /// The program that is requested now, verified; null if there is none.
  get program(): Milled | null {
    return !this.busy && !this.refusal && this.answer && "text" in this.answer ? this.answer : null;
  }
}
