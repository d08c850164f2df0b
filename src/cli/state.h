#pragma once
// --state FILE: keeps the control's memory from run to run.

#include <memory>
#include <optional>
#include <string>

#include "cli/job.h"
#include "config/state_file.h"

namespace kadr::cli {

/// Opens the file and adds its contents to the job's set-up; values of the set-up take precedence. Complains on errors.
std::optional<StateFile> open_state(const std::string& path, Job& job);

}  // namespace kadr::cli
