// The set-up of the mock session's program: what the tools are, and the sheet for the workshop.
import { box } from "./mock-problem.mjs";

export const setup_answers = (s) => ({
  proposals: () => ({
    stock: "box:-40,-30,-20,40,30,0",
    tools: [
      {
        number: 1,
        kind: "flat",
        diameter: 10,
        flute_length: 22,
        length: 50,
        holder: [
          [32, 0],
          [40, 12],
          [40, 45],
        ],
        name: "END MILL 10",
        from: "comment, line 4",
        known: true,
      },
      {
        number: 2,
        kind: "drill",
        diameter: 6.8,
        angle: 118,
        flute_length: 60,
        length: 80,
        name: "DRILL 6.8",
        from: "comment, line 15",
        known: false,
      },
    ],
  }),
  sheet: () => ({
    program: s.open,
    control: "Mach3",
    machine: null,
    date: "2026-11-25",
    zeros: [{ name: "G54", values: { X: 300, Y: 200, Z: -250 } }],
    tools: [
      {
        number: 1,
        name: "END MILL 10",
        radius: 5,
        length: 82.5,
        corrector: "D1 H1",
        seconds: 26,
        lines: [4],
        outline: [],
        comment: "END MILL 10",
      },
      {
        number: 2,
        name: "DRILL 6.8",
        radius: 3.4,
        length: 120.25,
        corrector: "H2",
        seconds: 14,
        lines: [15],
        outline: [],
        comment: "DRILL 6.8",
      },
    ],
    extents: { cutting: box, all: box },
    seconds: 40,
    comments: [{ line: 2, text: "PLATE 80 X 60 </script><img src=x onerror=alert(1)>" }],
    stops: [{ line: 14, text: "TURN THE PART", at: 25 }],
  }),
});
