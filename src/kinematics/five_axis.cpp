// Computes the tool's pose in the part for a machine with two rotary and three linear axes, and the inverse. Used by
// kinematics/five_axis_transform and control/fanuc/five_axis; tested by tests/kinematics/five_axis_test.cpp.

#include "kinematics/five_axis.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double turn = 360;
// Greatest difference of two unit vectors, the tool direction and the direction of a rotary axis, that still counts as parallel (nct 25a
// 5.1)
constexpr double singular = 1e-6;
constexpr double tie = 1e-4;  // two angles that differ by less than this number of degrees count as equal (nct 25g 3)

double degrees(double radians) { return radians / rad_per_deg; }

/// Returns the equivalent of the angle in [-180, 180] degrees.
double within_turn(double angle) { return std::remainder(angle, turn); }

/// Returns the equivalent angle in (-180, 180]. A value that rounding has put just above -180 becomes 180.
double plain(double angle) {
  const double a = within_turn(angle);
  return a <= -turn / 2 + 1e-9 ? a + turn : a;
}

/// The angles x and y, in degrees, that solve Ma(x)·Mb(y)·v = w. Ma and Mb rotate about the unit vectors a and b (nct 25a 5.1).
struct Angles {
  int count = 0;
  std::array<double, 2> x{}, y{};
  bool x_free = false, y_free = false;
};

Angles angles(Vec3 a, Vec3 b, Vec3 v, Vec3 w) {
  Angles found;
  const double c = dot(a, b), d = c * c - 1;
  if (std::fabs(d) < singular) return found;  // parallel rotary axes have no unique solution
  const double bv = dot(b, v), aw = dot(a, w);
  const double in_a = (c * bv - aw) / d, in_b = (c * aw - bv) / d;
  const Vec3 across = cross(a, b);
  const double left = (1 - in_a * in_a - in_b * in_b - 2 * in_a * in_b * c) / -d;
  constexpr double rounding = 1e-9;
  if (!(left >= -rounding)) return found;
  const double g = std::sqrt(std::max(left, 0.0));
  const Vec3 in_plane = in_a * a + in_b * b;
  found.x_free = length(w - aw * a) < singular;
  found.y_free = length(v - bv * b) < singular;
  found.count = g * length(across) < singular / 10 ? 1 : 2;
  for (int i = 0; i < found.count; ++i) {
    const Vec3 z = in_plane + (i == 0 ? g : -g) * across;
    const auto at = static_cast<std::size_t>(i);
    found.y[at] = found.y_free ? 0 : degrees(std::atan2(dot(b, cross(v, z)), dot(v, z) - bv * dot(b, z)));
    found.x[at] = found.x_free ? 0 : degrees(std::atan2(dot(a, cross(z, w)), dot(z, w) - dot(a, z) * aw));
  }
  return found;
}

/// Returns the equivalent of `angle` that is nearest to the present position within the joint's limits; nullopt if the limits exclude all
/// equivalents.
std::optional<double> nearest(const RotaryJoint& joint, double angle, double present) {
  const double least = joint.least - tie, most = joint.most + tie;
  double best = present + within_turn(angle - present);
  if (best < least) best += turn * std::ceil((least - best) / turn);
  if (best > most) best -= turn * std::ceil((best - most) / turn);
  if (best < least || best > most) return std::nullopt;
  return best;
}

}  // namespace

Mat3 FiveAxis::head_turn(RotaryPair at) const {
  switch (group) {
    case MachineGroup::head_head: return first_turn(at.first) * second_turn(at.second);
    case MachineGroup::head_table: return first_turn(at.first);
    default: return {};
  }
}

Mat3 FiveAxis::table_turn(RotaryPair at, RotaryPair zero) const {
  switch (group) {
    case MachineGroup::table_table:
      return first_turn(at.first) * second_turn(at.second) * transposed(first_turn(zero.first) * second_turn(zero.second));
    case MachineGroup::head_table: return second_turn(at.second - zero.second);
    default: return {};
  }
}

Vec3 FiveAxis::direction(RotaryPair at, RotaryPair zero) const { return turned_back(table_turn(at, zero), head_turn(at) * tool); }

Vec3 FiveAxis::length_vector(RotaryPair at, Vec3 along) const {
  switch (group) {
    case MachineGroup::head_head: {
      const Mat3 r1 = first_turn(at.first);
      return r1 * (second_turn(at.second) * (along + holder)) + r1 * head - (holder + head);
    }
    case MachineGroup::head_table: return first_turn(at.first) * (along + holder) - holder;
    default: return along;
  }
}

Vec3 FiveAxis::point_on_machine(RotaryPair at, Vec3 point, RotaryPair zero) const {
  switch (group) {
    case MachineGroup::table_table: {
      const Vec3 on_second = turned_back(first_turn(zero.first), point - table) - second_table;
      return table + first_turn(at.first) * (second_table + second_turn(at.second - zero.second) * on_second);
    }
    case MachineGroup::head_table: return table + second_turn(at.second - zero.second) * (point - table);
    default: return point;
  }
}

Vec3 FiveAxis::point_in_part(RotaryPair at, Vec3 point, RotaryPair zero) const { return point_on_machine(zero, point, at); }

RotarySolutions FiveAxis::solutions(Vec3 target, RotaryPair zero) const {
  // Programmed direction of the tool, expressed in the orientation that the part has with the tables at 0
  const Vec3 t = table_turn({}, zero) * target;
  RotarySolutions all;
  const auto take = [&](const Angles& found, bool x_is_first, double x_sign) {
    all.count = found.count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
      const double one = plain(x_sign * (x_is_first ? first.sense : second.sense) * found.x[i]);
      const double other = plain((x_is_first ? second.sense : first.sense) * found.y[i]);
      all.pairs[i] = x_is_first ? RotaryPair{one, other} : RotaryPair{other, one};
    }
    all.first_free = x_is_first ? found.x_free : found.y_free;
    all.second_free = x_is_first ? found.y_free : found.x_free;
  };
  switch (group) {
    case MachineGroup::head_head: take(angles(first.direction, second.direction, tool, t), true, 1); break;
    case MachineGroup::table_table: take(angles(first.direction, second.direction, t, tool), true, 1); break;
    case MachineGroup::head_table: take(angles(second.direction, first.direction, tool, t), false, -1); break;
    case MachineGroup::none: break;
  }
  return all;
}

std::optional<RotaryPair> FiveAxis::chosen(Vec3 target, RotaryPair present, RotaryPair zero) const {
  const RotarySolutions all = solutions(target, zero);
  struct Candidate {
    RotaryPair at;
    // Results of the selection rules for this pair of rotary positions, in the order of the rules. The first result that differs between
    // two pairs decides: the pair with the smaller result is selected.
    std::array<double, 4> rank;
    double primary;  // position of the primary axis, before it is moved into the limits of the axis
  };
  std::optional<Candidate> best;
  const bool table_first = group == MachineGroup::head_table;
  for (std::size_t i = 0; i < static_cast<std::size_t>(all.count); ++i) {
    RotaryPair pair = all.pairs[i];
    if (all.first_free) pair.first = present.first;
    if (all.second_free) pair.second = present.second;
    const auto one = nearest(first, pair.first, present.first), other = nearest(second, pair.second, present.second);
    if (!one || !other) continue;
    const double turns_first = std::fabs(within_turn(pair.first - present.first));
    const double turns_second = std::fabs(within_turn(pair.second - present.second));
    const double off_first = std::fabs(within_turn(pair.first)), off_second = std::fabs(within_turn(pair.second));
    const Candidate candidate{{*one, *other},
                              table_first ? std::array{turns_second, turns_first, off_second, off_first}
                                          : std::array{turns_first, turns_second, off_first, off_second},
                              table_first ? pair.second : pair.first};
    if (!best) {
      best = candidate;
      continue;
    }
    std::size_t rule = 0;
    while (rule < candidate.rank.size() && std::fabs(candidate.rank[rule] - best->rank[rule]) <= tie) ++rule;
    const bool better = rule < candidate.rank.size() ? candidate.rank[rule] < best->rank[rule] : candidate.primary > best->primary;
    if (better) best = candidate;
  }
  if (!best) return std::nullopt;
  return best->at;
}

/// One axis stays at its position. While the other axis turns by t, the tool's direction moves on the circle p + cos(t) c + sin(t) s. The
/// direction is nearest to the wanted direction w at tan(t) = s·w / c·w.
std::optional<FiveAxis::OneAxisMoved> FiveAxis::with_one_axis_moved(Vec3 target, RotaryPair present, RotaryPair zero) const {
  const bool first_stays = group == MachineGroup::head_head;
  const auto pair = [&](double other) { return first_stays ? RotaryPair{present.first, other} : RotaryPair{other, present.second}; };
  const Vec3 at_0 = direction(pair(0), zero), at_90 = direction(pair(90), zero), at_180 = direction(pair(180), zero);
  const Vec3 middle = 0.5 * (at_0 + at_180), c = at_0 - middle, s = at_90 - middle;
  const double angle = degrees(std::atan2(dot(s, target), dot(c, target)));
  const auto other = nearest(first_stays ? second : first, angle, first_stays ? present.second : present.first);
  if (!other) return std::nullopt;
  const Vec3 found = direction(pair(*other), zero);
  return OneAxisMoved{pair(*other), degrees(std::atan2(length(cross(found, target)), dot(found, target))), first_stays};
}

std::optional<RotaryPair> FiveAxis::continued(Vec3 target, RotaryPair present, RotaryPair zero) const {
  const RotarySolutions all = solutions(target, zero);
  std::optional<RotaryPair> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < static_cast<std::size_t>(all.count); ++i) {
    const double one = all.first_free ? 0 : within_turn(all.pairs[i].first - present.first);
    const double other = all.second_free ? 0 : within_turn(all.pairs[i].second - present.second);
    const double rotation = std::hypot(one, other);
    if (rotation < least) least = rotation, best = RotaryPair{present.first + one, present.second + other};
  }
  return best;
}

}  // namespace kadr
