#pragma once
// Creates the report of a program: one HTML file with the page's viewer and all data. The file needs no server and no network.
//
//   ProgramRun, part ─▶ JSON and packed columns ─ zlib, base64 ─▶ inserted at report_data_marker of the viewer (web/report.html)

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

/// The remaining stock and the collisions of a cut.
struct ReportPart {
  std::string frame;  // the surface of the stock as a frame of kind 3 (docs/panel-protocol.md)
  // Cell size of the stock in mm; greatest distance in mm of the reduced triangles from the exact surface of the stock.
  double cell = 0, off = 0;
  std::string result;  // result of the cut as JSON text, from cut_json()
  std::string turned;  // sections of a turned part as JSON text, from turned_json(); empty if the part is not turned
  struct Hit {
    CutFinding finding;
    AlarmReport report;
  };
  std::vector<Hit> hits;
};

struct ReportContent {
  const ProgramRun& run;     // the run, which must have ended
  const SourceText& source;  // text of the program
  std::string file;          // name of the program for display
  std::string version;       // version of Kadr
  Lang lang = Lang::en;      // language in which the report is displayed first
  std::vector<ReportAlarm> alarms;
  std::vector<ViewPiece> contour;      // the contour without cutter compensation, where compensation was in force
  const ToolLibrary* tools = nullptr;  // shapes of the tools; nullptr if unknown
  const ReportPart* part = nullptr;    // result of a cut; nullptr if nothing was cut
  std::string licences;                // licence texts of the viewer's components
};

/// Creates the report. Its size is at most 5 MB for a program of up to 100,000 blocks, and proportionally more for a longer program. If
/// necessary, vertices of the path are omitted, and the report mentions the omission.
///   viewer   HTML of the viewer, which contains report_data_marker
///   law      text of the program is inserted only as base64, never as markup
///   returns  the report as HTML, or an error sentence if zlib is missing or the viewer has no report_data_marker
tl::expected<std::string, std::string> report_html(std::string_view viewer, const ReportContent& content);

inline constexpr std::string_view report_data_marker = "@KADR_REPORT_DATA@";

}  // namespace kadr
