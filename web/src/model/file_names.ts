// Names of files in the served folder, with `/` between folders.
export const folder_part = (file: string): string => file.slice(0, Math.max(0, file.lastIndexOf("/")));
export const name_part = (file: string): string => file.slice(file.lastIndexOf("/") + 1);

/// Returns a name like `name` that none of `names` has, in upper or lower case: part.nc, part_2.nc, part_3.nc.
export function free_name(name: string, names: ReadonlySet<string>): string {
  const taken = new Set([...names].map((n) => name_part(n).toLowerCase())),
    dot = name.lastIndexOf("."),
    [front, end] = dot > 0 ? [name.slice(0, dot), name.slice(dot)] : [name, ""],
    stem = front.replace(/_\d+$/, "");
  let found = name;
  for (let i = 2; taken.has(found.toLowerCase()); i++) found = `${stem}_${i}${end}`;
  return found;
}

/// The longest file that one message can carry: 16 MiB of base64 and its frame.
export const most_sent = 11 * 1024 * 1024;

export const base64 = (bytes: Uint8Array): string => {
  const step = 0x8000; // more arguments than this are too many for some browsers
  let text = "";
  for (let i = 0; i < bytes.length; i += step) text += String.fromCharCode(...bytes.subarray(i, i + step));
  return btoa(text);
};
