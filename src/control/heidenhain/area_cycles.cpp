// What the milling cycles have in common: levels, feeds, allowances (spec/heidenhain 12.1, 12.10). Used by control/heidenhain.

#include "control/heidenhain/area_cycles.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/tolerance.h"

namespace kadr::heidenhain {

bool is_area_cycle(int cycle) {
  constexpr int all[] = {3, 4, 5, 204, 210, 211, 212, 213, 214, 215, 230, 231, 232, 251, 252, 253, 254, 256, 257, 262, 263, 264, 265, 267};
  return std::find(std::begin(all), std::end(all), cycle) != std::end(all);
}

bool has_own_place(int cycle) { return (cycle >= 210 && cycle <= 215) || (cycle >= 230 && cycle <= 232); }

/// Returns an empty path that begins where the last step ends.
MillPath AreaMaker::new_path() const {
  double height = m_.position.programmed[plane_.normal];
  for (const CycleStep& step : steps_)
    if ((step.named >> plane_.normal & 1U) != 0) height = step.to[plane_.normal];
  return {steps_, plane_, at_, height};
}

Status AreaMaker::run(int cycle) {
  if (m_.modal.radius_side != 0)
    return fail(alarm(AlarmId::compensation_active, where_, std::string_view("CYCL DEF " + std::to_string(cycle))));
  if (m_.transform.leaves(plane_) || m_.transform.distorts(plane_))
    return fail(alarm(AlarmId::not_together, where_, "CYCL DEF 26", std::string_view("CYCL DEF " + std::to_string(cycle))));
  switch (cycle) {
    case 3:
    case 4:
    case 5: return old_pocket(cycle);
    case 204: return back_boring();
    case 210:
    case 211:
    case 212:
    case 214: return old_finishing_pocket(cycle);
    case 213:
    case 215:
    case 256:
    case 257: return stud(cycle);
    case 230: return multipass();
    case 231: return ruled_surface();
    case 232: return face();
    case 251:
    case 252:
    case 253:
    case 254: return new_pocket(cycle);
    default: return thread(cycle);
  }
}

/// Q200, Q201, Q203, Q204.
void AreaMaker::take_levels() {
  surface_ = length_of(203) + raised_;
  clearance_ = surface_ + length_of(200);
  second_ = surface_ + length_of(204);
  bottom_ = surface_ + length_of(201);
}

/// For a feed of 0, which is the feed in force.
Status AreaMaker::needs_feed() const { return m_.modal.feed_known ? Status() : Status(fail(alarm(AlarmId::feed_missing, where_))); }

Status AreaMaker::take_common() {
  const auto cutter = own_.cutter_radius(m_, where_);
  if (!cutter) return fail(cutter.error());
  radius_ = *cutter;
  take_levels();
  infeed_ = std::fabs(length_of(202));
  finish_infeed_ = given(338) ? std::fabs(length_of(338)) : 0;
  feed_ = feed_of(207);
  plunge_feed_ = feed_of(206);
  finish_feed_ = given(385) && q(385) != 0 ? feed_of(385) : feed_;
  if (feed_ == 0 || plunge_feed_ == 0) KADR_TRY(needs_feed());
  side_allowance_ = given(368) ? std::max(0.0, length_of(368)) : 0;
  floor_allowance_ = given(369) ? std::max(0.0, length_of(369)) : 0;
  const double factor = given(370) && q(370) > 0 ? q(370) : 1;
  if (factor > 2) return fail(alarm(AlarmId::value_out_of_range, where_, "Q370", factor));
  width_ = std::min(factor, 1.7) * radius_;  // beyond it, corners of the rings would leave something
  const bool climb = !given(351) || q(351) >= 0;
  clockwise_ = climb == (m_.modal.spindle == SpindleDir::ccw);
  operation_ = given(215) ? static_cast<int>(q(215)) : 0;
  if (operation_ < 0 || operation_ > 2) return fail(alarm(AlarmId::not_available, where_, "Q215"));
  return {};
}

/// The levels from the surface to the bottom, each `infeed` below the one before it, the last one at the bottom.
std::vector<double> AreaMaker::levels_of(double surface, double bottom, double infeed) {
  std::vector<double> all;
  constexpr std::size_t most = 10'000;
  double at = surface;
  while (at > bottom + tol::same_point && all.size() < most) {
    at = infeed > 0 ? std::max(bottom, at - infeed) : bottom;
    if (at - bottom < tol::same_point) at = bottom;
    all.push_back(at);
  }
  return all;
}

void AreaMaker::dwell(double seconds) {
  if (!(seconds > 0)) return;
  CycleStep& step = steps_.emplace_back();
  step.kind = CycleStep::Kind::dwell;
  step.value = seconds;
}

void AreaMaker::spindle(SpindleDir dir, double angle) {
  CycleStep& step = steps_.emplace_back();
  step.kind = CycleStep::Kind::spindle;
  step.dir = dir;
  step.angle = angle;
}

}  // namespace kadr::heidenhain
