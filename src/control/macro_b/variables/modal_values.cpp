// System variables #4001 … #4530: modal codes and words (spec/nct/23 23.1.14). Used by control/macro_b/variables/system_variables.

#include "control/macro_b/variables/modal_values.h"

#include <string>

#include "control/block_context.h"
#include "control/macro_b/macro_b.h"

namespace kadr::macro_b {
namespace {

constexpr int family_step = 1000;
constexpr int extended_zero = 187;  // code that stands for word P of G54.1 in place of a letter

}  // namespace

double modal_group(const BlockContext& m, int family, std::uint32_t group) {
  const Interrupted& interrupted = macro_b_of(m).interrupted;
  const Modal& modal = family == 2 && interrupted.active ? interrupted.modal : m.modal;
  const std::string name = std::to_string(group);
  for (std::size_t g = 1; g < m.def.groups.size(); ++g) {
    if (m.def.groups[g].name != name || modal.rows[g] < 0) continue;
    const std::int32_t tenth = m.def.codes[static_cast<std::size_t>(modal.rows[g])].tenth;
    return tenth % 10 * 100 + tenth / 10;
  }
  return 0;
}

double modal_word(const BlockContext& m, int arg) {
  const int family = arg / family_step;
  const Interrupted& interrupted = macro_b_of(m).interrupted;
  const ModalWords& w = family == 2 && interrupted.active ? interrupted.words : macro_b_of(m).state.words;
  switch (arg % family_step) {
    case 'A': return w.aux[0];
    case 'B': return w.aux[1];
    case 'C': return w.aux[2];
    case 'D': return w.d;
    case 'E': return w.e;
    case 'F': return w.f;
    case 'H': return w.h;
    case 'M': return w.m;
    case 'N': return w.n;
    case 'O': return w.o;
    case 'S': return w.s;
    case 'T': return w.t;
    case extended_zero: return m.modal.work_zero > basic_systems ? m.modal.work_zero - static_cast<double>(basic_systems) : 0.0;
    default: return 0;
  }
}

}  // namespace kadr::macro_b
