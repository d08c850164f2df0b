#pragma once
// Reads the section [guess] of a control file. Apart from guess_rows.h, so that files that only use the rows do without the parser's headers.

#include <toml++/toml.h>

#include <string>
#include <tl/expected.hpp>

#include "config/control/guess_rows.h"

namespace kadr {

/// Reads a section [guess].
///   returns  on failure, an error sentence: a weight that is not a number from -20 to 20 or is 0, or an unknown trait
tl::expected<GuessRows, std::string> guess_rows_of(const toml::table& guess, const std::string& file);

}  // namespace kadr
