// Found: prints the findings of a run. It is used by the rest of cli and tested by tests/run_faulty.py and tests/found.py.

#include "cli/job/found.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/job/terminal.h"
#include "out/text/source_line.h"
#include "texts/job.h"

namespace kadr::cli {
namespace {

constexpr std::size_t max_lines = 8;  // greatest number of program lines that are listed for one repeated finding

}  // namespace

void Found::print(const std::string& text) const {
  if (to_ == stderr) write_coloured_message(text);
  else type_into(to_, text);
}

void Found::print_report(const AlarmReport& report) {
  if (!every_ && report.alarm.severity != Severity::alarm) {
    const auto [at, is_first] = repeated_.try_emplace({report.file, report.alarm.id});
    Repeated& seen = at->second;
    if (!is_first) {
      ++seen.more;
      const bool is_new = std::find(seen.lines.begin(), seen.lines.end(), report.origin.line) == seen.lines.end();
      if (is_new && report.origin.line != 0 && seen.lines.size() <= max_lines) seen.lines.push_back(report.origin.line);
      return;
    }
  }
  print(alarm_text(report, texts_, lang_, to_ == stderr ? colours() : Colours::none));
}

void Found::finish() {
  for (const auto& [which, seen] : repeated_) {
    if (seen.more == 0) continue;
    const auto& [file, id] = which;
    const std::size_t named = std::min(seen.lines.size(), max_lines);
    const std::string lines = fmt::format("{}{}", fmt::join(seen.lines.begin(), seen.lines.begin() + std::ptrdiff_t(named), ", "),
                                          seen.lines.size() > named ? ", …" : "");
    const std::string more =
        named > 0 ? translated(texts::job::more_alike_in_lines, seen.more, lines) : translated(texts::job::more_alike, seen.more);
    print(fmt::format("{}: {}: {}\n", visible_name(file), name_of(id), more));
  }
  repeated_.clear();
}

}  // namespace kadr::cli
