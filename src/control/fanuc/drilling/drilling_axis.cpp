// The axis along which a drilling cycle drills, and the word that gives the bottom of the hole (spec/nct/18.0, spec/fanuc 10.1,
// spec/haas-st 7). Used by control/fanuc/drilling/drilling; tested by tests/control/fanuc/drilling_test.cpp.

#include "control/fanuc/drilling/drilling_axis.h"

#include "control/block_context.h"
#include "control/fanuc/drilling/drilling.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/lathe/lathe.h"

namespace kadr::fanuc {
namespace {

/// Returns the drilling direction of a cycle for the plane in force as a number: 1 for X, 2 for Y, 3 for Z.
int drilling_direction(const BlockContext& m, const CodeRow& cycle) {
  if (m.def.behaviour.lathe != Lathe::none) return drills_on_side(cycle) ? 1 : 3;         // spec/haas-st 7
  if (m.def.behaviour.tool_along_third && !fanuc_of(m).settings.drills_across) return 3;  // spec/fanuc 10.1: drilling is always along Z
  return m.modal.plane == Plane::zx ? 2 : m.modal.plane == Plane::yz ? 1 : 3;
}

bool has_direction(const BlockContext& m, std::size_t axis, int direction) {
  const int role = fanuc_of(m).settings.axes[axis].role;
  return role == direction || role == direction + 4;
}

}  // namespace

Result<const Word*> bottom_word(const BlockContext& m, const CodeRow& cycle) {
  const int direction = drilling_direction(m, cycle);
  const Word* found = nullptr;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const std::size_t axis = m.def.address(w.address).axis;
    if (!has_direction(m, axis, direction)) continue;
    if (found != nullptr && m.def.address(found->address).axis == axis) return fail(alarm(AlarmId::address_twice, w.where, w.address));
    if (found != nullptr) return fail(alarm(AlarmId::not_together, w.where, m.block->text_of(found->where), m.block->text_of(w.where)));
    found = &w;
  }
  return found;
}

int drilling_axis(const BlockContext& m, const CodeRow& cycle, const Word* bottom) {
  if (bottom != nullptr) return m.def.address(bottom->address).axis;
  const int direction = drilling_direction(m, cycle);
  if (const std::size_t axis = fanuc_of(m).state.drilling.axis; drilling_on(m) && has_direction(m, axis, direction))
    return static_cast<int>(axis);
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (fanuc_of(m).settings.axes[a].role == direction) return static_cast<int>(a);
  return -1;
}

}  // namespace kadr::fanuc
