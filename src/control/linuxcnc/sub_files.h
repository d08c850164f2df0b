#pragma once
// Finds the files of subprograms: `label.ngc` (spec/linuxcnc 1.1; find_ngc_file of the source).

#include <cstdint>
#include <optional>
#include <string>

namespace kadr {
class Flow;
}

namespace kadr::linuxcnc {

class LinuxCnc;

/// Searches the program's folder, the program memory, then the folders of the ini file inside it, and nothing else.
///   returns  number of the file in `flow`; nullopt if there is none
std::optional<std::uint16_t> file_of_label(Flow& flow, const LinuxCnc& control, const std::string& label);

}  // namespace kadr::linuxcnc
