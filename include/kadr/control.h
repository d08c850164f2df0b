#pragma once
// Control: the interpreter alone, which converts blocks to actions. For a whole run, with the machine, times and planner, see
// <kadr/session.h>.

#include "control/control.h"
