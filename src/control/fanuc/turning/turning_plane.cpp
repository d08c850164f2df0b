// Motions and words of the turning cycles in their plane. Used by turning.cpp and the files of the cycles.

#include "control/fanuc/turning/turning_plane.h"

#include "base/tolerance.h"
#include "control/emitter.h"
#include "control/fanuc/fanuc.h"
#include "control/macro_b/dialect/blocks.h"

namespace kadr::fanuc {
namespace {

std::size_t axis_of(const BlockContext& m, std::size_t which) { return which == 0 ? m.modal.axes.first : m.modal.axes.second; }

}  // namespace

std::size_t place_in_plane(const BlockContext& m, const Word& w) {
  const std::size_t axis = m.def.address(w.address).axis;
  return axis == m.modal.axes.first ? 0 : axis == m.modal.axes.second ? 1 : 2;
}

Vec2 plane_point(const BlockContext& m) { return {m.position.programmed[m.modal.axes.first], m.position.programmed[m.modal.axes.second]}; }

Status go(Emitter& m, MotionKind kind, Vec2 to) {
  const PlaneAxes& plane = m.modal.axes;
  const Vec2 here = plane_point(m);
  AxisMask named = 0;
  Axes end = m.position.programmed;
  if (std::fabs(to.x - here.x) > tol::level) named |= 1u << plane.first, end[plane.first] = to.x;
  if (std::fabs(to.y - here.y) > tol::level) named |= 1u << plane.second, end[plane.second] = to.y;
  return named == 0 ? Status() : m.straight(kind, end, named);
}

void end_pass(Emitter& m) {
  if (stops_each_block(m)) m.emit(Stop{false, StopReason::single_block});
}

char letter_of(const BlockContext& m, std::size_t which) { return m.letters.axis_letter[axis_of(m, which)]; }

Result<PlaneTarget> plane_target(BlockContext& m) {
  PlaneTarget target;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address == 0 || (m.letters.axes & letter_bit(w.address)) == 0) continue;
    const std::size_t which = place_in_plane(m, w);
    const bool lathe = m.def.behaviour.lathe != Lathe::none;
    if (which > 1) return fail(alarm(lathe ? AlarmId::turning_axis : AlarmId::illegal_address, w.where, w.written));
    target.given[which] = true;
  }
  Axes to;
  AxisMask named = 0;
  fanuc_of(m).cartesian_block = true;
  const Status read = m.target(to, named);
  fanuc_of(m).cartesian_block = false;
  fanuc_of(m).rolled = 0;
  if (!read) return fail(read.error());
  target.to = {to[m.modal.axes.first], to[m.modal.axes.second]};
  return target;
}

}  // namespace kadr::fanuc
