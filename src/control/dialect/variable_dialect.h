#pragma once
// VariableDialect: the variables of a control that its file does not list. One of the interfaces of a Dialect (control/dialect.h).

#include <string>
#include <vector>

#include "base/result.h"
#include "control/control.h"

namespace kadr {

class BlockContext;
class Emitter;

class VariableDialect {
 public:
  virtual ~VariableDialect() = default;

  /// Adds variables to the report at the end of the program: the variables that have a value, and those named in `watch`.
  virtual void add_variables(Emitter& m, FinalState& ending, const std::vector<std::string>& watch);
  virtual Result<double> read_variable(Emitter& m, double number, Span where) const;
  /// Executes #n=… on a control without levels of local variables.
  virtual Status write_variable(BlockContext& m, double number, double value, Span where);
  /// Returns the variable number of the element `symbol`[`index`] of a named variable.
  virtual Result<double> number_of_element(const BlockContext& m, double symbol, double index, Span where) const;
  /// Returns the value of a parameter of the control. `bit` and `index` are NaN if the program omits them.
  virtual Result<double> control_value(BlockContext& m, double number, double bit, double index, Span where) const;
};

}  // namespace kadr
