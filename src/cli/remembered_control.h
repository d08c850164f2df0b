#pragma once
// The control that a folder's .kadr.toml remembers for its programs, and for those of folders below it:
//
//   control = "haas"              # an id of `kadr controls`, or a control file, beside this one
//   [control_for]
//   "*.ngc" = "linuxcnc"          # as --control-for
//
// It is written by --remember alone.

#include <optional>
#include <string>

#include "cli/options.h"

namespace kadr::cli {

inline constexpr const char* remembering_file = ".kadr.toml";

/// The nearest .kadr.toml decides, in the folder or above. Complains of one that is wrong.
///   returns  empty: nothing is remembered
std::string remembered_control(const std::string& file);

/// Writes `options.control` to the .kadr.toml of the folder the file lies in, other lines stay.
///   returns  false: it cannot be written, or there is none to write; complains
bool remember_control(const Options& options, const std::string& file);

}  // namespace kadr::cli
