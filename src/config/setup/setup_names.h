#pragma once
// Decides, by the control's file, which keys of a set-up exist on a control, and which names the tables of the set-up may have: axes, work
// systems, numbers.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/control/control_def.h"
#include "config/setup/setup_keys.h"

namespace kadr {

/// Returns true if the control has what a key of the set-up needs, such as a parameter table or a probe. The control's file states this.
bool has(const ControlDef& def, SetupNeeds needs);

/// A work system of the control, with the name that it has in a set-up.
struct WorkSystem {
  std::string name;   // "G54", "G54.1 P2"
  std::uint32_t row;  // number of the row in the table of work offsets or fixtures
  bool works = true;  // true if Kadr implements the work system
};
std::vector<WorkSystem> work_systems(const ControlDef& def);
/// Returns the names of the work systems by `row`. Element 0 is the code that selects no work system ("G53"); empty if there is no such
/// code.
std::vector<std::string> system_names(const ControlDef& def);

/// Joins names to a text with the last two joined by "or": "N5114, N5200#1 or N1006.X".
std::string alternatives(const std::vector<std::string>& all, Lang lang);

class SetupNamesOf {
 public:
  /// def: the control whose names are permitted; nullptr: the names of all controls are. axes: axes of the program's channel. all_axes:
  /// axes of all channels.
  SetupNamesOf(const ControlDef* def, std::vector<std::string> axes, std::vector<std::string> all_axes);

  bool knows(const SetupKey& row) const { return def_ == nullptr || has(*def_, row.needs); }
  bool allows(SetupNames kind, std::string_view name) const;
  /// Returns all names of one kind (axes, work offsets …), so that a message can suggest one of them. Returns an empty list if the names
  /// are numbers or have a fixed form.
  std::vector<std::string> all(SetupNames kind) const;
  /// Returns in words the form that names of one kind have: "named by a whole number, 1 to 9"; "named common, G54 or …".
  std::string form(SetupNames kind, Lang lang) const;
  /// Returns an example of each form of name that the control's parameter table has, for messages and pages: N5114, N5200#1, N1006.X.
  std::vector<std::string> forms_of_parameters() const;
  /// Returns true if the name is that of a work offset which the control has but which Kadr does not support yet.
  bool unsupported(SetupNames kind, std::string_view name) const;
  /// Checks the form of a parameter's value in the set-up. Returns in words the form that the value must have if it has another form; else
  /// nullopt. `text`: the value is given as text.
  std::optional<std::string> parameter_fault(std::string_view name, double value, bool text, Lang lang) const;
  /// Returns the permitted range of a key's numbers on this control.
  SetupRange range(const SetupKey& row) const;
  const ControlDef* control() const { return def_; }

 private:
  struct Numbers {
    int least, most;
  };
  Numbers numbers(SetupNames kind) const;

  const ControlDef* def_;
  std::vector<std::string> axes_, all_axes_;
  std::vector<WorkSystem> systems_;
};

}  // namespace kadr
