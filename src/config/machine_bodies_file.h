#pragma once
// The reader of [[bodies]]. For config/machine_profile.

#include <toml++/toml.h>

#include <string>
#include <tl/expected.hpp>

#include "config/machine_profile.h"

namespace kadr {

/// Puts the bodies of a machine's file into the profile, whose axes and chains stand already.
///   returns  an error sentence with file and line
tl::expected<void, std::string> bodies_of(const std::string& file, const toml::table& table, MachineProfile& profile);

}  // namespace kadr
