#pragma once
// Finds the file of a subprogram, `label.ngc` (spec/linuxcnc 1.1; find_ngc_file of LinuxCNC's source).

#include <cstdint>
#include <optional>
#include <string>

namespace kadr {
class Flow;
}

namespace kadr::linuxcnc {

class LinuxCnc;

/// Searches the folder of the program, then the program memory, then those folders named by the ini file that are inside the program
/// memory; no others.
///   returns  number of the opened file in `flow`; nullopt if no file is found
std::optional<std::uint16_t> file_of_label(Flow& flow, const LinuxCnc& control, const std::string& label);

}  // namespace kadr::linuxcnc
