// kadr state check|recover: checks the file that --state keeps, and recovers what can be read of it.

#include <fmt/core.h>

#include <cstdio>

#include "cli/job/terminal.h"
#include "cli/options/options.h"
#include "config/language.h"
#include "config/state/state_check.h"

namespace kadr::cli {
namespace {

std::string rows_in_words(std::size_t rows) {
  return told(fmt::format("{} {}", rows, rows == 1 ? "row" : "rows"), count_in_russian(rows, "запись", "записи", "записей"));
}

/// Prints what was found to standard output.
int print(const StateOptions& options, const StateReport& report, const std::string& heading) {
  std::string text = fmt::format("{}: {}\n", options.file, heading);
  for (const std::string& fault : report.faults) text += "  " + fault + "\n";
  type_out("{}", text);
  return report.faults.empty() ? ok : alarms;
}

int check_file(const StateOptions& options) {
  const auto report = check_state(options.file);
  if (!report) {
    complain(report.error());
    return wrong_usage;
  }
  const std::string control = report->control.empty() ? "?" : report->control, rows = rows_in_words(report->rows);
  if (!report->faults.empty())
    return print(options, *report,
                 told("damaged: control " + control + ", sound: " + rows, "повреждён: система " + control + ", цело: " + rows));
  const std::string old = report->checked ? ""
                                          : told("; of an older Kadr, without checksums: whether its values are true cannot be checked",
                                                 "; от прежней версии Kadr, без контрольных сумм: верны ли значения, проверить нельзя");
  return print(options, *report, told("sound: control " + control + ", " + rows, "исправен: система " + control + ", " + rows) + old);
}

int recover_file(const StateOptions& options) {
  const std::string to = options.out.empty() ? options.file + ".recovered" : options.out;
  const auto report = recover_state(options.file, to, options.control);
  if (!report) {
    complain(report.error());
    return wrong_usage;
  }
  const std::string rows = rows_in_words(report->rows);
  const std::string heading =
      report->faults.empty() ? told(rows + " written to " + to + ", nothing is lost", rows + " записано в " + to + ", ничего не потеряно")
                             : told(rows + " written to " + to + "; what was wrong, and is not there:",
                                    rows + " записано в " + to + "; что было неверно и не вошло:");
  return print(options, *report, heading);
}

}  // namespace

int state(const StateOptions& options) { return options.recover ? recover_file(options) : check_file(options); }

}  // namespace kadr::cli
