#pragma once
// The report of a program: the page's viewer with the data inside, one HTML file that needs no server and no network.
//
//   ProgramRun, part ─▶ JSON and packed columns ─ zlib, base64 ─▶ into its place in the viewer (web/report.html)

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "stock/cut_result.h"
#include "view/sheet.h"

namespace kadr {

/// An alarm, warning or note of the run, and when it came.
struct ReportAlarm {
  AlarmReport report;
  double at = 0;
};

/// What is left of the blank, and what was hit.
struct ReportPart {
  std::string frame;         // of kind 3 (docs/panel-protocol.md)
  double cell = 0, off = 0;  // mm: of the lattice it comes from; of its triangles from that surface
  std::string result;        // cut_json()
  struct Hit {
    CutFinding finding;
    AlarmReport report;
  };
  std::vector<Hit> hits;
};

struct ReportContent {
  const ProgramRun& run;     // which is over
  const SourceText& source;  // of the program
  std::string file;          // its name, as it is shown
  std::string version;       // of Kadr
  Lang lang = Lang::en;      // it opens in
  std::vector<ReportAlarm> alarms;
  std::vector<ViewPiece> contour;      // as programmed, where the tool's radius is compensated
  const ToolLibrary* tools = nullptr;  // shapes; nullptr: none are known
  const ReportPart* part = nullptr;    // nullptr: nothing was cut
  std::string licences;                // of what the viewer is made of
};

/// Of a program of up to 100,000 blocks at most 5 MB; of a longer one in proportion: the path is thinned where that is needed, and it is
/// said so.
///   viewer   HTML with report_place in it
///   law      what a program says comes into it in base64 alone: no markup
///   returns  an error sentence: no zlib, no place
tl::expected<std::string, std::string> report_html(std::string_view viewer, const ReportContent& content);

inline constexpr std::string_view report_place = "@KADR_REPORT_DATA@";

}  // namespace kadr
