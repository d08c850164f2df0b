// Decides what a call of a cycle does: settings, or steps (spec/sinumerik 14). Used by control/sinumerik.

#include <algorithm>

#include "base/ascii.h"
#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {
namespace {

/// CYCLE832: the tolerance of the path, which the planner may use as in G642 with CTOL (spec/sinumerik 14.6).
Status set_tolerance(Interpreter& m, const std::vector<Value>& arguments, Span where) {
  const double tolerance = !arguments.empty() && arguments[0].is_number() ? arguments[0].number * m.unit_scale() : 0;
  if (!(tolerance >= 0)) return fail(alarm(AlarmId::value_out_of_range, where, "CYCLE832", tolerance));
  sinumerik_of(m).memory.tolerance = tolerance;
  m.modal.blend_tolerance = tolerance;
  return {};
}

}  // namespace

bool Sinumerik::is_cycle(std::string_view name) {
  if (name.starts_with("CYCLE") && name.size() > 5 && is_digit(name[5])) return true;
  constexpr std::string_view others[] = {"HOLES1", "HOLES2", "POCKET1", "POCKET2", "POCKET3", "POCKET4", "SLOT1", "SLOT2", "LONGHOLE"};
  return std::find(std::begin(others), std::end(others), name) != std::end(others);
}

Status Sinumerik::run_cycle(Interpreter& m, const std::string& name, const std::vector<Value>& arguments, Span where) {
  if (name == "CYCLE832") return set_tolerance(m, arguments, where);
  const bool passed_over = name.size() == 8 && name.starts_with("CYCLE75");
  if (passed_over) return {};  // settings of the machine: the programmed path stays as it is (spec/sinumerik 14.6)
  if (name == "CYCLE800") return swivel(m, arguments, where);
  if (name == "CYCLE72") return mill_contour(m, arguments, where);
  if (is_milling_cycle(name)) return start_milling(m, name, arguments, where);
  return start_cycle(m, name, arguments, where);
}

}  // namespace kadr::sinumerik
