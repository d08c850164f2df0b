// A real machine: choosing its port, the proof before it is switched on, and what it says of itself when it is on.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import type { Axes } from "../protocol/types/base";
import type { Panel, Proof, ProofRow } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { button, fill, h, option } from "./dom";

const verdicts = { equal: "real_equal", note: "real_note", refused: "real_refused" } as const;

const place_text = (axes: Axes): string =>
  Object.entries(axes)
    .map(([name, value]) => `${name}${Math.round((value ?? 0) * 1000) / 1000}`)
    .join(" ");

/// What a real machine says of itself, with the keys to home or unlock it.
export function real_told(p: Panel, operator: Operator): (HTMLElement | false)[] {
  const { real } = p;
  if (!real) return [];
  const stands = ["standing", "ended"].includes(p.mode) && p.holds;
  return [
    h("p", { class: "note real-state" }, t("real_state", { controller: real.controller, state: real.state })),
    real.lost && h("p", { class: "told alarm" }, t("real_lost")),
    real.locked && h("p", { class: "told alarm" }, t("real_locked")),
    h(
      "div",
      { class: "row" },
      button(t("real_home"), () => operator.press("home"), { disabled: !stands || real.lost }),
      button(t("real_unlock"), () => operator.press("unlock"), { disabled: !stands || !real.locked }),
    ),
  ];
}

export class RealMachinePanel {
  readonly element = h("details", { class: "real-machine", hidden: true });
  private ports: string[] = [];
  private port = "";
  private file = "";
  private proof: Proof | null = null;
  private accepted = new Set<string>();
  private works = false;

  constructor(
    private app: App,
    private operator: Operator,
  ) {
    app.on_opened.on(() => this.forget());
    on_language(() => this.draw());
  }

  /// The panel is off: offers the ports of the server.
  show(): void {
    const file = this.app.opened?.file ?? "";
    if (file !== this.file) this.forget();
    this.file = file;
    void this.app.client
      .ask("ports", {})
      .then(({ ports }) => {
        this.ports = ports;
        this.draw();
      })
      .catch(() => undefined); // no connection: the page says so elsewhere
    this.draw();
  }

  private forget(): void {
    this.proof = null;
    this.accepted.clear();
    this.draw();
  }

  private question(): { file: string; port: string } {
    return { file: this.file, ...this.app.choice, port: this.port };
  }

  private async compare(): Promise<void> {
    this.works = true;
    this.forget();
    this.draw();
    try {
      this.proof = await this.app.client.ask("prove", this.question());
    } catch (e) {
      this.operator.on_error.emit(e instanceof Error ? e.message : String(e));
    }
    this.works = false;
    this.draw();
  }

  private row(row: ProofRow): HTMLElement[] {
    const accept = h("input", {
      type: "checkbox",
      checked: this.accepted.has(row.id),
      "aria-label": `${t("real_accept")}: ${row.what}`,
      onchange: () => {
        if (accept.checked) this.accepted.add(row.id);
        else this.accepted.delete(row.id);
        this.draw();
      },
    });
    const may = row.verdict === "refused" && row.id !== "program";
    return [
      h(
        "tr",
        { class: row.verdict },
        h("td", null, row.what),
        h("td", null, row.controller),
        h("td", null, row.program),
        h("td", null, t(verdicts[row.verdict]), may && h("label", null, " ", accept, t("real_accept"))),
      ),
      ...(row.why ? [h("tr", { class: `why ${row.verdict}` }, h("td", { colspan: "4" }, row.why))] : []),
    ];
  }

  private shown_proof(proof: Proof): HTMLElement[] {
    const { lines, stops, first } = proof,
      open = proof.rows.some((r) => r.verdict === "refused" && (r.id === "program" || !this.accepted.has(r.id)));
    const heads = (["real_what", "real_controller", "real_program"] as const).map((id) => h("th", null, t(id)));
    return [
      h("table", { class: "proof" }, h("tr", null, ...heads, h("th")), ...proof.rows.flatMap((row) => this.row(row))),
      h("p", null, t("real_total", { lines, stops, seconds: Math.round(proof.seconds) })),
      ...(first
        ? [h("p", null, t("real_first", { line: first.line, text: first.text, to: place_text(first.to) }))]
        : []),
      h("p", { class: "told" }, t("real_safety")),
      button(t("real_on"), () => void this.operator.switch_on({ ...this.question(), accept: [...this.accepted] }), {
        class: "main",
        disabled: open,
      }),
    ];
  }

  private draw(): void {
    this.element.hidden = this.ports.length === 0 || !this.file;
    if (this.element.hidden) return;
    const ports = h(
      "select",
      {
        "aria-label": t("real_port"),
        onchange: () => {
          this.port = ports.value;
          this.forget();
        },
      },
      option("", t("real_choose"), this.port === ""),
      ...this.ports.map((port) => option(port, port.replace("/dev/serial/by-id/", ""), port === this.port)),
    );
    const choice = h(
      "div",
      { class: "row" },
      ports,
      button(t("real_compare"), () => void this.compare(), { disabled: !this.port || this.works }),
    );
    fill(
      this.element,
      h("summary", null, t("real_machine")),
      choice,
      ...(this.works ? [h("p", { class: "note" }, t("real_comparing"))] : []),
      ...(this.proof ? this.shown_proof(this.proof) : []),
    );
  }
}
