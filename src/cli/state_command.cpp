// kadr state check|recover: checks the file that the option --state names, and recovers the readable data from it.

#include "texts/state_command.h"

#include <fmt/core.h>

#include <cstdio>

#include "cli/job/terminal.h"
#include "cli/options/options.h"
#include "config/state/state_check.h"

namespace kadr::cli {
namespace {

/// Prints the findings about the file on standard output.
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
  const std::string control = report->control.empty() ? "?" : report->control, rows = counted(texts::state_command::rows, report->rows);
  const auto heading = !report->faults.empty() ? texts::state_command::damaged
                       : report->checked       ? texts::state_command::sound
                                               : texts::state_command::sound_without_checksums;
  return print(options, *report, translated(heading, control, rows));
}

int recover_file(const StateOptions& options) {
  const std::string to = options.out.empty() ? options.file + ".recovered" : options.out;
  const auto report = recover_state(options.file, to, options.control);
  if (!report) {
    complain(report.error());
    return wrong_usage;
  }
  const std::string rows = counted(texts::state_command::rows, report->rows);
  const auto heading = report->faults.empty() ? texts::state_command::all_recovered : texts::state_command::some_recovered;
  return print(options, *report, translated(heading, rows, to));
}

}  // namespace

int state(const StateOptions& options) { return options.recover ? recover_file(options) : check_file(options); }

}  // namespace kadr::cli
