// The program of the mock session, its path and its part, as the frames of the protocol.
export const program = [
  "%",
  "(PLATE 80 X 60, ZERO IN THE MIDDLE </script><img src=x onerror=alert(1)>)",
  "N10 G21 G17 G90 G40 G49 G80",
  "N20 T1 M6 (END MILL 10)",
  "N30 S3500 M3",
  "N40 G0 X0 Y0 Z50 M8",
  "#1=5 ; depth",
  "WHILE [#1 GT 0] DO1",
  "N60 G1 Z-[6-#1] F400",
  "N70 G3 X0 Y0 I8 J0 F700",
  "#1=#1-1",
  "END1",
  "N100 G0 Z50",
  "M0 (TURN THE PART)",
  "N110 T2 M6 (DRILL 6.8)",
  "N120 G98 G83 X20 Y20 Z-15 R2 Q3 F120",
  "N130 X-20 Y20",
  "N140 X-20 Y-20",
  "N150 G80 G0 Z100",
  "M30",
  "%",
].join("\n");

// [line, tool, kind, feed, x, y, z, seconds]: enough motions for slider, strip and passes
function motions() {
  const out = [[6, 1, 1, 0, 0, 0, 50, 0.6]];
  for (let pass = 1; pass <= 5; pass++) {
    out.push([9, 1, 2, 400, 0, 0, -pass, pass === 1 ? 7 : 0.6]);
    for (let i = 1; i <= 48; i++) {
      const a = Math.PI + (2 * Math.PI * i) / 48;
      out.push([10, 1, 4, 700, 8 + 8 * Math.cos(a), 8 * Math.sin(a), -pass, 0.09 + (i < 4 ? 0.05 : 0)]);
    }
  }
  out.push([13, 1, 1, 0, 0, 0, 50, 0.5]);
  for (const [line, x, y] of [
    [16, 20, 20],
    [17, -20, 20],
    [18, -20, -20],
  ]) {
    out.push([line, 2, 1, 0, x, y, 2, 0.8]);
    for (const z of [-1, -4, -7, -10, -13, -15])
      out.push([line, 2, 2, 120, x, y, z, 1.5], [line, 2, 1, 0, x, y, 2, 0.2]);
  }
  out.push([19, 2, 1, 0, -20, -20, 100, 0.9]);
  return out;
}

export function path_frame(shift = 0, which = 0) {
  const all = [[6, 1, 0, 0, 0, 0, 100, 0], ...motions()],
    n = all.length;
  const frame = new ArrayBuffer(96 + n * 40),
    view = new DataView(frame);
  [1, which, n, 0].forEach((v, i) => view.setUint32(4 * i, v, true));
  const least = [0, 1, 2].map((i) => Math.min(...all.map((m) => m[4 + i]))),
    greatest = [0, 1, 2].map((i) => Math.max(...all.map((m) => m[4 + i])));
  [...least, ...greatest].forEach((v, i) => view.setFloat32(24 + 4 * i, v, true));
  view.setUint32(52, 6, true);
  for (let i = 0; i < 16; i++) view.setUint16(56 + 2 * i, n, true);
  let time = 0,
    number = 5,
    line = 0;
  const before = [0, 0, 100];
  all.forEach(([l, tool, kind, feed, x, y, z, seconds], i) => {
    time += seconds;
    if (l !== line || kind !== 4) number++;
    line = l;
    const way = Math.hypot(x - before[0], y - before[1], z - before[2]);
    [x, y, z].forEach((v, k) => {
      before[k] = v;
      view.setFloat32(96 + 12 * i + 4 * k, v + shift, true);
    });
    const at = 96 + 12 * n + 4 * i;
    view.setFloat32(at, time, true);
    view.setUint32(at + 4 * n, l, true);
    view.setUint32(at + 8 * n, number, true);
    view.setFloat32(at + 12 * n, feed, true);
    view.setFloat32(at + 16 * n, seconds > 0 ? (way / seconds) * 60 : 0, true);
    view.setUint16(at + 20 * n, tool, true);
    view.setUint8(at + 24 * n, kind);
    view.setUint8(at + 24 * n + 1, 15);
  });
  return { frame, seconds: time, blocks: number, all };
}

export function part_frame() {
  const p = [
    [-40, -30, -20],
    [40, -30, -20],
    [40, 30, -20],
    [-40, 30, -20],
    [-40, -30, 0],
    [40, -30, 0],
    [40, 30, 0],
    [-40, 30, 0],
  ];
  const t = [
    [0, 2, 1],
    [0, 3, 2],
    [4, 5, 6],
    [4, 6, 7],
    [0, 1, 5],
    [0, 5, 4],
    [1, 2, 6],
    [1, 6, 5],
    [2, 3, 7],
    [2, 7, 6],
    [3, 0, 4],
    [3, 4, 7],
  ];
  const frame = new ArrayBuffer(16 + 96 + 144 + 64),
    view = new DataView(frame);
  [3, 0, 8, 12].forEach((v, i) => view.setUint32(4 * i, v, true));
  p.flat().forEach((v, i) => view.setFloat32(16 + 4 * i, v, true));
  t.flat().forEach((v, i) => view.setUint32(112 + 4 * i, v, true));
  for (let i = 0; i < 8; i++) view.setUint16(256 + 4 * i, 65535, true);
  return frame;
}
