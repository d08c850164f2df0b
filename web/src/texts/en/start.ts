// English texts: the first minute.
export const start_en = {
  start_title: "Begin here",
  start_open: "Open a program in the list above, drop one on the page, or take an example.",
  start_examples: "Examples",
  start_copied: "An example is copied to the folder kadr-examples, with its set-up. Change it as you like.",
  nothing_yet: "The path of a program appears here.",
  tour: "Show me around",
  tour_at: "{n} of {m}",
  tour_next: "Next",
  tour_back: "Back",
  tour_leave: "Leave",
  tour_1: "Files and program",
  tour_1_long:
    "A click opens a program. Its text can be edited at once: faults are underlined while you type, and the path follows.",
  tour_2: "Path and part",
  tour_2_long:
    "Drag to turn, the wheel zooms, 1 to 6 are views, F shows everything. A click on a motion goes to its line.",
  tour_3: "Time",
  tour_3_long:
    "The slider is the machine's time: Space plays, the arrows step by blocks. Below it the speed; the wheel zooms.",
  tour_4: "State and problems",
  tour_4_long:
    "Above: position, codes and offsets at the slider. Below: problems, times, and the part that is cut of a blank.",
  tour_5: "A machine to operate",
  tour_5_long:
    "Here a virtual machine is switched on and runs the program as a control does: start, hold, jog, zero, restart.",
};
