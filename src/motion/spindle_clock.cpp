#include "motion/spindle_clock.h"

#include <cmath>

namespace kadr {
namespace {

constexpr double turn = 360;
constexpr double per_second_of_rpm = turn / 60;

}  // namespace

void SpindleClock::set_rate() {
  const double per_second = turning_.now() * per_second_of_rpm * (turning_.reversed ? -1 : 1);
  if (!unmarked_) rates_.push_back({++last_ & most_marks, per_second});
  else rates_.back().per_second = per_second;
  unmarked_ = true;
}

void SpindleClock::start(const SpindleSetup& setup) {
  turning_.rpm = setup.rpm;
  turning_.reversed = setup.dir == "ccw";
  angle_ = setup.angle.value_or(0);
  set_rate();
}

void SpindleClock::take(const Action& action) {
  if (const auto* const speed = std::get_if<Speed>(&action.what)) {
    if (speed->number != 1) return;
    turning_.take(*speed);
  } else if (const auto* const spindle = std::get_if<Spindle>(&action.what)) {
    if (spindle->number != 1) return;
    turning_.take(*spindle);
    if (spindle->dir == SpindleDir::orient) angle_ = turn * std::ceil(angle_ / turn);
    if (spindle->dir == SpindleDir::position) angle_ += spindle->turn.value_or(0);
  } else {
    return;
  }
  set_rate();
}

void SpindleClock::couple(double degrees_per_mm) {
  per_mm_ = degrees_per_mm;
  turning_.on = false;
  set_rate();
}

void SpindleClock::release() { per_mm_ = 0; }

void SpindleClock::tell(TimedCells& cells) {
  cells.spindle.clear();
  for (std::size_t k = 0; k < cells.laws.size(); ++k) {
    while (rates_.size() > 1 && rates_.front().mark != cells.tags[k] >> mark_shift) rates_.pop_front();
    const TimeLaw& law = cells.laws[k];
    cells.spindle.push_back({angle_, rates_.front().per_second, per_mm_});
    angle_ = cells.spindle.back().at(law.seconds, law.length);
  }
}

double SpindleClock::rate() const { return std::fabs(rates_.back().per_second); }

double SpindleClock::seconds_to(double angle, double ahead) const {
  constexpr double same = 1e-9;  // of a turn: the pulse that comes just now
  const double turned = turning_.reversed ? -angle_ : angle_;
  const double pulse = turn * std::ceil(turned / turn - same);
  const double least = rate() * ahead;  // it has turned by since the pulse
  const double more = turn * std::max(0.0, std::ceil((least - angle) / turn - same));
  return std::max(0.0, (pulse - turned + angle + more - least) / rate());
}

}  // namespace kadr
