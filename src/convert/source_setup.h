#pragma once
// Finds the set-up of another control that corresponds to a program's set-up.

#include <map>
#include <string>

#include "config/control_def.h"
#include "config/setup.h"
#include "convert/flat_program.h"
#include "convert/program_shape.h"
#include "session/session.h"

namespace kadr {

/// Returns the set-up from which a program of `to` begins as a program of `from` begins from `setup`: tables under the numbers that the
/// other control has for them, and rows for the tools that it looks up in a table.
///   plain  without tables: all offsets are applied to the coordinates
Setup corresponding_setup(const Setup& setup, const ControlDef& from, const ControlDef& to, const ProgramNames& names, bool plain);

/// True if a set-up of the control may have this key.
bool allows_key(const ControlDef& def, const char* key);

/// True if the control has a code for tool changes; else it stops, and the tool is changed by hand.
bool changes_tools(const ControlDef& def);

/// Moves what a probe touches a little: figures that change with it must not be written out. Returns false if there is nothing to probe.
bool probe_elsewhere(Setup& setup);

/// True if both controls show messages in the same way: (MSG,…) of RS274/NGC and Mach3, #3006 of macros.
bool shows_same_messages(const ControlDef& from, const ControlDef& to);

/// Returns a set-up file with the start, tables and switches. Limits and rates belong to each machine and are left out.
std::string setup_text(const Setup& setup);

/// Returns what the actions do not contain of a session's program and set-up.
FlatSource flat_source_of(const Session& session, const ControlDef& to);
/// Returns the lengths and radii in force after all blocks executed so far.
OffsetsInForce offsets_of(const Control& control);

}  // namespace kadr
