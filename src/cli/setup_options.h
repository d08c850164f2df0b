#pragma once
// --tool, --zero, --corrector: what stands in no set-up file, or goes before it.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "cli/options.h"
#include "config/control_def.h"
#include "config/setup_file.h"

namespace kadr::cli {

/// As set-ups to be laid over the file's, one an option.
///   returns  an error sentence: an option that is not understood
tl::expected<std::vector<SetupSource>, std::string> setup_of_options(const Options& options, const ControlDef& def, Lang lang);

}  // namespace kadr::cli
