// A path of any number of segments as frames of the protocol: a surface milled line by line, 256 motions per line,
// with heights that every level of detail simplifies differently.
const most = 8192,
  row = 256,
  step = 0.25,
  levels = 16;

/// Returns the frame of piece `index` of a path of `segments` motions.
export function long_frame(index, segments) {
  const first = index * (most - 1),
    n = Math.min(most, segments + 1 - first),
    rows = Math.ceil(segments / row);
  const frame = new ArrayBuffer(96 + 40 * n),
    head = new DataView(frame);
  const at = new Float32Array(frame, 96, 3 * n),
    column = (type, i, each = 1) => new type(frame, 96 + 12 * n + 4 * n * i, each * n);
  const times = column(Float32Array, 0),
    lines = column(Uint32Array, 1),
    numbers = column(Uint32Array, 2),
    feeds = column(Float32Array, 3),
    speeds = column(Float32Array, 4);
  const tools = column(Uint16Array, 5, 2),
    kinds = column(Uint8Array, 6, 4),
    kept = new Uint16Array(frame, 56, levels);
  const least = [Infinity, Infinity, Infinity],
    greatest = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < n; i++) {
    const v = first + i,
      y = Math.floor(v / row),
      along = v % row,
      x = y % 2 ? row - 1 - along : along;
    const px = (x - row / 2) * step,
      py = (y / rows - 0.5) * row * step,
      place = [px, py, -5 + 4 * Math.cos(px / 9) * Math.sin(py / 7) + 0.02 * Math.sin(v * 1.7)];
    for (let k = 0; k < 3; k++) {
      at[3 * i + k] = place[k];
      least[k] = Math.min(least[k], place[k]);
      greatest[k] = Math.max(greatest[k], place[k]);
    }
    times[i] = i * 0.01;
    lines[i] = numbers[i] = v + 3;
    feeds[i] = 1500;
    speeds[i] = 900 + 500 * Math.sin(v / 300);
    tools[2 * i] = 1;
    kinds[4 * i] = v === 0 ? 0 : 2;
    const level = i === 0 || i === n - 1 || along === 0 ? levels - 1 : Math.min(levels - 2, 2 * trailing_zeros(along));
    kinds[4 * i + 1] = level;
    for (let l = 0; l <= level; l++) kept[l]++;
  }
  [1, 0, n, 0].forEach((x, i) => head.setUint32(4 * i, x, true));
  head.setFloat64(16, first * 0.01, true);
  [...least, ...greatest].forEach((x, i) => head.setFloat32(24 + 4 * i, x, true));
  head.setUint32(48, first, true);
  head.setUint32(52, first + 3, true);
  return { frame, least, greatest };
}
export const pieces_of = (segments) => Math.ceil(segments / (most - 1));
const trailing_zeros = (v) => 31 - Math.clz32(v & -v);

/// Creates a session whose only program is that path; `told(name)` is called for each question.
export const long_session = (segments) => (send, drained) => {
  const say = (m) => send(JSON.stringify(m));
  const extents = [
      [(-row / 2) * step, (-row / 2) * step, -9.1],
      [(row / 2) * step, (row / 2) * step, -0.9],
    ],
    seconds = segments * 0.01;
  async function run() {
    for (let i = 0; i < pieces_of(segments); i++) {
      send(long_frame(i, segments).frame);
      if (i % 20 === 0)
        say({ event: "progress", part: i / pieces_of(segments), blocks: i * most, seconds: i * most * 0.01 });
      await drained();
      await new Promise((r) => setImmediate(r));
    }
    say({
      event: "done",
      state: "ended",
      seconds,
      blocks: segments,
      vertices: segments + 1,
      zero: [0, 0, 0],
      extents: { cutting: extents, all: extents },
      distances: { cutting: 1, rapid: 0 },
      times: { cutting: seconds, rapid: 0, dwell: 0, tools: 0 },
      tools: [{ tool: 1, from: 0, seconds }],
      marks: [],
      axes: ["X", "Y", "Z"],
      units: "mm",
    });
  }
  const answers = {
    hello: () => ({
      version: "0",
      folder: "",
      may_change: false,
      last: "long.nc",
      controls: [{ id: "mach3", name: "Mach3" }],
      machines: [],
    }),
    files: () => ({ entries: [{ name: "long.nc", kind: "program", size: 1, modified: 0 }] }),
    open: () => {
      setTimeout(run, 0);
      return {
        file: "long.nc",
        size: 30 * segments,
        digest: "",
        encoding: "utf-8",
        control: { id: "mach3", name: "Mach3", guessed: false },
        machine: null,
        setup: null,
        editable: false,
        lines: segments + 3,
      };
    },
    source: (q) => ({
      lines: Array.from(
        { length: Math.max(0, Math.min(q.count, segments + 4 - q.from)) },
        (_, i) => `G1 X${(q.from + i) % 97}`,
      ),
    }),
    state: (q) => {
      const number = Math.min(segments, q.number ?? Math.round(q.at * 100));
      return {
        at: number / 100,
        number,
        line: number,
        position: {},
        machine: {},
        togo: {},
        feed: 1500,
        speed: 900,
        rpm: 0,
        tool: 1,
        modal: [],
        offsets: {},
        zero: {},
        variables: [],
        seconds: 0,
        left: 0,
      };
    },
    passes: (q) => ({ passes: [{ from: q.line / 100, to: q.line / 100, number: q.line }], count: 1 }),
  };
  return (text) => {
    const q = JSON.parse(text);
    say({ re: q.id, ...(answers[q.do]?.(q) ?? { error: { text: "not served" } }) });
  };
};
