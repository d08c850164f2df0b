// Tests that a report's data becomes the frames of a session, and that its socket answers like a session.
import { describe, expect, it } from "vitest";
import { Client } from "../src/protocol/client";
import { WorstLines } from "../src/model/worst";
import { read_frame, type Frame, type PartFrame, type PathFrame, type RowsFrame } from "../src/protocol/frames";
import { read, unpack, type ReportData } from "../src/report/data";
import { ReportPath } from "../src/report/path";
import { ReportSocket } from "../src/report/socket";

class Bytes {
  list: number[] = [];
  u32(v: number): this {
    for (let i = 0; i < 4; i++) this.list.push((v >>> (8 * i)) & 255);
    return this;
  }
  f64(v: number): this {
    this.list.push(...new Uint8Array(new Float64Array([v]).buffer));
    return this;
  }
  ints(values: number[]): this {
    let last = 0;
    const folded = values.map((v) => {
      const d = (v - last) | 0;
      last = v;
      return ((d << 1) ^ (d >> 31)) >>> 0;
    });
    for (let b = 0; b < 4; b++) this.list.push(...folded.map((z) => (z >>> (8 * b)) & 255));
    return this;
  }
}

const told = {
  opened: { file: "a.nc", lines: 3 },
  problems: [{ id: "x", severity: "warning", text: "W", line: 2, at: 1 }],
  sheet: { program: "a.nc", tools: [] },
  findings: [],
  cut: { stock: 10, left: 8, removed: 2 },
  done: {
    seconds: 5,
    zero: [1, 2, 3],
    joints: [],
    axes: ["X", "Y", "Z"],
    marks: [],
    tools: [],
    extents: { cutting: null, all: null },
  },
};
const data = {
  version: "1",
  made: "2026-11-25",
  file: "a.nc",
  language: "en",
  quanta: { length: 0.001, time: 0.0001, feed: 0.1, direction: 1e-5, position: 1e-3 },
  thinned: 0,
  licences: "MIT",
  sources: [{ file: 0, name: "a.nc", text: "T1\nG1 X1\n(</script><img src=x onerror=alert(1)>)" }],
  en: told,
  ru: { ...told, problems: [{ id: "x", severity: "warning", text: "П", line: 2, at: 1 }] },
  part: { cell: 0.5, off: 0.01 },
} as unknown as ReportData;

/// Line 2 occurs twice; x to -2.5 and back; the tool is tilted in the last motion.
function sample(): Uint8Array {
  const path = new Bytes()
    .u32(4)
    .u32(0)
    .u32(0)
    .u32(5)
    .u32(0)
    .f64(0.5)
    .ints([1000, 11000, -1500, 2147483])
    .ints([2000, 2000, 2000, 2000])
    .ints([3000, 3000, 3000, -7])
    .ints([0, 10000, 20000, 45000])
    .ints([1, 2, 3, 2])
    .ints([1, 2, 3, 4])
    .ints([0, 6000, 6000, 6000])
    .ints([0, 6000, 3000, 6000])
    .ints([0, 1, 1, 2])
    .ints([0, 0, 0, 0])
    .ints([0, 2, 2, 2])
    .ints([15, 0, 0, 15])
    .ints([0, 0, 0, 60000])
    .ints([0, 0, 0, 0])
    .ints([100000, 100000, 100000, 80000])
    .ints([0, 0, 90000, -45500])
    .ints([0, 1000, 2000, 3000]);
  const part = new Bytes()
    .u32(3)
    .u32(1)
    .ints([0, 1000, 0])
    .ints([0, 0, 1000])
    .ints([0, 0, 0])
    .ints([0, 1, 2])
    .ints([65535, 1, 1])
    .ints([0, 2, 3]);
  const json = [...new TextEncoder().encode(JSON.stringify(data))];
  return new Uint8Array([
    ...new Bytes().u32(json.length).list,
    ...json,
    ...new Bytes().u32(1).u32(path.list.length).list,
    ...path.list,
    ...new Bytes().u32(3).u32(part.list.length).list,
    ...part.list,
  ]);
}
const report = () => read(sample().buffer as ArrayBuffer);

describe("the data of a report", () => {
  it("gives the frames that the scene reads", () => {
    const r = report();
    expect(r.path.length).toBe(3);
    const piece = read_frame(r.path[0]!) as PathFrame,
      leans = read_frame(r.path[1]!) as RowsFrame,
      positions = read_frame(r.path[2]!) as RowsFrame;
    expect([...piece.at].map((v) => +v.toFixed(3))).toEqual([1, 2, 3, 11, 2, 3, -1.5, 2, 3, 2147.483, 2, -0.007]);
    expect(piece.start).toBe(0.5);
    expect([...piece.times].map((v) => +v.toFixed(4))).toEqual([0, 1, 2, 4.5]);
    expect([...piece.tools]).toEqual([0, 0, 1, 0, 1, 0, 2, 0]);
    expect([leans.kind, leans.count, positions.kind, positions.count]).toEqual(["directions", 4, "positions", 4]);
    expect(leans.values[11]).toBeCloseTo(0.8, 5);
    expect([...positions.values].map((v) => +v.toFixed(3))).toEqual([0, 0, 0, 1, 90, 2, -45.5, 3]);
    expect(piece.kept[0]).toBe(4);
    expect(piece.kept[1]).toBe(2);
    expect(piece.greatest[0]).toBeCloseTo(2147.483, 3);
    const head = new DataView(r.path[0]!); // by the protocol's own offsets
    expect([0, 4, 8, 12, 48, 52].map((at) => head.getUint32(at, true))).toEqual([1, 0, 4, 0, 0, 1]);
    expect([
      head.getFloat32(96 + 12, true),
      head.getFloat32(96 + 12 * 4 + 4, true),
      head.getUint8(96 + 36 * 4 + 4),
    ]).toEqual([11, 1, 2]);
    const mesh = read_frame(r.part!) as PartFrame;
    expect([...mesh.triangles]).toEqual([0, 1, 2]);
    expect(mesh.made_by[0]).toBe(65535);
    expect([...mesh.lines]).toEqual([0, 2, 3]);
  });
  it("comes out of base64 of zlib", async () => {
    const packed = await new Response(
      new Blob([sample() as BlobPart]).stream().pipeThrough(new CompressionStream("deflate")),
    ).arrayBuffer();
    const text = btoa(String.fromCharCode(...new Uint8Array(packed)));
    expect((await unpack(`\n${text}\n`)).data.sources[0]!.text).toContain("</script>");
    await expect(unpack("AAAA")).rejects.toThrow();
  });
});

describe("the path of a report", () => {
  const path = new ReportPath(report().path);
  it("knows where the tool is", () => {
    expect(path.at(1)!.place[0]).toBeCloseTo(6, 3);
    expect(path.at(1)!.line).toBe(2);
    expect(path.at(99)!.line).toBe(2);
    expect(path.of_block(3)!.at).toBeCloseTo(2.5, 3);
    expect(path.of_block(99)!.number).toBe(4);
  });
  it("knows each pass of a line", () => {
    const { passes, count } = path.passes(2, 0, 1);
    expect(count).toBe(2);
    expect(passes).toHaveLength(1);
    expect(path.passes(2, 0, 10).passes[1]).toMatchObject({ number: 4 });
    expect(path.passes(77, 0, 10).count).toBe(0);
  });
});

describe("slow places", () => {
  it("are the lines that lose most", () => {
    const lines = new WorstLines();
    for (const f of report().path) lines.add(read_frame(f) as PathFrame | RowsFrame);
    const worst = lines.worst(5);
    expect(worst.map((w) => w.line)).toEqual([3]);
    expect(worst[0]!.lost).toBeCloseTo(0.5, 3);
    expect(worst[0]!.at).toBeCloseTo(1.5, 3);
  });
});

describe("the socket of a report", () => {
  it("answers as a session", async () => {
    const frames: Frame[] = [],
      events: string[] = [];
    const client: Client = new Client(
      () => new ReportSocket(report()),
      async (c) => {
        await c.ask("hello", { lang: "ru" });
      },
    );
    client.frame.on((f) => frames.push(f));
    client.event.on((e) => events.push(e.name === "alarm" ? `alarm ${e.body.problem.text}` : e.name));
    client.connect();
    await new Promise<void>((yes) =>
      client.line.on((l) => {
        if (l === "open") yes();
      }),
    );
    expect((await client.ask("open", { file: "other.nc" })).file).toBe("a.nc");
    await new Promise((r) => setTimeout(r, 5));
    expect(frames).toHaveLength(3);
    expect(events).toEqual(["alarm П", "done", "cut"]);
    expect((await client.ask("source", { from: 2, count: 9 })).lines[0]).toBe("G1 X1");
    const state = await client.ask("state", { at: 1 });
    expect(state.position.X).toBeCloseTo(5, 3);
    expect(state.text).toBe("G1 X1");
    await client.ask("part", { at: 1 });
    await client.ask("part", { at: 2 });
    expect(frames).toHaveLength(4);
    await expect(client.ask("check", { text: "" })).rejects.toThrow();
    await client.ask("language", { lang: "en" });
    expect((await client.ask("open", { file: "a.nc" })).file).toBe("a.nc");
    await new Promise((r) => setTimeout(r, 5));
    expect(events).toContain("alarm W");
  });
});
