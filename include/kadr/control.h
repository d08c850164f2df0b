#pragma once
// Control: the interpreter alone, which converts blocks to actions. For a whole run, with the machine, the times and the planner, use
// Session (<kadr/session.h>).

#include "control/control.h"
