#pragma once
// All of Kadr as a library; docs/library.md shows its use by examples.

#include "action.h"   // Action: one thing that a program makes the machine do, as a value
#include "alarm.h"    // alarms and their texts
#include "check.h"    // everything that kadr check finds
#include "config.h"   // controls, machines, set-ups
#include "control.h"  // Control: blocks → actions
#include "program.h"  // open_file, text_source
#include "session.h"  // Session: the whole chain from program to axis positions over time
#include "sinks.h"    // trace, summary, picture
#include "version.h"
