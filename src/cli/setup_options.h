#pragma once
// --tool, --zero, --corrector: set-up data that no file states, or that overrides the file.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "cli/options.h"
#include "config/control_def.h"
#include "config/setup_file.h"

namespace kadr::cli {

/// Returns a set-up for each option, to be applied over the set-up file.
///   returns  an error sentence if an option is not understood
tl::expected<std::vector<SetupSource>, std::string> setup_of_options(const Options& options, const ControlDef& def, Lang lang);

}  // namespace kadr::cli
