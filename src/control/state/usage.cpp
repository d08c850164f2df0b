// Records which data of a set-up a program uses: offsets, work offsets,
// correctors, tools, variables, switches. Used by the rest of control.

#include "control/state/usage.h"

#include <algorithm>
#include <cmath>

#include "control/block_context.h"

namespace kadr {

void ProgramUse::note(UseKind kind, std::uint32_t number, const Origin& origin, bool zero) {
  constexpr std::uint32_t most = 100'000'000;  // greater numbers are not recorded: T has at most eight digits
  if (origin.line == 0 || number > most) return;
  if (kind == UseKind::tool) called_ = number;
  const std::uint32_t tool = in_spindle_ != 0 ? in_spindle_ : called_;
  // true: the first use by each tool is recorded, because several tools may use one offset
  const bool of_tool = kind == UseKind::length || kind == UseKind::radius;
  const auto is_same_use = [&](const Use& use) { return use.kind == kind && use.number == number && (!of_tool || use.tool == tool); };
  std::vector<bool>& seen = seen_[static_cast<std::size_t>(kind)];
  // Numbers below this limit have bits in seen_; greater numbers are rare and are searched in the list.
  constexpr std::size_t tabled = 65'536;
  if (number < tabled) {
    if (number < seen.size() && seen[number] && (!of_tool || std::any_of(all_.begin(), all_.end(), is_same_use))) return;
    if (number >= seen.size()) seen.resize(number + 1);
    seen[number] = true;
  } else if (std::any_of(all_.begin(), all_.end(), is_same_use)) {
    return;
  }
  all_.push_back({kind, number, origin, zero, tool});
}

void ProgramUse::pass(const Origin& origin) {
  if (origin.file != 0) return;
  if (origin.line >= lines_.size()) lines_.resize(origin.line + 1);
  lines_[origin.line] = true;
}

void note_work_offset(BlockContext& m, std::uint32_t row) {
  if (row == 0) return;  // 0 means no work offset, so there is no use to record
  // At the end of the program the control itself resets the work system; this is not a use by the program.
  if (!m.has_code({Function::work_zero, Function::fixture, Function::work_system, Function::work_system_extended, Function::table_system,
                   Function::zero_shift}))
    return;
  bool zero = true;
  const std::uint32_t first = m.variables.first(VariableKind::fixture);
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    if (first == 0) zero = zero && row < m.tables.zeros.size() && m.tables.zeros[row][a] == 0;
    else if (a < 6) zero = zero && m.variables.raw(m.variables.first(VariableKind::fixture, row - 1) + static_cast<std::uint32_t>(a)) == 0;
  }
  m.use.note(UseKind::work_zero, row, m.origin, zero);
}

void note_read(BlockContext& m, double number) {
  const double nearest = std::round(number);
  if (!(nearest >= 1) || nearest > 1e6) return;
  const auto n = static_cast<std::uint32_t>(nearest);
  if (m.macro_variables != nullptr) {
    const bool is_common = n >= static_cast<std::uint32_t>(first_common) && n <= static_cast<std::uint32_t>(last_common);
    if (is_common && is_vacant(m.macro_variables->common(static_cast<int>(n)))) m.use.note(UseKind::variable, n, m.origin, true);
    return;
  }
  if (n <= m.variables.highest() && !m.variables.is_set(n) && !m.variables.is_system(n)) m.use.note(UseKind::variable, n, m.origin, true);
}

void note_read_parameter(BlockContext& m, int index) {
  if (!m.variables.parameter_set(index)) m.use.note(UseKind::parameter, static_cast<std::uint32_t>(index), m.origin, true);
}

}  // namespace kadr
