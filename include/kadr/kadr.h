#pragma once
// Kadr as a library: read a control's file, interpret a program, pull its actions. examples/library shows it whole.

#include "action/curve.h"         // length, points and extents of a motion
#include "config/control_file.h"  // load_control
#include "config/setup.h"         // the state before the start
#include "control/control.h"      // Control: blocks → actions
