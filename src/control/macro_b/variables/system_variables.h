#pragma once
// System variables of the NCT control by number (spec/nct/23 23.1.5–23.1.22) and PRM (24.2).

#include <string>

#include "base/result.h"
#include "base/span.h"
#include "base/vec.h"

namespace kadr {
class Interpreter;
}

namespace kadr::nct {

/// Of the tool as it is taken into account now, on each axis, mm.
Axes length_in_force(const Interpreter& m);

/// Value of #number, vacant where it is empty.
///   alarms  illegal_address… variable_unknown, variable_write_only
Result<double> read_variable(Interpreter& m, double number, Span where);
/// Writes #number.
///   alarms  variable_unknown, variable_read_only (2161), value_limit (2092)
Status write_variable(Interpreter& m, double number, double value, Span where);
/// The same for the set-up: N1702, N1703 protect nothing from it, and inputs of the PLC can be given.
Status set_start_value(Interpreter& m, double number, double value);
/// #_NAME[index] → number. alarms value_out_of_range
Result<double> number_of_element(const Interpreter& m, double symbol, double index, Span where);
/// Number of "ALM" or "ABSIO[3]"; -1: unknown.
double number_of_symbol(const Interpreter& m, const std::string& name);
/// PRM[number, bit]/[index]; vacant: left out.
Result<double> read_parameter(Interpreter& m, double number, double bit, double index, Span where);

}  // namespace kadr::nct
