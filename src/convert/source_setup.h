#pragma once
// Finds the set-up of the target control that corresponds to the set-up of a source program.

#include <map>
#include <string>

#include "config/control/control_def.h"
#include "config/setup/setup.h"
#include "convert/flat/flat_program.h"
#include "convert/program_shape.h"
#include "session/session.h"

namespace kadr {

/// Returns the set-up for the target control `to` that corresponds to `setup` of the source control `from`: both programs begin in the same
/// state. Table rows get the numbers that the target control has for them; tools that the target control looks up in a table get rows
/// there.
///   plain  true: leave out the tables, because the converted program has all offsets applied to its coordinates
Setup corresponding_setup(const Setup& setup, const ControlDef& from, const ControlDef& to, const ProgramNames& names, bool plain);

/// True if the control is that of a lathe: T has an offset for each axis, and X is a diameter.
bool is_lathe(const ControlDef& def);
/// True if one of the two controls is that of a lathe.
bool turns(const ControlDef& from, const ControlDef& to);
/// Returns the code that puts the lengths of a turning tool along all axes into force (G43.7 of the NCT, nct 15.4); nullptr if the control
/// is a lathe's, whose T does this, or has no such code.
const CodeRow* turning_length_code(const ControlDef& def);
/// True if a tool with wear moves the axes at the same time on both controls. On the lathes of Fanuc they move by the wear in the block of
/// T (spec/fanuc-t 4.1), on those of Haas with the next motion (spec/haas-st 3); other controls have one length, the sum.
bool wears_alike(const ControlDef& from, const ControlDef& to);

/// True if the set-up of this control may contain the key.
bool allows_key(const ControlDef& def, const char* key);

/// True if the control has a code for tool changes. Otherwise the program stops, and the operator changes the tool.
bool changes_tools(const ControlDef& def);

/// Shifts the surface that a probe touches by a short distance. Coordinates that change with this shift depend on the probe, so they must
/// not be expanded. Returns false if the set-up has nothing to probe.
bool probe_elsewhere(Setup& setup);

/// True if both controls display messages in the same way: both by (MSG,…), as RS274/NGC and Mach3, or both by #3006, as macros.
bool shows_same_messages(const ControlDef& from, const ControlDef& to);

/// Returns the text of a set-up file with the start position, tables and switches. Limits and rates belong to the machine, so they are left
/// out.
std::string setup_text(const Setup& setup);

/// Returns the properties of a session's program and set-up that the program's actions do not state.
FlatSource flat_source_of(const Session& session, const ControlDef& to);
/// Returns the numbers of the length and radius offsets in force after the blocks executed so far.
///   def  the definition of the control
OffsetsInForce offsets_of(const Control& control, const ControlDef& def);

}  // namespace kadr
