// Divides the motion of the machine's axes into segments. This file is used by session/cutting/machine_watch and tested by
// tests/run_cut.py.

#include "session/cutting/axes_path.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr int max_pieces_of_turn = 4096;
// Least number of segments of a motion with tool centre point control. On such a motion the linear axes compensate for the rotation, so
// they do not move along straight lines.
constexpr int least_tcp_pieces = 8;
constexpr int max_halvings = 10;  // greatest number of times that a segment of such a motion is halved

/// Divides a motion on which the axes do not move along a straight line into segments. Each step of the division treats the part of the
/// motion between two fractions (0 to 1).
class TcpAxesPath {
 public:
  TcpAxesPath(const Step& step, double chord, const AxesVisitor& visit) : step_(step), chord_(chord), visit_(visit) {}
  Axes at(double part) const {
    const Motion& motion = *step_.motion();
    return machine_along(step_.roles, step_.from, motion, part < 1 ? step_.curve().at(part) : motion.to, part);
  }
  void go(const Axes& from, double begins, const Axes& to, double ends, int halvings) const {
    const double part = 0.5 * (begins + ends);
    const Axes middle = at(part);
    bool even = true;
    for (std::size_t i = 0; i < step_.roles.count; ++i) even = even && std::fabs(middle[i] - 0.5 * (from[i] + to[i])) <= chord_;
    if (even || halvings == 0) return visit_(to, ends);
    go(from, begins, middle, part, halvings - 1);
    go(middle, part, to, ends, halvings - 1);
  }

 private:
  const Step& step_;
  double chord_;
  const AxesVisitor& visit_;
};

}  // namespace

void along_axes_path(const Step& step, double chord, const std::optional<Axes>& apart, const AxesVisitor& visit) {
  const Motion& motion = *step.motion();
  const Curve& curve = step.curve();
  const bool led = controls_tip(step.from, motion);
  Axes end = motion.machine;
  if (motion.detail)
    for (std::size_t i = 0; i < step.roles.count; ++i)
      if ((motion.detail->rolled >> i & 1U) != 0) end[i] = step.from.machine[i] + motion.detail->travel[i];
  if (const auto leg = DogLeg::of(step, apart)) {
    for (const double part : leg->corners()) {
      Axes to = step.from.machine;
      for (std::size_t i = 0; i < step.roles.count; ++i) to[i] += leg->gone(i, part) * (end[i] - to[i]);
      visit(to, part);
    }
    return;
  }
  if (curve.straight() && !led) return visit(end, 1);
  const int most = max_pieces_of_turn * (1 + int(std::min(motion.turns, 1e4)));
  const int count = std::clamp(curve.straight() ? 1 : curve.pieces(chord), led ? least_tcp_pieces : 1, most);
  const TcpAxesPath path(step, chord, visit);
  Axes from = step.from.machine;
  for (int i = 1; i <= count; ++i) {
    const double part = double(i) / count;
    const Axes to = i == count ? end : path.at(part);
    if (led) path.go(from, double(i - 1) / count, to, part, max_halvings);
    else visit(to, part);
    from = to;
  }
}

}  // namespace kadr
