#pragma once
// Sheet: the set-up sheet of a program, for printing: work offsets, tools, extents, time, the programmer's notes, stops
// (docs/panel-protocol.md).

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "config/tools/tool_library.h"
#include "view/program_run.h"
#include "view/source_text.h"

namespace kadr {

struct Sheet {
  struct Zero {
    std::string name;   // name of the work offset, such as "G54"
    AxisValues values;  // values that the set-up states for the axes; empty if it states none
  };
  struct Tool {
    std::uint32_t number = 0;
    std::string name;              // name of the tool in the tools file
    std::optional<double> radius;  // radius in mm; from the set-up, else from the tools file or the comment
    std::optional<double> length;  // length in mm; from the set-up
    std::string corrector;         // words of the offsets that the program uses with the tool, such as "D1 H1"
    struct Shared {
      std::string word;                  // the word of the offset, such as "H3"
      std::vector<std::uint32_t> tools;  // numbers of the other tools that use the offset `word`
    };
    std::vector<Shared> shared;         // offsets of this tool that other tools use too
    double seconds = 0;                 // time in which the tool moves at feed, s
    std::vector<std::uint32_t> lines;   // numbers of the first lines of the main program that call the tool
    std::vector<ProfilePoint> outline;  // outline of the tool; empty if the shape of the tool is unknown
    std::string comment;                // comment of the program that names the tool
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
  std::string date;  // the present day, such as "2026-11-25"
  std::vector<Zero> zeros;
  std::vector<Tool> tools;  // tools in the order in which the program first uses them
  double seconds = 0;
  std::vector<Note> comments;  // comments at the beginning of the program
  std::vector<Stop> stops;
};

/// Creates the sheet of a run that has ended.
///   program  name of the program for display
///   library  shapes of the tools; nullptr if unknown
///   law      the tools are those in the statistics of the run
Sheet sheet_of(const ProgramRun& run, const SourceText& source, const std::string& program, Lang lang,
               const ToolLibrary* library = nullptr);

/// Converts the sheet to JSON in the form that docs/panel-protocol.md defines.
nlohmann::ordered_json sheet_json(const Sheet& sheet, const Statistics& statistics);

}  // namespace kadr
