#pragma once
// LinuxCNC's tool table file (spec/linuxcnc 9).

#include <map>
#include <string_view>

#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {

/// Lines of `T1 P1 Z50 D10 ; end mill`; what cannot be read is passed over. mm, degrees.
std::map<int, Tool> read_tools(std::string_view text);

}  // namespace kadr::linuxcnc
