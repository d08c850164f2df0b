#pragma once
// VariableDialect: the variables of a control beyond those that its file lists. One of the interfaces of a Dialect (control/dialect.h).

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

  /// Variables that hold something, and those that are asked for.
  virtual void add_variables(Emitter& m, Ending& ending, const std::vector<std::string>& watch);
  virtual Result<double> read_variable(Emitter& m, double number, Span where) const;
  /// #n=… of a control without levels of locals.
  virtual Status write_variable(BlockContext& m, double number, double value, Span where);
  /// Number of an element of a variable with a name.
  virtual Result<double> number_of_element(const BlockContext& m, double symbol, double index, Span where) const;
  /// A parameter of the control; NaN bit, index: left out.
  virtual Result<double> control_value(BlockContext& m, double number, double bit, double index, Span where) const;
};

}  // namespace kadr
