#pragma once
// Files of subprograms: `label.ngc` (spec/linuxcnc 1.1; find_ngc_file of the source).

#include <cstdint>
#include <optional>
#include <string>

namespace kadr {
class Interpreter;
}

namespace kadr::linuxcnc {

/// In the program's folder, in the program memory, then in the folders of the ini file that lie in it; nothing outside of them.
///   returns  number of the file, as the interpreter counts those that it reads
std::optional<std::uint16_t> file_of_label(Interpreter& m, const std::string& label);

}  // namespace kadr::linuxcnc
