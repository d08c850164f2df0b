#pragma once
// Checks that each key of a set-up is in the table of keys (config/setup/setup_keys) and exists on the control.

#include <optional>
#include <set>
#include <string>

#include "config/json_lines.h"
#include "config/setup/setup_names.h"

namespace kadr {

/// A key that is wrong, and the reason.
struct KeyFault {
  std::string key;  // full name of the key: "work_offsets.G54.x"; empty: the fault concerns the whole set-up
  std::string sentence;
};

/// Returns the first fault in the order of the text's keys; nullopt if the text has no fault.
///   def      the control; nullptr: keys of every control are accepted
///   context  the set-up that is merged from all sources, including `value`; its axes are used for the check
std::optional<KeyFault> fault_of(const nlohmann::json& value, const nlohmann::json& context, const ControlDef* def,
                                 Lang lang = thread_language());

/// Returns in words the form that the value of a key must have: "a number, 0 to 1"; «число, от 0 до 1».
std::string form_of(const SetupKey& row, SetupRange range, Lang lang);

/// Returns the keys of tool offsets, work offsets and correctors that have a value: "offsets.1.length", "work_offsets.G54", "zeros.1",
/// "correctors.17". A key whose value is null is left out.
std::set<std::string> stated_in(const nlohmann::json& setup);

}  // namespace kadr
