#pragma once
// --state FILE: stores the data that a control keeps at power-off, from run to run.

#include <memory>
#include <optional>
#include <string>

#include "cli/job/job.h"
#include "config/state/state_file.h"

namespace kadr::cli {

/// Opens the state file and adds its contents to the job's set-up; values stated in the set-up take precedence. Prints errors.
std::optional<StateFile> open_state(const std::string& path, Job& job);

}  // namespace kadr::cli
