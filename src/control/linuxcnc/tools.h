#pragma once
// Reads and writes LinuxCNC's tool table file (spec/linuxcnc 9).

#include <map>
#include <string>
#include <string_view>

#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {

/// Reads lines such as `T1 P1 Z50 D10 ; end mill`. Lines that cannot be read are skipped. `unit`: unit of the lengths in the file, in mm.
std::map<int, Tool> read_tools(std::string_view text, double unit);

/// Returns the text of the tool table file in LinuxCNC's format. `unit`: unit of the lengths in the file, in mm.
///   law  read_tools() of this text returns the same tools, to six decimals of the unit
std::string tools_text(const std::map<int, Tool>& tools, double unit);

}  // namespace kadr::linuxcnc
