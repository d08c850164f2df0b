#pragma once
// Loads what a run needs: the files of a control, a machine and a set-up. Also guesses the control that a program was written for.

#include "config/control/control_file.h"     // load_control, parse_control
#include "config/control/guess.h"            // guess_control
#include "config/machine/machine_profile.h"  // load_machine
#include "config/setup/setup.h"              // parse_setup, load_setup
#include "config/setup/setup_file.h"         // read_setup: checks the keys against a control
