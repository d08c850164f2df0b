#pragma once
// Reads [[bodies]] of machines/*.toml. Used by config/machine/machine_profile.

#include <toml++/toml.h>

#include <string>
#include <tl/expected.hpp>

#include "config/machine/machine_profile.h"

namespace kadr {

/// Adds the bodies of a machine's file to the profile. The axes and chains of the profile must be set before.
///   returns  on failure, an error sentence with file and line
tl::expected<void, std::string> bodies_of(const std::string& file, const toml::table& table, MachineProfile& profile);

}  // namespace kadr
