// Plans as a controller with a planner of a few straight blocks. Used by motion/look_ahead/look_ahead, tested by
// tests/motion/block_window_test.cpp against a second implementation that follows planner.c step by step.

#include "motion/look_ahead/block_window.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kadr {
namespace {

constexpr double straight_cosine = 0.999999;  // planner.c: beyond it a junction is straight, or reverses
constexpr double shortest = 1e-9;             // mm; a shorter block moves no axis by a step

/// Returns true for actions before which Grbl waits until the axes are at rest (protocol_buffer_synchronize): everything except modes.
/// INFERRED for a speed: spindle_sync also waits for a mere S.
bool waits(const Action& action) {
  return !std::holds_alternative<FrameChange>(action.what) && !std::holds_alternative<ToolSelect>(action.what) &&
         !std::holds_alternative<Message>(action.what);
}

/// Returns the number of chords of an arc: mc_arc() of motion_control.c.
int chords_of(const Curve& curve, const Motion& motion, const Axes& from, double tolerance) {
  const double dx = from[motion.first] - motion.center.x, dy = from[motion.second] - motion.center.y;
  const double radius = std::sqrt(dx * dx + dy * dy);
  if (!curve.arc() || !(radius > tolerance) || tolerance <= 0) return 1;
  const double angle = 2 * M_PI * motion.turns;
  return std::max(1, static_cast<int>(std::fabs(0.5 * angle * radius) / std::sqrt(tolerance * (2 * radius - tolerance))));
}

/// Returns the time of a block: up to at most its nominal speed, and down to `exit`.
struct Profile {
  double seconds, top;
};
Profile profile_of(const BlockWindow::Block& block, double entry, double exit) {
  const double a = block.acceleration, entry_sq = entry * entry, exit_sq = exit * exit, nominal_sq = block.nominal * block.nominal;
  if (std::isinf(a)) return {block.length / block.nominal, block.nominal};
  const double peak_sq = (2 * a * block.length + entry_sq + exit_sq) / 2;
  const double top = std::max(std::sqrt(std::min(peak_sq, nominal_sq)), std::max(entry, exit));
  const double ramps = (2 * top * top - entry_sq - exit_sq) / (2 * a);
  return {(2 * top - entry - exit) / a + std::max(0.0, block.length - ramps) / top, top};
}

}  // namespace

BlockWindow::BlockWindow(const AxisRoles& roles, const SpeedRules& rules, const Axes& rates, Sink sink)
    : roles_(roles), rules_(rules), rates_(rates), sink_(std::move(sink)) {}

void BlockWindow::resume_from(const Memory& memory) {
  held_ = memory.held;
  blocks_ = memory.blocks;
  entry_ = memory.entry;
}

void BlockWindow::consume(const Step& step) {
  if (const Motion* const m = step.motion()) return motion(step, *m);
  if (waits(step.action)) rest();
  if (held_.empty()) sink_(step, 0);
  else held_.push_back({KeptStep(step)});
}

void BlockWindow::motion(const Step& step, const Motion& motion) {
  const bool waits = motion.kind == MotionKind::probe || motion.kind == MotionKind::home;
  if (waits) rest();
  const double seconds = step.time.seconds;
  held_.push_back({KeptStep(step), -seconds, 0});
  const Curve& curve = step.curve();
  const double length = curve.length();
  if (length > shortest && seconds > 0) {
    held_.back().kept.time.exact = true;
    held_.back().kept.time.seconds = 0;
    held_.back().kept.time.feed_most = 0;
    const int chords = chords_of(curve, motion, step.from.work, rules_.blocks->arc_tolerance);
    // The commanded feed, before the limits of the axes: each chord has its own limits.
    const double speed = step.time.feed > 0 ? step.time.feed / seconds_per_minute : length / seconds;
    Axes at = step.from.work;
    for (int i = 1; i <= chords; ++i) {
      const Axes next = i < chords ? curve.at(double(i) / chords) : motion.to;
      Axes travel{};
      for (std::size_t a = 0; a < roles_.count; ++a) travel[a] = next[a] - at[a];
      add(travel, speed, motion.kind == MotionKind::rapid);
      at = next;
    }
  } else {
    held_.back().longer = 0;
  }
  release();
  if (waits) rest();
}

/// Adds a block (plan_buffer_line of planner.c).
void BlockWindow::add(const Axes& travel, double speed, bool rapid) {
  Block block;
  double square = 0;
  for (std::size_t a = 0; a < roles_.count; ++a) square += travel[a] * travel[a];
  block.length = std::sqrt(square);
  if (block.length < shortest) return;
  if (blocks_.size() >= rules_.blocks->window) plan_oldest();  // the line waits until the oldest block is executed
  for (std::size_t a = 0; a < roles_.count; ++a) block.direction[a] = travel[a] / block.length;
  const double fastest = axis_limit(rates_, block.direction);
  block.nominal = rapid ? fastest : std::min(speed, fastest);
  block.acceleration = axis_limit(rules_.acceleration, block.direction);
  if (!blocks_.empty()) {
    const double slower = std::min(block.nominal, blocks_.back().nominal);
    block.max_entry_sq = std::min(slower * slower, junction_sq(blocks_.back(), block));
  }
  blocks_.push_back(block);
  ++held_.back().blocks;
}

/// Returns the greatest squared speed at a junction: the speed on an arc that touches both blocks and passes the corner at the distance
/// `junction_deviation`, within the acceleration of the axes in the direction of the corner.
double BlockWindow::junction_sq(const Block& before, const Block& after) const {
  double cosine = 0;  // of the angle between the blocks: −1 straight on, 1 back
  Axes turn{};
  for (std::size_t a = 0; a < roles_.count; ++a) {
    cosine -= before.direction[a] * after.direction[a];
    turn[a] = after.direction[a] - before.direction[a];
  }
  if (cosine > straight_cosine) return 0;
  if (cosine < -straight_cosine) return unlimited;
  double size = 0;
  for (std::size_t a = 0; a < roles_.count; ++a) size += turn[a] * turn[a];
  for (double& part : turn) part /= std::sqrt(size);
  const double sine_of_half = std::sqrt(0.5 * (1 - cosine));
  return axis_limit(rules_.acceleration, turn) * rules_.blocks->junction_deviation * sine_of_half / (1 - sine_of_half);
}

/// Returns min most_i/|direction_i| (limit_value_by_axis_maximum of nuts_bolts.c).
double BlockWindow::axis_limit(const Axes& most, const Axes& direction) const {
  double limit = unlimited;
  for (std::size_t a = 0; a < roles_.count; ++a)
    if (direction[a] != 0) limit = std::min(limit, most[a] / std::fabs(direction[a]));
  return limit;
}

/// Gives the oldest block its time: backward from rest at the end of the newest block, then forward over the oldest one (planner.c,
/// planner_recalculate).
void BlockWindow::plan_oldest() {
  double exit_sq = 0;
  for (std::size_t i = blocks_.size() - 1; i > 0; --i)
    exit_sq = std::min(blocks_[i].max_entry_sq, exit_sq + 2 * blocks_[i].acceleration * blocks_[i].length);
  const Block block = blocks_.front();
  const double reached_sq = entry_ * entry_ + 2 * block.acceleration * block.length;
  const double exit = std::sqrt(std::min(exit_sq, reached_sq));
  const Profile profile = profile_of(block, entry_, exit);
  blocks_.pop_front();
  entry_ = exit;
  auto held = std::find_if(held_.begin(), held_.end(), [](const Held& one) { return one.blocks > 0; });
  MotionTime& time = held->kept.time;
  time.seconds += profile.seconds;
  time.feed_most = std::max(time.feed_most, profile.top * seconds_per_minute);
  time.feed_end = exit * seconds_per_minute;
  held->longer += profile.seconds;
  --held->blocks;
}

void BlockWindow::rest() {
  while (!blocks_.empty()) plan_oldest();
  entry_ = 0;
  release();
}

/// Emits the steps before the first motion that has blocks in the window.
void BlockWindow::release() {
  while (!held_.empty() && held_.front().blocks == 0) {
    sink_(held_.front().kept.step(), held_.front().longer);
    held_.pop_front();
  }
}

}  // namespace kadr
