#pragma once
// Sheet: what a setter needs of a program, to be printed: zeros, tools, extents, time, the programmer's notes, stops
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
    AxisValues values;  // as the set-up states them; empty: it does not
  };
  struct Tool {
    std::uint32_t number = 0;
    std::string name;              // of the tools file
    std::optional<double> radius;  // mm, by the set-up, else by the tools file or the comment
    std::optional<double> length;  // mm, by the set-up
    std::string corrector;         // offsets that are used with it: "D1 H1"
    struct Shared {
      std::string word;                  // "H3"
      std::vector<std::uint32_t> tools;  // others that use it too
    };
    std::vector<Shared> shared;         // of these offsets
    double seconds = 0;                 // at feed
    std::vector<std::uint32_t> lines;   // where it is called, the first ones, in the program itself
    std::vector<ProfilePoint> outline;  // empty: nobody knows its shape
    std::string comment;                // that names it
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
  std::string date;  // of today, "2026-11-25"
  std::vector<Zero> zeros;
  std::vector<Tool> tools;  // in the order of their first use
  double seconds = 0;
  std::vector<Note> comments;  // at the program's head
  std::vector<Stop> stops;
};

/// Of a run that is over.
///   program  its name, as it is shown
///   library  shapes of tools; nullptr: none are known
///   law      tools are those of the run's statistics
Sheet sheet_of(const ProgramRun& run, const SourceText& source, const std::string& program, Lang lang,
               const ToolLibrary* library = nullptr);

/// As the protocol has it.
nlohmann::ordered_json sheet_json(const Sheet& sheet, const Statistics& statistics);

}  // namespace kadr
