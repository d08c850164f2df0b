#pragma once
// The rooms in a row: program → control → machine → trace, summary, plot. The one place where they are put together.

#include <functional>
#include <memory>
#include <optional>

#include "cli/options.h"
#include "config/machine_profile.h"
#include "path/axis_roles.h"

namespace kadr::cli {

/// A program with everything that is needed to run it.
struct Job {
  std::string file;
  std::unique_ptr<ControlDef> def;
  MachineProfile profile;
  Setup setup;
  std::optional<Encoding> encoding;
  std::unique_ptr<AlarmTexts> texts;
};

/// Loads what the options name; complains to stderr.
///   returns  nothing, if something is missing or wrong (exit status 2)
std::optional<Job> make_job(const Options& options, const std::string& file);

/// Opens the program; complains if it cannot be read.
std::optional<Program> open_program(const Job& job);

/// What looks at the actions of a run.
struct Outlets {
  std::function<void(const Action&)> action;  // after the machine has taken it
  std::function<void(const AlarmReport&)> warning;
  /// An alarm; true: go on with the next block (checking).
  std::function<bool(const AlarmReport&)> alarm;
  std::function<void(const Control&)> batch;  // between batches: progress
};

/// How a run came to its end.
struct Stopped {
  std::optional<AlarmReport> report;          // the alarm that stopped it, if one did
  std::optional<ToolPosition> machine_stood;  // where, if the machine refused a motion: the control was ahead of it
};

/// Carries the program out.
Stopped carry_out(Control& control, const Job& job, const Outlets& outlets);

/// Ctrl-C and SIGTERM ask for the end of the run; what has been done is kept.
void catch_interrupts();
bool interrupted();

}  // namespace kadr::cli
