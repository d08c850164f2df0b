#pragma once
// What one control knows of a set-up: by what its file has. And the names that may stand in its tables: axes, work systems, numbers.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/control_def.h"
#include "config/setup_keys.h"

namespace kadr {

/// Whether the control's file has what the key is for.
bool has(const ControlDef& def, SetupNeeds needs);

/// A work system of the control, as a set-up names it.
struct WorkSystem {
  std::string name;   // "G54", "G54.1 P2"
  std::uint32_t row;  // of the table of zeros or fixtures
  bool works = true;  // Kadr does it
};
std::vector<WorkSystem> work_systems(const ControlDef& def);
/// Their names by `row`; that of 0: of no work system, the code that says so ("G53") or nothing.
std::vector<std::string> system_names(const ControlDef& def);

class SetupNamesOf {
 public:
  /// `def` nullptr: of all controls. `axes`: of the program's channel; `all_axes`: of all channels.
  SetupNamesOf(const ControlDef* def, std::vector<std::string> axes, std::vector<std::string> all_axes);

  bool knows(const SetupKey& row) const { return def_ == nullptr || has(*def_, row.needs); }
  bool allows(SetupNames kind, std::string_view name) const;
  /// Those that there are, to choose the nearest from; empty where they are numbers or of a form.
  std::vector<std::string> all(SetupNames kind) const;
  /// "named by a whole number, 1 to 9"; "named common, G54 or …".
  struct Words {
    std::string en, ru;
  };
  Words form(SetupNames kind) const;
  /// A parameter's name of each form that the control's table has, for messages and pages: N5114, N5200#1, N1006.X.
  std::vector<std::string> forms_of_parameters() const;
  /// "axis", «оси».
  static SetupWords kind_name(SetupNames kind);
  /// A work system that the control has and Kadr does not do yet.
  bool unserved(SetupNames kind, std::string_view name) const;
  /// What the value of a parameter must be, if it is not; `text`: given as a text.
  std::optional<Words> parameter_fault(std::string_view name, double value, bool text) const;
  /// Numbers of the row for this control.
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
