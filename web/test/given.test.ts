// Files that come with the page, inside it or in its address.
import { afterEach, expect, test } from "vitest";
import { given_files } from "../src/engine/given";

async function coded(value: unknown): Promise<string> {
  const packed = new Blob([JSON.stringify(value)]).stream().pipeThrough(new CompressionStream("deflate"));
  return btoa(String.fromCharCode(...new Uint8Array(await new Response(packed).arrayBuffer())));
}
const in_address = (text: string): string =>
  `#files=${text.replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "")}`;
const page = (inside: string | null): void => {
  const document = { getElementById: (id: string) => (id === "kadr-files" ? { textContent: inside } : null) };
  Object.assign(globalThis, { document });
};
const files = {
  open: { file: "part.nc", control: "fanuc" },
  files: { "part.nc": "G0 X\u00ff\n", "sub/tools.toml": "" },
};

afterEach(() => Reflect.deleteProperty(globalThis, "document"));

test("each character of a text is a byte", async () => {
  page(null);
  const given = await given_files(in_address(await coded(files)));
  expect(given?.open).toEqual({ file: "part.nc", control: "fanuc" });
  expect(given?.kept).toBe(true);
  expect(given?.files.map(([path, bytes]) => [path, [...new Uint8Array(bytes)]])).toEqual([
    ["part.nc", [71, 48, 32, 88, 255, 10]],
    ["sub/tools.toml", []],
  ]);
});

test("the files of a report are inside it, and are not kept", async () => {
  page(await coded(files));
  expect(await given_files("#files=xyz")).toMatchObject({ open: { file: "part.nc" }, kept: false });
});

test("an address without files, or with what nobody can read, gives none", async () => {
  page(null);
  for (const address of ["", "#", "#other", "#files=", "#files=%%%", "#files=AAAA", in_address(await coded([1]))])
    expect(await given_files(address)).toBeNull();
});
