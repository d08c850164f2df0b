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
#include "stock/mesh/mesh.h"
#include "view/sheet.h"

namespace kadr {

/// An alarm, warning or note of the run, and when it came.
struct ReportAlarm {
  AlarmReport report;
  double at = 0;
};

/// What is left of the blank.
struct ReportPart {
  Mesh mesh;                         // places as those of the path
  std::vector<std::uint16_t> tools;  // of each point: that made it; 65535: the blank
  std::vector<std::uint32_t> lines;  // that made it; 0: the blank
  double cell = 0, off = 0;          // mm: of the lattice; of the triangles from it
  std::string result;                // as cut_json() writes it
  std::vector<CutFinding> findings;  // with their calls
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
