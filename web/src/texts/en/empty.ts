// English texts: what to do where there is nothing yet.
export const empty_en = {
  panel_off:
    "The machine of this program is off. Switch it on: a virtual machine then runs the program in true time, and can be held, jogged and zeroed.",
  panel_no_program: "No program is open. Open one in the list of files, then switch its machine on here.",
  machine_none:
    "The program runs without a machine file: with usual speeds, and without limits of travel. Choose a machine at the top.",
  tools_none:
    "No tool of the program is known. Add one here, or state its size in the comment of its block, such as T1 M6 (END MILL D10).",
  tools_not_called: "The program calls no tool. The T word and tool change of the control, such as T1 M6, call one.",
  stock_none:
    "No blank is known. Enter one, such as box:0,0,-20,100,60,0, or state it in a comment, such as (PLATE 120X80X25).",
  table_none: "Nothing is stated here yet. Enter the name of a row, such as {row}, and press Add.",
};
