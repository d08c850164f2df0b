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

/// Searches the folder of the program, then the program memory, then the folders that the ini file names, if they are inside the program
/// memory.
///   returns  number of the file in `flow`, where it is open now; nullopt if no file is found
std::optional<std::uint16_t> file_of_label(Flow& flow, const LinuxCnc& control, const std::string& label);

}  // namespace kadr::linuxcnc
