#pragma once
// What is loaded before a run: the files of a control, a machine, a set-up. Also guesses the control that a program was written for.

#include "config/control_file.h"     // load_control, parse_control
#include "config/guess.h"            // guess_control
#include "config/machine_profile.h"  // load_machine
#include "config/setup.h"            // parse_setup, load_setup
#include "config/setup_file.h"       // read_setup: checks the keys against a control
