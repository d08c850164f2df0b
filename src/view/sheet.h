#pragma once
// Sheet: the set-up sheet of a program, to be printed: zeros, tools, extents, time, the programmer's notes, stops
// (docs/panel-protocol.md).

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "config/tool_library.h"
#include "view/program_run.h"
#include "view/source_text.h"

namespace kadr {

struct Sheet {
  struct Zero {
    std::string name;   // "G54"
    AxisValues values;  // as the set-up states them; empty: it states none
  };
  struct Tool {
    std::uint32_t number = 0;
    std::string name;              // from the tools file
    std::optional<double> radius;  // mm, from the set-up, else from the tools file or the comment
    std::optional<double> length;  // mm, from the set-up
    std::string corrector;         // offsets used with it: "D1 H1"
    struct Shared {
      std::string word;                  // "H3"
      std::vector<std::uint32_t> tools;  // other tools with the same offset
    };
    std::vector<Shared> shared;         // for the offsets of this tool
    double seconds = 0;                 // at feed
    std::vector<std::uint32_t> lines;   // first lines of the program itself that call it
    std::vector<ProfilePoint> outline;  // empty: its shape is unknown
    std::string comment;                // that names the tool
  };
  struct Note {
    std::uint32_t line = 0;
    std::string text;
  };
  struct Stop {
    std::uint32_t line = 0;
    std::string text;
    double at = 0;
  };
  std::string program, control, machine;
  std::string date;  // today, "2026-11-25"
  std::vector<Zero> zeros;
  std::vector<Tool> tools;  // sorted by first use
  double seconds = 0;
  std::vector<Note> comments;  // at the beginning of the program
  std::vector<Stop> stops;
};

/// The sheet of a run that has ended.
///   program  its name, for display
///   library  shapes of tools; nullptr: unknown
///   law      the tools are those of the run's statistics
Sheet sheet_of(const ProgramRun& run, const SourceText& source, const std::string& program, Lang lang,
               const ToolLibrary* library = nullptr);

/// As the protocol defines it.
nlohmann::ordered_json sheet_json(const Sheet& sheet, const Statistics& statistics);

}  // namespace kadr
