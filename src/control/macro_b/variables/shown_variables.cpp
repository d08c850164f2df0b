// The variables that are reported after a run, and the numbers of symbolic names. Used by control/macro_b/macro_b for the last line of a
// trace.

#include <algorithm>
#include <cstdlib>

#include "control/emitter.h"
#include "control/macro_b/macro_b.h"

namespace kadr::macro_b {

double number_of_symbol(const BlockContext& m, const std::string& name) {
  const std::string plain = name.substr(0, name.find('['));
  const double index = name.find('[') == std::string::npos ? 1 : std::strtod(name.c_str() + name.find('[') + 1, nullptr);
  for (const VariableName& row : m.def.grammar.symbols)
    if (row.text == plain) return row.indexed ? row.number + index - row.first_index : row.number;
  return -1;
}

void add_variables(Emitter& m, FinalState& ending, const std::vector<std::string>& watch) {
  const auto add = [&](int n) {
    double value = 0;
    if (macro_b_of(m).variables.known(n, value) && !is_vacant(value)) ending.variables.emplace_back("#" + std::to_string(n), value);
  };
  for (int n = 1; n <= static_cast<int>(max_locals); ++n) add(n);
  for (int n = first_common; n <= last_common; ++n) add(n);
  for (const auto& [n, value] : macro_b_of(m).variables.all_further())
    if (!is_vacant(value)) ending.variables.emplace_back("#" + std::to_string(n), value);
  for (const std::string& name : watch) {
    const auto same = [&](const auto& v) { return v.first == name; };
    if (std::any_of(ending.variables.begin(), ending.variables.end(), same) || name.size() < 2) continue;
    const double number = name[1] == '_' ? number_of_symbol(m, name.substr(2)) : std::strtod(name.c_str() + 1, nullptr);
    const auto read = read_variable(m, number, {});
    if (read && !is_vacant(*read)) ending.variables.emplace_back(name, *read);
    else ending.watched_unset.emplace_back(name, true);
  }
}

/// Macro calls, and interrupts by the parameter, have local variables of their own (nct 23.1.3).
std::vector<LocalVariables> MacroState::local_variables(const std::vector<CallFrame>& calls, const ControlDef&) const {
  std::vector<std::size_t> depths = {0};
  for (std::size_t i = 0; i < calls.size(); ++i)
    if (calls[i].kind == CallFrame::Kind::macro || calls[i].opened_level) depths.push_back(i + 1);
  std::vector<LocalVariables> all;
  for (std::size_t level = 0; level < std::min(depths.size(), variables.levels.size()); ++level) {
    all.push_back({depths[level], {}});
    for (std::size_t n = 1; n <= max_locals; ++n)
      if (const double value = variables.levels[level][n]; !is_vacant(value))
        all.back().values.emplace_back("#" + std::to_string(n), value);
  }
  return all;
}

}  // namespace kadr::macro_b
