// Answers the request `report`: the report of the open program, as `kadr report` writes it, with the cut that the page shows. Used by
// view/page/page_session; tested by tests/serve_report.py.

#include <filesystem>

#include "texts/report_command.h"
#include "view/page/page_inside.h"
#include "view/report/report_part.h"

namespace kadr {

/// Executes the program once more, because this session keeps neither the path nor the alarms that it has sent to the page.
PageSession::Inside::Answer PageSession::Inside::report(const PageJson&) {
  if (server.viewer.html.empty()) return refused(translated(texts::report_command::built_without_page));
  auto again = ProgramRun::make(run->opened(), token());
  if (!again) return refused(again.error());
  std::vector<ReportAlarm> alarms;
  std::vector<ViewPiece> contour;
  (*again)->on_alarm = [&](const AlarmReport& report, double at, int channel) {
    AlarmReport shown = report;
    // An alarm of another channel gets no line number, since its line is in the program of that channel
    if (channel != 0) shown.origin.line = 0;
    alarms.push_back({std::move(shown), at});
  };
  (*again)->on_contour = [&](const ViewPiece& piece) { contour.push_back(piece); };
  (*again)->execute();
  if (stops) return refused(translated(texts::page::interrupted));
  ReportPart part;
  if (part_run) {
    part.hits = cut_hits;
    take_part(*part_run, part, token());
  }
  const std::string name = std::filesystem::path(run->opened().path).filename().string();
  const auto html = report_html(server.viewer.html, {**again, *source, name, server.version, lang, std::move(alarms), std::move(contour),
                                                     nullptr, part_run ? &part : nullptr, std::string(server.viewer.licences)});
  if (!html) return refused(html.error());
  return PageJson{{"html", *html}, {"name", std::filesystem::path(name).stem().string() + ".html"}};
}

}  // namespace kadr
