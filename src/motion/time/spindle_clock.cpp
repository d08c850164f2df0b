// SpindleClock: the angle of the main spindle over the time of the axes' motion. For motion/least_time/axis_motion; tested by
// tests/motion/spindle_clock_test.cpp.

#include "motion/time/spindle_clock.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kadr {
namespace {

constexpr double full_turn = 360;

}  // namespace

void SpindleClock::start(const SpindleSetup& setup, double override_part) {
  override_part_ = override_part;
  turning_.rpm = setup.rpm;
  turning_.reversed = setup.dir == "ccw";
  angle_ = setup.angle.value_or(0);
}

void SpindleClock::take(const Action& action) {
  if (const auto* const speed = std::get_if<Speed>(&action.what)) {
    if (speed->number == 1) turning_.take(*speed);
  } else if (const auto* const law = std::get_if<SurfaceSpeed>(&action.what)) {
    if (law->number == 1) turning_.surface = *law;
  } else if (const auto* const spindle = std::get_if<Spindle>(&action.what)) {
    if (spindle->number != 1) return;
    turning_.take(*spindle);
    if (spindle->dir == SpindleDir::orient) angle_ = full_turn * std::ceil(angle_ / full_turn), absolute_ = true;
    if (spindle->dir == SpindleDir::position) angle_ += spindle->turn.value_or(0);
  }
}

void SpindleClock::couple(double degrees_per_mm) {
  per_mm_ = degrees_per_mm;
  turning_.on = false;
}

SpindleTurn SpindleClock::turn(double per_second, const TimeLaw& law) {
  const SpindleTurn now{angle_, per_second, per_mm_, false, std::exchange(absolute_, false)};
  angle_ = now.at(law.seconds, law.length);
  return now;
}

double SpindleClock::seconds_to(double angle, double ahead) const {
  constexpr double same = 1e-9;  // of a turn: the pulse that comes just now
  const double rate = std::fabs(per_second()), turned = turning_.reversed ? -angle_ : angle_;
  const double pulse = full_turn * std::ceil(turned / full_turn - same);
  const double least = rate * ahead;  // it has turned by since the pulse
  const double more = full_turn * std::max(0.0, std::ceil((least - angle) / full_turn - same));
  return std::max(0.0, (pulse - turned + angle + more - least) / rate);
}

}  // namespace kadr
