#pragma once
// LinuxCNC's tool table file (spec/linuxcnc 9).

#include <map>
#include <string>
#include <string_view>

#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {

/// Lines of `T1 P1 Z50 D10 ; end mill`; what cannot be read is passed over. `unit`: mm, of the lengths that stand there.
std::map<int, Tool> read_tools(std::string_view text, double unit);

/// The same lines, as LinuxCNC writes them.
///   law  read_tools() of it gives the tools, to six decimals of the unit
std::string tools_text(const std::map<int, Tool>& tools, double unit);

}  // namespace kadr::linuxcnc
