// SpindleClock computes the angles of the spindles over the time of the axes' motion. Used by motion/least_time/axis_motion; tested by
// tests/motion/spindle_clock_test.cpp.

#include "motion/time/spindle_clock.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/by_kind.h"

namespace kadr {
namespace {

constexpr double full_turn = 360;

}  // namespace

SpindleClock::Turned& SpindleClock::numbered(std::size_t number) {
  while (number >= spindles_.size()) spindles_.emplace_back().turning.most_rpm = most_rpm_;
  return spindles_[number];
}

void SpindleClock::limit(double most_rpm) {
  most_rpm_ = most_rpm;
  for (Turned& spindle : spindles_) spindle.turning.most_rpm = most_rpm;
}

void SpindleClock::start(const SpindleSetup& setup, double override_part, std::size_t number) {
  override_part_ = override_part;
  Turned& spindle = numbered(number);
  spindle.turning.rpm = setup.rpm;
  spindle.turning.reversed = setup.dir == "ccw";
  spindle.angle = setup.angle.value_or(0);
}

void SpindleClock::select_leading(std::size_t number) {
  (void)numbered(number);
  leading_ = number;
}

void SpindleClock::take(const Action& action) {
  by_kind(
      action, [&](const Speed& speed) { numbered(speed.number).turning.take(speed); },
      [&](const SurfaceSpeed& law) { numbered(law.number).turning.surface = law; },
      [&](const Spindle& spindle) {
        Turned& turned = numbered(spindle.number);
        turned.turning.take(spindle);
        if (spindle.dir == SpindleDir::orient) turned.angle = full_turn * std::ceil(turned.angle / full_turn), turned.absolute = true;
        if (spindle.dir == SpindleDir::position) turned.angle += spindle.turn.value_or(0);
      },
      ignores<Motion, Dwell, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, AuxiliaryFunction, Stop, Message, FrameChange, Sync,
              ZoneChange, Couple, Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>);
}

void SpindleClock::couple(double degrees_per_mm) {
  per_mm_ = degrees_per_mm;
  led().turning.on = false;
}

/// Returns the rotation of the leading spindle in a cell. INFERRED: all other spindles rotate without interruption at their commanded
/// speeds.
SpindleTurn SpindleClock::turn(double per_second, const TimeLaw& law) {
  Turned& leading = led();
  for (Turned& other : spindles_)
    if (&other != &leading) other.angle += override_part_ * other.turning.degrees(other.turning.now()) * law.seconds;
  const SpindleTurn now{leading.angle, per_second, per_mm_, false, std::exchange(leading.absolute, false)};
  leading.angle = now.at(law.seconds, law.length);
  return now;
}

double SpindleClock::seconds_to(double angle, double ahead) const {
  constexpr double same = 1e-9;  // Fraction of a revolution. A zero pulse that occurred at most this fraction ago counts as occurring now.
  const double rate = std::fabs(per_second()), angle_now = spindles_[leading_].angle, turned = turning().reversed ? -angle_now : angle_now;
  const double pulse = full_turn * std::ceil(turned / full_turn - same);
  // rotation of the spindle in the time `ahead`, degrees; the motion starts after the zero pulse, so its angle is at least this value
  const double least = rate * ahead;
  const double more = full_turn * std::max(0.0, std::ceil((least - angle) / full_turn - same));
  return std::max(0.0, (pulse - turned + angle + more - least) / rate);
}

}  // namespace kadr
