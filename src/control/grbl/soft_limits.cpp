// Checks the soft limits if the setting $20 is on (spec/grbl 8; limits_soft_check of limits.c, which mc_line calls for each segment of
// mc_arc).

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "base/code_literals.h"
#include "control/block_context.h"
#include "control/grbl/grbl.h"

namespace kadr::grbl {
namespace {

Status point_within(const BlockContext& m, const Grbl& control, const Axes& machine, bool is_jog) {
  const Settings& s = control.state.settings;
  for (std::size_t a = 0; a < axes; ++a) {
    if (machine[a] >= -s.travel[a] && machine[a] <= 0) continue;
    const AlarmId id = is_jog ? AlarmId::jog_target : AlarmId::limit_exceeded;
    return fail(alarm(id, m.block->where, std::string_view(m.axis_names[a]), machine[a], machine[a] > 0 ? 0.0 : -s.travel[a]));
  }
  return {};
}

}  // namespace

Status within_travel(const BlockContext& m, const Grbl& control, const CheckedBlock& block, bool is_jog) {
  const bool by_stored = block.non_modal == 280 || block.non_modal == 300;  // G28 and G30 end at the stored position
  if (!control.state.settings.soft_limits || !(block.moves || by_stored || (is_jog && block.has_axis))) return {};
  const auto system = block.system < 0 ? std::size_t{m.modal.work_zero} : static_cast<std::size_t>((block.system - 530) / 10);
  Axes zero{}, end{};
  for (std::size_t a = 0; a < axes; ++a) {
    if (block.non_modal != 530) zero[a] = m.tables.zeros[system][a] + m.set_position[a] + (a == 2 ? control.state.length : 0);
    end[a] = block.target[a] + zero[a];
  }
  if (block.arc) {
    const PlaneAxes plane = axes_of(block.plane == 17_g ? Plane::xy : block.plane == 18_g ? Plane::zx : Plane::yz);
    const Vec2 start{block.start[plane.first], block.start[plane.second]};
    const Vec2 from = start - block.arc->center;
    const int segments = block.segments;
    const double step = (block.motion == 2_g ? -2 : 2) * std::numbers::pi * block.arc->turns / segments;
    for (int i = 1; i < segments; ++i) {
      Axes at = end;
      const double c = std::cos(i * step), s = std::sin(i * step);
      at[plane.first] = block.arc->center.x + from.x * c - from.y * s + zero[plane.first];
      at[plane.second] = block.arc->center.y + from.x * s + from.y * c + zero[plane.second];
      const double part = double(i) / segments;
      const std::size_t across = 3 - plane.first - plane.second;
      at[across] = block.start[across] * (1 - part) + block.target[across] * part + zero[across];
      KADR_TRY(point_within(m, control, at, is_jog));
    }
  }
  if (block.has_axis) KADR_TRY(point_within(m, control, end, is_jog));
  if (!by_stored) return {};
  const Axes& stored = m.tables.reference[block.non_modal == 280 ? 1 : 2];
  for (std::size_t a = 0; a < axes; ++a)
    if (!block.has_axis || m.has(m.letters.axis_letter[a])) end[a] = stored[a];
  return point_within(m, control, end, is_jog);
}

}  // namespace kadr::grbl
