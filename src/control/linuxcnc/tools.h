#pragma once
// Reads and writes LinuxCNC's tool table file (spec/linuxcnc 9).

#include <map>
#include <string>
#include <string_view>

#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {

/// Reads lines such as `T1 P1 Z50 D10 ; end mill`; skips what cannot be read. `unit`: mm, of the lengths in the file.
std::map<int, Tool> read_tools(std::string_view text, double unit);

/// Writes the lines as LinuxCNC does.
///   law  read_tools() of the result gives the same tools, to six decimals of the unit
std::string tools_text(const std::map<int, Tool>& tools, double unit);

}  // namespace kadr::linuxcnc
