// Computes hole positions on a circle, an arc or a line (spec/haas 8.5).

#include "control/fanuc/drilling/pattern.h"

#include "base/code_literals.h"
#include "control/emitter.h"
#include "control/fanuc/fanuc.h"

namespace kadr::fanuc {

Result<std::vector<Vec2>> pattern_points(const BlockContext& m, const Call& call) {
  constexpr std::uint32_t max_points = 10'000;
  const std::int32_t code = call.row->tenth;
  for (const char letter : {'I', 'L', code == 71_g ? 'K' : 'I'})
    if (!m.has(letter)) return fail(alarm(AlarmId::word_missing, call.where, letter, call.row->code));
  const auto count = m.whole('L', 1, max_points);
  if (!count) return fail(count.error());
  const double reach = m.length_value('I'), first = m.has('J') ? m.value('J') : 0;
  const double turn = reach < 0 ? -1 : 1;  // if the radius I is negative, the holes of the pattern follow one another clockwise
  const double step = code == 71_g ? m.value('K') : turn * 360.0 / *count;
  const PlaneAxes& plane = m.modal.axes;
  const Vec2 here{m.position.programmed[plane.first], m.position.programmed[plane.second]};
  std::vector<Vec2> points;
  for (std::uint32_t i = 0; i < *count; ++i) {
    const SinCos at = sincos_deg(code == 72_g ? first : first + step * i);
    const double radius = code == 72_g ? reach * i : std::fabs(reach);
    points.push_back(here + Vec2{radius * at.cos, radius * at.sin});
  }
  return points;
}

}  // namespace kadr::fanuc
