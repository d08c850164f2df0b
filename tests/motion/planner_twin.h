#pragma once
// PlannerTwin: the times of straight blocks by the rules of Grbl 1.1h, written after its planner.c and stepper.c: a ring of 16 blocks, new
// entry speeds at each new block by a backward and a forward pass, and a stepper that executes the oldest block while the ring is filled.
// It knows nothing of Kadr, integrates in small steps, and is slow.

#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <vector>

namespace kadr::test {

struct TwinSettings {
  std::array<double, 3> rate{}, acceleration{};  // mm/s, mm/s²
  double junction_deviation = 0.01, arc_tolerance = 0.002;
};

class PlannerTwin {
 public:
  explicit PlannerTwin(const TwinSettings& settings) : s_(settings) {}

  /// A line to a point. `feed`: mm/s; 0: rapid.
  void line(std::array<double, 3> to, double feed) {
    while (ring_.size() >= ring_size - 1) step();  // plan_check_full_buffer(): the line waits
    Block b;
    for (std::size_t i = 0; i < 3; ++i) b.unit[i] = to[i] - at_[i];
    b.millimeters = size(b.unit);
    if (b.millimeters == 0) return;
    for (double& u : b.unit) u /= b.millimeters;
    at_ = to;
    b.acceleration = limit(s_.acceleration, b.unit);
    const double rapid = limit(s_.rate, b.unit);
    b.nominal = feed > 0 ? std::min(feed, rapid) : rapid;
    if (ring_.empty()) {
      b.max_junction_sqr = 0;
    } else {
      std::array<double, 3> junction{};
      double cos_theta = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        cos_theta -= previous_unit_[i] * b.unit[i];
        junction[i] = b.unit[i] - previous_unit_[i];
      }
      if (cos_theta > 0.999999) b.max_junction_sqr = 0;
      else if (cos_theta < -0.999999) b.max_junction_sqr = std::numeric_limits<double>::infinity();
      else {
        const double n = size(junction);
        for (double& j : junction) j /= n;
        const double sin_theta_d2 = std::sqrt(0.5 * (1 - cos_theta));
        b.max_junction_sqr = limit(s_.acceleration, junction) * s_.junction_deviation * sin_theta_d2 / (1 - sin_theta_d2);
      }
    }
    const double nominal = ring_.empty() ? b.nominal : std::min(b.nominal, previous_nominal_);
    b.max_entry_sqr = std::min(nominal * nominal, b.max_junction_sqr);
    previous_unit_ = b.unit;
    previous_nominal_ = b.nominal;
    ring_.push_back(b);
    recalculate();
  }

  /// An arc in the plane XY about a centre (mc_arc). `angle`: signed, radians.
  void arc(std::array<double, 3> to, std::array<double, 2> centre, double angle, double feed) {
    const double rx = at_[0] - centre[0], ry = at_[1] - centre[1], radius = std::hypot(rx, ry), z = at_[2];
    const auto segments = static_cast<int>(std::fabs(0.5 * angle * radius) / std::sqrt(s_.arc_tolerance * (2 * radius - s_.arc_tolerance)));
    for (int i = 1; i < segments; ++i) {
      const double a = angle * i / segments;
      line({centre[0] + rx * std::cos(a) - ry * std::sin(a), centre[1] + rx * std::sin(a) + ry * std::cos(a),
            z + (to[2] - z) * i / segments},
           feed);
    }
    line(to, feed);
  }

  /// Executes everything, to rest. Returns the time since the beginning, s.
  double finish() {
    while (!ring_.empty()) step();
    speed_ = 0;
    return seconds_;
  }

 private:
  static constexpr std::size_t ring_size = 16;
  struct Block {
    std::array<double, 3> unit{};
    double millimeters = 0, acceleration = 0, nominal = 0, max_junction_sqr = 0, max_entry_sqr = 0, entry_sqr = 0;
  };

  static double size(const std::array<double, 3>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }
  static double limit(const std::array<double, 3>& most, const std::array<double, 3>& unit) {
    double value = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i)
      if (unit[i] != 0) value = std::min(value, std::fabs(most[i] / unit[i]));
    return value;
  }

  /// planner_recalculate(), without the pointer that only saves time. The oldest block is executed: its own entry is its present speed.
  void recalculate() {
    for (std::size_t i = ring_.size(); i-- > 1;) {
      const double after = i + 1 < ring_.size() ? ring_[i + 1].entry_sqr : 0;
      ring_[i].entry_sqr = std::min(ring_[i].max_entry_sqr, after + 2 * ring_[i].acceleration * ring_[i].millimeters);
    }
    ring_[0].entry_sqr = speed_ * speed_;
    for (std::size_t i = 0; i + 1 < ring_.size(); ++i)
      ring_[i + 1].entry_sqr = std::min(ring_[i + 1].entry_sqr, ring_[i].entry_sqr + 2 * ring_[i].acceleration * ring_[i].millimeters);
  }

  /// Executes a small part of the oldest block: speeds up, cruises or slows down towards the entry speed of the next block.
  void step() {
    Block& b = ring_.front();
    const double exit_sqr = ring_.size() > 1 ? ring_[1].entry_sqr : 0;
    constexpr double pieces = 400;
    const double length = b.millimeters, part = length / pieces;
    for (int i = 1; i <= static_cast<int>(pieces); ++i) {
      const double rest = length - part * i;
      const double most_sqr =
          std::min({b.nominal * b.nominal, speed_ * speed_ + 2 * b.acceleration * part, exit_sqr + 2 * b.acceleration * rest});
      const double next = std::sqrt(std::max(most_sqr, 0.0));
      seconds_ += 2 * part / (speed_ + next);
      speed_ = next;
    }
    ring_.pop_front();
  }

  TwinSettings s_;
  std::deque<Block> ring_;
  std::array<double, 3> at_{}, previous_unit_{};
  double previous_nominal_ = 0, speed_ = 0, seconds_ = 0;
};

}  // namespace kadr::test
