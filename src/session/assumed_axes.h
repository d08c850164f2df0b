#pragma once
// assume_axes: the axes of a machine that nobody has described, from the words of the program. A five-axis program then runs without a
// set-up; without its rotary axes every block that names one would be an alarm.

#include "config/control/control_def.h"
#include "config/setup/setup.h"
#include "lang/text/line_reader.h"

namespace kadr {

/// Adds to a set-up that names no axes those axes beyond X, Y, Z that the first 256 KiB of the program name, and notes that they are
/// assumed (Setup::axes_assumed). Two rotary axes get the usual kinematics: A and C a trunnion table, B and C a head and a table. Only for controls whose machines have any further axes (heidenhain, sinumerik). `program` may be nullptr.
void assume_axes(Setup& setup, ByteSource* program, const ControlDef& control);

}  // namespace kadr
