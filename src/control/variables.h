#pragma once
// #1 … #n of Mach3 (system variables among them), R0 … R9 of the 2С42. What a block writes can be taken back.

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "config/control_def.h"

namespace kadr {

class Variables {
 public:
  explicit Variables(const ControlDef& def);

  /// Value of #number; a number never set is 0 (Mach3).
  ///   alarms  variable_unknown, for a number that is no variable
  Result<double> variable(double number, Span where) const;
  /// Value of R`index`.
  ///   alarms  variable_not_set
  Result<double> parameter(int index, Span where) const;

  Status set(double number, double value, Span where);
  void set_parameter(int index, double value);
  /// R5; of several letters R05, P123 (spec/correctors 3).
  std::string name_of_parameter(int index) const;
  /// Its index, or -1.
  int parameter_named(const std::string& name) const;
  int parameter_count() const { return static_cast<int>(parameters_.size()); }

  double raw(std::uint32_t number) const { return number < values_.size() ? values_[number] : 0; }
  void set_raw(std::uint32_t number, double value);
  /// A number that means something to the control.
  bool is_system(std::uint32_t number) const { return kind_of(number) != VariableKind::free; }
  bool is_set(std::uint32_t number) const { return number < set_.size() && set_[number]; }
  std::uint32_t highest() const { return static_cast<std::uint32_t>(values_.size()) - 1; }
  bool parameter_set(int index) const { return parameters_set_[static_cast<std::size_t>(index)]; }
  double raw_parameter(int index) const { return parameters_[static_cast<std::size_t>(index)]; }

  /// First number of the rows of that kind, its `nth` repetition; 0 if the control has none.
  std::uint32_t first(VariableKind kind, std::uint32_t nth = 0) const;

  /// A system variable was written since the last call: frames must be worked out anew.
  bool take_frames_changed();

  void begin_block() { undo_.clear(); }
  void undo_block();

  bool inch = false;  // length variables are read and written in the program's unit

 private:
  struct Undo {
    std::int32_t number;  // negative: parameter -(number + 1)
    double value;
    bool was_set;
  };
  VariableKind kind_of(std::uint32_t number) const;
  bool is_length(std::uint32_t number) const;

  const ControlDef& def_;
  std::vector<double> values_;
  std::vector<bool> set_;
  std::vector<double> parameters_;
  std::vector<bool> parameters_set_;
  std::vector<Undo> undo_;
  bool frames_changed_ = false;
};

}  // namespace kadr
