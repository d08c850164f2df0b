#pragma once
// What is loaded before a run: a control's file, a machine's, a set-up; and which control a program was written for.

#include "config/control_file.h"     // load_control, parse_control
#include "config/guess.h"            // guess_control
#include "config/machine_profile.h"  // load_machine
#include "config/setup.h"            // parse_setup, load_setup
#include "config/setup_file.h"       // read_setup: keys held against a control
