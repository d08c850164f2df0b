// English texts: the structure of the program.
export const outline_en = {
  outline: "Structure",
  outline_more: "the first {count} entries",
};
