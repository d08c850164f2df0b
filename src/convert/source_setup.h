#pragma once
// The set-up of another control that corresponds to that of a program.

#include <map>
#include <string>

#include "config/control_def.h"
#include "config/setup.h"
#include "convert/flat_program.h"
#include "convert/program_shape.h"
#include "session/session.h"

namespace kadr {

/// The set-up from which a program of `to` begins as one of `from` does from `setup`: tables under the numbers that the other control has
/// for them, rows of tools that it asks a table for.
///   plain  no tables: all of them are calculated in
Setup corresponding_setup(const Setup& setup, const ControlDef& from, const ControlDef& to, const ProgramNames& names, bool plain);

/// A set-up of the control may have this key.
bool allows_key(const ControlDef& def, const char* key);

/// It has a code for that; else it stops, and the tool is changed by hand.
bool changes_tools(const ControlDef& def);

/// What a probe touches lies a little elsewhere: figures that change with it must not be written out. False: nothing is probed.
bool probe_elsewhere(Setup& setup);

/// The control shows messages in the way of the other one: (MSG,…) of RS274/NGC and Mach3, #3006 of macros.
bool shows_same_messages(const ControlDef& from, const ControlDef& to);

/// … as a set-up file: start, tables, switches. Limits and rates of the machine are its own.
std::string setup_text(const Setup& setup);

/// What of a session's program and set-up its actions do not say.
FlatSource flat_source_of(const Session& session, const ControlDef& to);
/// Lengths and radii in force, all blocks so far carried out.
OffsetsInForce offsets_of(const Control& control);

}  // namespace kadr
