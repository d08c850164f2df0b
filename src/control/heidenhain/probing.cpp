// Cycles of the touch probe that the probe of the set-up can execute: 0, 1, 410 to 413, 417, 419, 421, 422, 427 (spec/heidenhain 12.14).
// The probe table is not known: a touch is looked for along `probe_travel` from the start, at `probe_feed` (INFERRED). Used by
// control/heidenhain.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/tolerance.h"
#include "control/functions/probe_unstated.h"
#include "control/heidenhain/fitted_circle.h"
#include "control/heidenhain/heidenhain.h"

namespace kadr::heidenhain {
namespace {

constexpr double probe_travel = 10;  // DIST of the probe table, mm
constexpr double probe_feed = 300;   // F of the probe table, mm/min

using Steps = std::vector<Probing::Step>;

class ProbePlan {
 public:
  ProbePlan(const BlockContext& m, Steps& steps) : m_(m), steps_(steps), now_(m.position.programmed) {}

  void height(double to) { go(m_.modal.axes.normal, to); }
  void plane(Vec2 to) {
    now_[m_.modal.axes.first] = to.x;
    now_[m_.modal.axes.second] = to.y;
    steps_.push_back({false, now_, mask_of(m_.modal.axes)});
  }
  void all(const Axes& to, AxisMask named) {
    for (std::size_t a = 0; a < m_.axis_count; ++a)
      if ((named >> a & 1U) != 0) now_[a] = to[a];
    steps_.push_back({false, now_, named});
  }
  /// Looks for the surface in the plane, and goes back to where the look began.
  void touch(Vec2 way) {
    Axes to = now_;
    to[m_.modal.axes.first] += way.x;
    to[m_.modal.axes.second] += way.y;
    steps_.push_back({true, to, mask_of(m_.modal.axes)});
    steps_.push_back({false, now_, mask_of(m_.modal.axes)});
  }
  void touch_axis(std::size_t axis, double by) {
    Axes to = now_;
    to[axis] += by;
    steps_.push_back({true, to, AxisMask{1} << axis});
    steps_.push_back({false, now_, AxisMask{1} << axis});
  }

 private:
  void go(std::size_t axis, double to) {
    now_[axis] = to;
    steps_.push_back({false, now_, AxisMask{1} << axis});
  }

  const BlockContext& m_;
  Steps& steps_;
  Axes now_;
};

bool is_circle(int cycle) { return cycle == 412 || cycle == 413 || cycle == 421 || cycle == 422; }
bool is_outside(int cycle) { return cycle == 411 || cycle == 413 || cycle == 422; }

}  // namespace

/// TCH PROBE: notes the words of the older form, or plans the motions of a cycle.
Status Heidenhain::define_probe(Interpreter& m, const KlartextBlock& block) {
  const int cycle = block.number;
  const Span where = m.block->where;
  constexpr int known[] = {0, 1, 410, 411, 412, 413, 417, 419, 421, 422, 427};
  if (std::find(std::begin(known), std::end(known), cycle) == std::end(known)) {
    const std::string name = "TCH PROBE " + std::to_string(cycle);
    return fail(alarm(AlarmId::not_available, where, std::string_view(name)));
  }
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, where, "TCH PROBE"));
  Probing made;
  made.cycle = cycle;
  ProbePlan plan(m, made.steps);
  const double unit = m.unit_scale(), ball = tool_radius(m);
  const PlaneAxes axes = m.modal.axes;
  if (cycle <= 1) {
    if (block.part == 0) {
      memory.probe_parameter = block.target.index;
      memory.probe_axis = -1;
      for (std::size_t a = 0; a < m.axis_count && cycle == 0; ++a)
        if (m.axis_names[a] == block.name.substr(0, 1)) memory.probe_axis = static_cast<int>(a);
      memory.probe_sense = block.name.ends_with('-') ? -1 : 1;
      return {};
    }
    if (cycle == 1 && block.part == 1) {
      memory.probe_angle = 0;
      if (const KlartextWord* const word = block.find("ANGLE:")) {
        const auto angle = value(m, block, *word);
        if (!angle) return fail(angle.error());
        memory.probe_angle = *angle;
      }
      memory.probe_axis = -1;
      return {};
    }
    Axes to = m.position.programmed;
    AxisMask named = 0;
    for (const KlartextWord& word : block.words)
      for (std::size_t a = 0; a < m.axis_count; ++a)
        if (word.name == word_name(m.axis_names[a])) {
          const auto read = value(m, block, word);
          if (!read) return fail(read.error());
          to[a] = (word.incremental ? to[a] : 0) + *read * unit;
          named |= AxisMask{1} << a;
        }
    plan.all(to, named);
    if (cycle == 0 && memory.probe_axis >= 0)
      plan.touch_axis(static_cast<std::size_t>(memory.probe_axis), memory.probe_sense * probe_travel);
    else plan.touch(rotated(Vec2{probe_travel, 0}, memory.probe_angle));
    memory.probing = std::move(made);
    return {};
  }
  KADR_TRY(take_parameters(m, block));
  const auto q = [&](std::size_t index) { return memory.q[index] * unit; };
  const double high = q(260), low = q(261), beside = q(320) + ball;
  plan.height(std::max(high, m.position.programmed[axes.normal]));
  if (is_circle(cycle) || cycle == 410 || cycle == 411) {
    const Vec2 middle{q(321), q(322)};
    const bool outside = is_outside(cycle), circle = is_circle(cycle), stays = memory.q[301] == 0 && !outside;
    const double step = circle ? (memory.q[247] != 0 ? memory.q[247] : 90) : 90, start = circle ? memory.q[325] : 0;
    for (int i = 0; i < 4; ++i) {
      const double half = (circle ? q(262) : i % 2 == 0 ? q(323) : q(324)) / 2;
      const Vec2 way = rotated(Vec2{1, 0}, start + i * step);
      plan.plane(middle + (outside ? half + beside : std::max(0.0, half - beside)) * way);
      plan.height(low);
      plan.touch((outside ? -1 : 1) * (probe_travel + beside) * way);
      if (!stays || i == 3) plan.height(high);
    }
    plan.plane(middle);
  } else {
    const int axis = cycle == 417 ? 3 : static_cast<int>(memory.q[272]);
    if (axis < 1 || axis > 3) return fail(alarm(AlarmId::value_out_of_range, where, "Q272", memory.q[272]));
    const std::size_t at = axis == 1 ? axes.first : axis == 2 ? axes.second : axes.normal;
    const double sense = cycle == 417 ? -1 : memory.q[267] < 0 ? -1 : 1;
    Vec2 point{q(263), q(264)};
    if (axis == 1) point.x -= sense * beside;
    if (axis == 2) point.y -= sense * beside;
    plan.plane(point);
    plan.height(cycle == 417 ? q(294) + q(320) : axis == 3 ? low - sense * q(320) : low);
    plan.touch_axis(at, sense * (probe_travel + beside));
    plan.height(high);
  }
  memory.probing = std::move(made);
  return {};
}

/// Executes the next motion of the measuring cycle, or its end.
Status Heidenhain::continue_probing(Interpreter& m) {
  Probing& probing = *memory.probing;
  if (probing.at >= probing.steps.size()) return finish_probing(m);
  const Probing::Step step = probing.steps[probing.at++];
  if (!step.touches) return m.straight(MotionKind::rapid, step.to, step.named);
  const double feed = m.modal.feed;
  const bool known = m.modal.feed_known;
  const FeedMode mode = m.modal.feed_mode;
  m.modal.feed = probe_feed;
  m.modal.feed_known = true;
  m.modal.feed_mode = FeedMode::per_minute;
  const Status moved = m.straight(MotionKind::probe, step.to, step.named);
  m.modal.feed = feed;
  m.modal.feed_known = known;
  m.modal.feed_mode = mode;
  if (!moved) return moved;
  m.needs_probe = true;
  m.probe_where = m.block->where;
  return {};
}

Status Heidenhain::accept_answer(Emitter& m, const ProbeAnswer& answer) {
  m.needs_probe = false;
  for (std::size_t a = 0; a < m.axis_count; ++a) m.position.work[a] = answer.at[a];
  m.position.machine = m.frames.machine_of(m.position.work);
  m.position.programmed = m.transform.to_programmed(m.position.work);
  if (!made_contact(m, answer)) {
    memory.probing.reset();
    return fail(alarm(AlarmId::probe_no_contact, m.probe_where));
  }
  if (memory.probing) memory.probing->touched.push_back(m.position.programmed);
  return {};
}

/// Computes the results, Q115 to Q117 or Q150 to Q160, and sets the datum if the cycle says so.
Status Heidenhain::finish_probing(Interpreter& m) {
  const Probing done = *std::move(memory.probing);
  memory.probing.reset();
  if (done.touched.empty()) return {};
  const PlaneAxes axes = m.modal.axes;
  const double ball = tool_radius(m), unit = m.unit_scale();
  const auto set = [&](std::size_t index, double to) { memory.q[index] = to / unit; };
  const auto new_datum = [&](std::size_t axis, double measured, double nominal) { memory.shift[axis] += measured - nominal; };
  if (done.cycle <= 1) {
    Axes at = done.touched.front();
    for (const std::size_t a : {0U, 1U, 2U}) set(115 + a, at[a]);
    if (done.cycle == 1 || memory.probe_axis < 0) return {};
    const auto axis = static_cast<std::size_t>(memory.probe_axis);
    const double surface = at[axis] + (axis == axes.normal ? 0 : memory.probe_sense * ball);
    if (memory.probe_parameter >= 0) set(static_cast<std::size_t>(memory.probe_parameter), surface);
    return {};
  }
  if (done.touched.size() == 4) {
    const auto way = [&](std::size_t i) { return in_plane(done.touched[i], axes); };
    const double sense = is_outside(done.cycle) ? -2 : 2;
    Vec2 middle{(way(0).x + way(2).x) / 2, (way(1).y + way(3).y) / 2};
    if (is_circle(done.cycle)) {
      const auto circle = fitted_circle({way(0), way(1), way(2), way(3)});
      if (!circle) return fail(alarm(AlarmId::plane_degenerate, m.block->where));
      middle = circle->centre;
      set(153, 2 * circle->radius + sense * ball);
    } else {
      set(154, std::fabs(way(2).x - way(0).x) + sense * ball);
      set(155, std::fabs(way(3).y - way(1).y) + sense * ball);
    }
    set(151, middle.x);
    set(152, middle.y);
    if (done.cycle >= 420) return {};
    new_datum(axes.first, middle.x, memory.q[331] * unit);
    new_datum(axes.second, middle.y, memory.q[332] * unit);
    return set_frame(m);
  }
  const std::size_t index = done.cycle == 417 ? 3 : static_cast<std::size_t>(memory.q[272]);
  const std::size_t axis = index == 1 ? axes.first : index == 2 ? axes.second : axes.normal;
  const double sense = done.cycle == 417 ? -1 : memory.q[267] < 0 ? -1 : 1;
  const double surface = done.touched.front()[axis] + (axis == axes.normal ? 0 : sense * ball);
  set(160, surface);
  if (done.cycle == 427) return {};
  new_datum(axis, surface, memory.q[333] * unit);
  return set_frame(m);
}

}  // namespace kadr::heidenhain
