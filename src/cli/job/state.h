#pragma once
// --state FILE: stores, from one run to the next, the data that survive the power-off of a control.

#include <memory>
#include <optional>
#include <string>

#include "cli/job/job.h"
#include "config/state/state_file.h"

namespace kadr::cli {

/// Opens the state file and adds its contents to the set-up of the job. Values that the set-up states have priority. If an error occurs, it
/// is printed and the function returns nullopt.
std::optional<StateFile> open_state(const std::string& path, Job& job);

}  // namespace kadr::cli
