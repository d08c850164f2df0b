#pragma once
// Creates the report of a program: the page's viewer with the data inside, as one HTML file that needs no server and no network.
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

/// An alarm, warning or note of the run, and its time.
struct ReportAlarm {
  AlarmReport report;
  double at = 0;
};

/// The remaining stock, and the collisions.
struct ReportPart {
  std::string frame;         // of kind 3 (docs/panel-protocol.md)
  double cell = 0, off = 0;  // mm: cell of its lattice; deviation of the triangles from that surface
  std::string result;        // cut_json()
  struct Hit {
    CutFinding finding;
    AlarmReport report;
  };
  std::vector<Hit> hits;
};

struct ReportContent {
  const ProgramRun& run;     // must have ended
  const SourceText& source;  // of the program
  std::string file;          // its name, for display
  std::string version;       // of Kadr
  Lang lang = Lang::en;      // the language in which the report opens
  std::vector<ReportAlarm> alarms;
  std::vector<ViewPiece> contour;      // as programmed, where it is compensated for the tool radius
  const ToolLibrary* tools = nullptr;  // shapes; nullptr: unknown
  const ReportPart* part = nullptr;    // nullptr: nothing was cut
  std::string licences;                // of the components of the viewer
};

/// The report has at most 5 MB for a program of up to 100,000 blocks, and in proportion for a longer one: the path is thinned if needed,
/// and the report says so.
///   viewer   HTML that contains report_place
///   law      text of the program is inserted as base64 only, never as markup
///   returns  an error sentence: no zlib, no place
tl::expected<std::string, std::string> report_html(std::string_view viewer, const ReportContent& content);

inline constexpr std::string_view report_place = "@KADR_REPORT_DATA@";

}  // namespace kadr
