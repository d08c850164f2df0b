#pragma once
// Variables: #1 … #n of Mach3, with its system variables, and the parameters R0 … R9 of the 2С42. An alarm restores what the block has
// written.

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "config/control/control_def.h"
#include "control/state/journal.h"

namespace kadr {

class Variables {
 public:
  /// `journal`: records the old values that a block overwrites.
  Variables(const ControlDef& def, Journal& journal);

  /// Returns the value of #number; 0 if the variable was never set (Mach3).
  ///   alarms  variable_unknown: the control has no variable with this number
  Result<double> variable(double number, Span where) const;
  /// Returns the value of R`index`.
  ///   alarms  variable_not_set
  Result<double> parameter(int index, Span where) const;

  Status set(double number, double value, Span where);
  void set_parameter(int index, double value);
  /// Returns the name of a parameter: R5; on a control with several parameter letters R05, P123 (spec/correctors 3).
  std::string name_of_parameter(int index) const;
  /// Returns the index of the parameter with this name; -1 if there is no such parameter.
  int parameter_named(const std::string& name) const;
  int parameter_count() const { return static_cast<int>(all_.parameters.size()); }

  double raw(std::uint32_t number) const { return number < all_.values.size() ? all_.values[number] : 0; }
  void set_raw(std::uint32_t number, double value);
  /// Returns true if the number is that of a system variable, which has a meaning for the control.
  bool is_system(std::uint32_t number) const { return kind_of(number) != VariableKind::free; }
  bool is_set(std::uint32_t number) const { return number < all_.set.size() && all_.set[number]; }
  std::uint32_t highest() const { return static_cast<std::uint32_t>(all_.values.size()) - 1; }
  bool parameter_set(int index) const { return all_.parameters_set[static_cast<std::size_t>(index)]; }
  double raw_parameter(int index) const { return all_.parameters[static_cast<std::size_t>(index)]; }

  /// Returns the number of the first variable of this kind; 0 if the control has none. A control may repeat the rows of its variables (for
  /// example once for each work offset): `nth` selects the repetition.
  std::uint32_t first(VariableKind kind, std::uint32_t nth = 0) const;

  /// Returns true if a system variable that changes the frames was written since the last call; the caller then recomputes the frames.
  bool consume_frames_changed();

  /// The values of variables, by number, and of parameters, by index.
  struct Values {
    std::vector<double> values, parameters;
    // for each variable and parameter: 1 if the program or the set-up has written its value, otherwise 0
    std::vector<std::uint8_t> set, parameters_set;
    friend bool operator==(const Values&, const Values&) = default;
  };
  const Values& all() const { return all_; }
  void put(const Values& all) { all_ = all; }

  bool inch = false;  // true in inch mode: variables that are lengths are read and written in inches

 private:
  VariableKind kind_of(std::uint32_t number) const;
  bool is_length(std::uint32_t number) const;

  const ControlDef& def_;
  Journal& journal_;
  Values all_;
  bool frames_changed_ = false;
};

}  // namespace kadr
