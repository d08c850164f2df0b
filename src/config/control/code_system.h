#pragma once
// What makes a control a lathe's control, and the G-code systems of such a control.

#include <cstdint>
#include <string>

namespace kadr {

/// The manner in which a control with dialect = "nct" reads a lathe's program: T with geometry and wear, increments U W H V, turning cycles
/// G70 to G76 (spec/fanuc-t, spec/haas-st). none: the control belongs to a mill.
enum class Lathe : std::uint8_t { none, fanuc, haas };

/// A G-code system that a parameter of the set-up selects: if the parameter is not 0, the file of another control applies (spec/fanuc-t
/// 1.1).
struct CodeSystem {
  std::string parameter;  // the parameter as a set-up writes it, without N: "3401#6"
  std::string control;    // id of the control whose file has the codes of the system
};

}  // namespace kadr
