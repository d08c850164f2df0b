#pragma once
// --tool, --zero, --corrector: set-up data from the command line, which are added to the set-up file or override it.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "cli/options/options.h"
#include "config/control/control_def.h"
#include "config/setup/setup_file.h"

namespace kadr::cli {

/// Returns a set-up for each option. The caller must apply them after the set-up file.
///   returns  an error sentence if the value of an option cannot be read
tl::expected<std::vector<SetupSource>, std::string> setup_of_options(const Options& options, const ControlDef& def, Lang lang);

}  // namespace kadr::cli
