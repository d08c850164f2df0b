// What the mock session finds in its program: a problem, and the extents of its path.
export const problem = (line, more) => ({
  id: "feed_missing",
  severity: "alarm",
  number: 1070,
  text: "No feed for motion at feed",
  hint: "Give F in this block or before",
  file: "",
  line,
  column: 1,
  end_column: 8,
  block: "",
  calls: [],
  ...more,
});
export const box = [
  [-20, -20, -15],
  [20, 20, 0],
];
