#pragma once
// VariableReader: gives compiled expressions (lang/expression/expression) access to the variables of a control during the evaluation.

#include "control/emitter.h"

namespace kadr {

struct VariableReader {
  Emitter& m;

  bool known(double number, double& value) const {
    if (m.macro_variables == nullptr || !m.macro_variables->known(number, value)) return false;
    if (is_vacant(value)) [[unlikely]]
      note_read(m, number);
    return true;
  }
  Result<double> variable(double number, Span where) const {
    if (m.use.watches()) [[unlikely]]
      note_read(m, number);
    return m.dialect->read_variable(m, number, where);
  }
  /// Returns the number of increments per unit of length. An increment is 0.0001 in or 0.001 mm (spec/haas 2.2).
  double increments() const {
    const bool inch = m.has_code({Function::inch}) || (m.modal.inch && !m.has_code({Function::millimetre}));
    return inch ? 10'000 : 1000;
  }
  Result<double> parameter(int index, Span where) const {
    if (m.use.watches()) note_read_parameter(m, index);
    return m.variables.parameter(index, where);
  }
  /// Returns the variable number of one element of a named system variable (nct 23.1.1).
  Result<double> element(double symbol, double index, Span where) const { return m.dialect->number_of_element(m, symbol, index, where); }
  Result<double> control_value(double number, double bit, double index, Span where) const {
    return m.dialect->control_value(m, number, bit, index, where);
  }
};

}  // namespace kadr
