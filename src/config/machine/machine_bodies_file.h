#pragma once
// Reads [[bodies]]. Used by config/machine/machine_profile.

#include <toml++/toml.h>

#include <string>
#include <tl/expected.hpp>

#include "config/machine/machine_profile.h"

namespace kadr {

/// Adds the bodies in a machine's file to the profile, whose axes and chains must be set already.
///   returns  on failure, an error sentence with file and line
tl::expected<void, std::string> bodies_of(const std::string& file, const toml::table& table, MachineProfile& profile);

}  // namespace kadr
