#pragma once
// Finds everything that `kadr check` finds in a program: faults, advice of the checklist, values that the set-up does not state. Also
// judges which files are programs, and finds the control that a folder remembers.

#include "config/control/guess.h"
#include "config/control/remembered_control.h"  // RememberedControls: .kadr.toml
#include "config/program_names.h"               // judge_name
#include "lang/text/several_programs.h"         // contents_of: the programs of a tape
#include "session/checklist/program_check.h"    // ProgramCheck
