#pragma once
// Files of subprograms: `label.ngc` (spec/linuxcnc 1.1; find_ngc_file of the source).

#include <cstdint>
#include <optional>
#include <string>

namespace kadr {
class Flow;
}

namespace kadr::linuxcnc {

class LinuxCnc;

/// In the program's folder, in the program memory, then in the folders of the ini file that lie in it; nothing outside of them.
///   returns  number of the file, as `flow` counts those that it reads
std::optional<std::uint16_t> file_of_label(Flow& flow, const LinuxCnc& control, const std::string& label);

}  // namespace kadr::linuxcnc
