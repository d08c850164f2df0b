#pragma once
// Control: the interpreter alone, blocks → actions. A whole run, with the machine, times and planner: <kadr/session.h>.

#include "control/control.h"
