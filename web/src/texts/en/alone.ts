// English texts: the page without a server.
export const alone_en = {
  alone_kept: "Nothing leaves this computer: your files stay in this browser until you delete them.",
  alone_not_kept: "Nothing leaves this computer. This browser keeps no files: they are gone when the page closes.",
  alone_upload_long:
    "Open files of this computer: programs, set-ups, tools, drawings. You can also drop files and folders on the page.",
  alone_drop_here:
    "Drop programs, set-ups, tools or folders here. They stay in this browser; a single program is opened.",
  alone_start: "Open a program of this computer, drop one on the page, or take an example.",
  alone_open: "Open…",
  alone_panel:
    "The machine to operate needs the program: its clock runs in real time, and a page without a server has none. `kadr serve` has it.",
  alone_download: "Save on this computer",
  alone_memory: "The memory of this browser is not sufficient for that.",
  alone_broken: "The engine of the page has failed, and was started anew.",
  alone_stopped: "The run was stopped.",
  alone_lost: "Stopped. The engine starts anew; your files are kept…",
  alone_starts: "Kadr starts…",
  alone_failed:
    "Kadr cannot run here: {why}. It needs a browser since 2023: Chrome or Edge 95, Firefox 100, Safari 16.4, or newer.",
};
