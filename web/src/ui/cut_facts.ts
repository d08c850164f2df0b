// What a cut has removed and left, as figures.
import { diameter_sign } from "../model/diameters";
import type { CutResult, CutThread, PartAnswer } from "../protocol/types";
import { t } from "../texts/texts";
import { h } from "./dom";
import { length, length_told, short, volume_told } from "./figures";
import { fact } from "./summary";

/// `c`: the last cut; `part`: its part at the instant that is shown.
export function cut_facts(c: CutResult | null, part: PartAnswer | null): (HTMLElement | false | null | undefined)[] {
  return [
    c !== null &&
      !c.error &&
      h(
        "dl",
        { class: "facts" },
        ...fact(t("stock"), volume_told(c.stock)),
        ...fact(t("removed"), volume_told(c.removed)),
        ...fact(t("left"), volume_told(c.left)),
        ...(c.turned ? [] : fact(t("cell"), length_told(c.resolution))),
        ...(c.threads ?? []).flatMap((x) => fact(t("thread_of", { tool: x.tool }), thread_told(x))),
      ),
    part &&
      h(
        "p",
        { class: "note" },
        t(part.section ? "turned_told" : "part_told", {
          left: volume_told(part.left),
          triangles: short(part.triangles),
          cell: length_told(part.cell),
        }),
      ),
    ...(c?.notes ?? []).map((note) => h("p", { class: "note" }, note)),
  ];
}

/// "Ø 24.000 – Ø 21.546, lead 2.000 mm, 8 passes".
function thread_told(x: CutThread): string {
  const crest = x.crest ?? x.from.diameter;
  return t("thread_told", {
    crest: `${diameter_sign} ${length(crest)}`,
    root: `${diameter_sign} ${length(x.to.diameter)}`,
    lead: x.lead === undefined ? "–" : length_told(x.lead),
    passes: x.passes,
  });
}
