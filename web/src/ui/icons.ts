// Icons drawn as outlines on a square of 16: fonts of a workshop's screen may lack the characters.
import { svg } from "./dom";

const paths = {
  menu: "M2 4h12M2 8h12M2 12h12",
  dots: "!M2 6.5h3v3H2ZM6.5 6.5h3v3h-3ZM11 6.5h3v3h-3Z",
  close: "M4 4l8 8M12 4l-8 8",
  sun: "M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6ZM8 1v2M8 13v2M1 8h2M13 8h2M3 3l1.5 1.5M11.5 11.5 13 13M13 3l-1.5 1.5M4.5 11.5 3 13",
  moon: "M13 9.5A5.5 5.5 0 0 1 6.5 3 5.5 5.5 0 1 0 13 9.5Z",
  folder: "M2 4h4l1.5 2H14v7H2Z",
  program: "M4 2h6l3 3v9H4ZM6 7h5M6 9.5h5M6 12h3",
  setup: "M8 4a4 4 0 1 0 0 8 4 4 0 0 0 0-8ZM8 1v5M8 10v5M1 8h5M10 8h5",
  tools: "M6 2h4v5H6ZM6.8 7v5L8 14l1.2-2V7",
  cycle: "M12.5 6A5 5 0 1 0 13 8.5M13 3v3.3H9.7",
  label: "M4 14V2.5h8L9.5 5.5 12 8.5H4",
  section: "M3 4h10M3 8h7M3 12h9",
  other: "M4 2h6l3 3v9H4Z",
  play: "!M4 2.5v11l9-5.5Z",
  pause: "!M4 3h3v10H4ZM9 3h3v10H9Z",
  back: "!M10.5 3v10L4 8ZM12 3h1.4v10H12Z",
  on: "!M5.5 3v10L12 8ZM2.6 3H4v10H2.6Z",
  tool_back: "!M8.5 3v10L3.5 8ZM13.5 3v10L8.5 8ZM2 3h1.4v10H2Z",
  tool_on: "!M7.5 3v10l5-5ZM2.5 3v10l5-5ZM12.6 3H14v10h-1.4Z",
  go: "M3 8h9M8.5 4.5 12 8l-3.5 3.5",
  zoom_in: "M7 2.5a4.5 4.5 0 1 0 0 9 4.5 4.5 0 0 0 0-9ZM10.3 10.3 14 14M5 7h4M7 5v4",
  zoom_out: "M7 2.5a4.5 4.5 0 1 0 0 9 4.5 4.5 0 0 0 0-9ZM10.3 10.3 14 14M5 7h4",
  flip: "M3 5.5h9L9.5 3M13 10.5H4L6.5 13",
  full: "M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4",
  less: "M10 3 5 8l5 5",
  more: "M6 3l5 5-5 5",
  alarm: "!M5 1h6l4 4v6l-4 4H5l-4-4V5ZM7 4v5h2V4ZM7 10.5v2h2v-2Z",
  warning: "!M8 1.5 15.5 14.5H.5ZM7.2 6v4.5h1.6V6ZM7.2 11.7v1.6h1.6v-1.6Z",
  advice: "!M8 1a5 5 0 0 0-3 9v2h6v-2a5 5 0 0 0-3-9ZM5.5 13h5v1.2h-5Z",
  note: "!M8 1a7 7 0 1 0 0 14A7 7 0 0 0 8 1ZM7.2 4v1.7h1.6V4ZM7.2 7v5h1.6V7Z",
};
export type IconName = keyof typeof paths;

/// A path that begins with `!` is filled, any other is drawn as a line.
export function icon(name: IconName, label?: string): SVGSVGElement {
  const p = paths[name],
    filled = p.startsWith("!");
  return svg(
    "svg",
    {
      viewBox: "0 0 16 16",
      class: `icon-sign ${filled ? "filled" : "drawn"}`,
      ...(label ? { role: "img", "aria-label": label } : { "aria-hidden": "true" }),
    },
    svg("path", { d: filled ? p.slice(1) : p }),
  );
}
