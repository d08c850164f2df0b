#pragma once
// Whether a set-up names only what there is: each key against the table of keys (config/setup_keys) and the control.

#include <optional>
#include <set>
#include <string>

#include "config/json_lines.h"
#include "config/setup_file.h"
#include "config/setup_names.h"

namespace kadr {

/// The first fault, in the order of the text's keys; nothing: all is well.
///   def      nullptr: what any control knows
///   context  the whole set-up, where `value` is laid over another one: its axes count
std::optional<SetupFault> fault_of(const nlohmann::json& value, const nlohmann::json& context, const ControlDef* def);

/// What a key must be: "a number, 0 to 1"; «число, от 0 до 1».
SetupNamesOf::Words form_of(const SetupKey& row, SetupRange range);

/// Keys of tool offsets, work zeros and correctors that state something: "offsets.1.length", "work_offsets.G54", "zeros.1",
/// "correctors.17". What is null is not stated.
std::set<std::string> stated_in(const nlohmann::json& setup);

}  // namespace kadr
