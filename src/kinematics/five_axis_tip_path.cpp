// Computes the tool's path under tool centre point control, for motions whose tool stays in a plane or on a cone, whose cutting point
// follows the programmed curve, or which rotate the tool about a fixed point. Used by control/fanuc/five_axis; tested by
// tests/kinematics/five_axis_tip_path_test.cpp.

#include "kinematics/five_axis_tip_path.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double parallel = 1e-9;  // two directions whose angle is less than this number of radians count as the same
// Two unit vectors that differ by less than this count as equal: a direction this close to the pole is singular (nct 25a 5.1)
constexpr double at_pole = 1e-6;
constexpr double just_off = 1e-5;  // fraction of a motion: a position closer to its end than this counts as the end

double angle_between(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

double off(RotaryPair a, RotaryPair b) {
  return std::hypot(std::remainder(a.first - b.first, 360.0), std::remainder(a.second - b.second, 360.0));
}

RotaryPair nearest_turns(RotaryPair pair, RotaryPair near) {
  return {near.first + std::remainder(pair.first - near.first, 360.0), near.second + std::remainder(pair.second - near.second, 360.0)};
}

}  // namespace

Vec3 turned_towards(Vec3 from, Vec3 to, double part) {
  const double angle = angle_between(from, to);
  if (angle < parallel) return from;
  const double s = std::sin(angle);
  // Two opposite directions define no plane for the rotation, so the direction jumps at the end
  if (s < parallel) return part < 1 ? from : to;
  return unit((std::sin((1 - part) * angle) / s) * from + (std::sin(part * angle) / s) * to);
}

Vec3 contact_to_tip(Vec3 n, Vec3 t, double radius, double corner) {
  const Vec3 across = n - dot(n, t) * t;
  const Vec3 e = length(across) < parallel ? Vec3{} : unit(across);
  return corner * n + (radius - corner) * e - corner * t;
}

DirectionPath::DirectionPath(const FiveAxisTransform& space, RotaryPair start, Vec3 from, Vec3 to, const std::optional<Cone>& cone)
    : machine_(space.data().machine), zero_(space.data().measured), start_(start), from_(from), to_(to), cone_(cone) {
  angle_ = angle_between(from, to);
  if (cone_) {
    const auto about = [&](Vec3 v) { return std::atan2(dot(v, cone_->second), dot(v, cone_->first)); };
    const auto lean = [&](Vec3 v) { return std::atan2(std::hypot(dot(v, cone_->first), dot(v, cone_->second)), dot(v, cone_->axis)); };
    inclination_from_ = lean(from);
    inclination_to_ = lean(to);
    const bool upright_from = std::sin(inclination_from_) < at_pole, upright_to = std::sin(inclination_to_) < at_pole;
    angle_from_ = upright_from ? about(to) : about(from);
    const double end = upright_to ? angle_from_ : about(to);
    // Angle that the arc sweeps, in radians. Of all equivalent rotations of the tool about the cone's axis, turn_ becomes the one nearest
    // to this angle
    const double sweep = cone_->sweep * rad_per_deg;
    turn_ = upright_from && upright_to ? 0 : sweep + std::remainder(end - angle_from_ - sweep, 2 * pi);
    if (upright_from || upright_to) turn_ = 0;
  } else if (angle_ > parallel) {
    const Vec3 pole = machine_.group == MachineGroup::head_head ? machine_.first.direction
                                                                : turned_back(machine_.table_turn({}, zero_), machine_.second.direction);
    for (const Vec3 p : {pole, -1.0 * pole}) {  // looks for the pole (singular direction) between the two directions
      const double before = angle_between(from_, p), after = angle_between(p, to_);
      if (before + after - angle_ > at_pole * at_pole * 10) continue;
      const double part = before / angle_;
      if (length(cross(direction(part), p)) < at_pole && part > just_off && part < 1 - just_off) through_pole_ = part;
    }
  }
  const auto first = machine_.solutions(direction(0), zero_);
  // At a pole (singular direction) the two rotary solutions are equal, so the solutions are compared for a direction just after the pole
  const double look = first.first_free || first.second_free ? just_off : 0;
  const RotarySolutions then = machine_.solutions(direction(look), zero_);
  if (then.count == 2 && off(then.pairs[1], start_) < off(then.pairs[0], start_)) branch_ = 1;
}

Vec3 DirectionPath::direction(double part) const {
  if (!cone_) return turned_towards(from_, to_, part);
  const double about = angle_from_ + part * turn_, lean = inclination_from_ + part * (inclination_to_ - inclination_from_);
  return std::sin(lean) * (std::cos(about) * cone_->first + std::sin(about) * cone_->second) + std::cos(lean) * cone_->axis;
}

std::optional<RotaryPair> DirectionPath::on_branch(double part, RotaryPair near, int swaps, bool at_end) const {
  const RotarySolutions all = machine_.solutions(direction(part), zero_);
  if (all.count == 0) return std::nullopt;
  RotaryPair pair = all.pairs[all.count == 2 ? static_cast<std::size_t>((branch_ + swaps) % 2) : 0];
  if (all.first_free) pair.first = start_.first;
  if (all.second_free) pair.second = start_.second;
  // If the motion ends at a pole (singular direction), the free rotary axis stays where it was just before the pole
  if ((all.first_free || all.second_free) && !at_end && part > just_off)
    if (const auto before = on_branch(part - just_off, near, swaps, true); before) {
      if (all.first_free) pair.first = before->first;
      if (all.second_free) pair.second = before->second;
    }
  return nearest_turns(pair, near);
}

std::optional<RotaryPair> DirectionPath::rotary(double part, RotaryPair near) const {
  return on_branch(part, near, through_pole_ && part > *through_pole_ ? 1 : 0, false);
}

FiveAxisTipPath::FiveAxisTipPath(const Data& data) : d_(data) {
  if (!d_.posture) return;
  const RotaryPair start = pair_of(d_.start);
  direction_path_.emplace(*d_.space, start, d_.space->direction_of(start), d_.space->direction_of(pair_of(d_.end)), d_.cone);
}

void FiveAxisTipPath::set_pair(Axes& work, RotaryPair to) const {
  work[static_cast<std::size_t>(d_.space->data().machine.first.axis)] = to.first;
  work[static_cast<std::size_t>(d_.space->data().machine.second.axis)] = to.second;
}

Vec3 FiveAxisTipPath::main_of(const Axes& work) const {
  const auto& main = d_.space->data().main;
  const auto of = [&](std::size_t i) { return main[i] < 0 ? 0.0 : work[static_cast<std::size_t>(main[i])]; };
  return {of(0), of(1), of(2)};
}

void FiveAxisTipPath::set_main(Axes& work, Vec3 to) const {
  const auto& main = d_.space->data().main;
  const double values[] = {to.x, to.y, to.z};
  for (std::size_t i = 0; i < 3; ++i)
    if (main[i] >= 0) work[static_cast<std::size_t>(main[i])] = values[i];
}

std::optional<RotaryPair> FiveAxisTipPath::end_of_posture() const {
  return direction_path_ ? direction_path_->rotary(1, pair_of(d_.start)) : std::nullopt;
}

Vec3 FiveAxisTipPath::normal(double part) const { return d_.contact ? turned_towards(d_.normal, d_.end_normal, part) : Vec3{}; }

Axes FiveAxisTipPath::at(double part, const Axes& on_curve) const {
  Axes work = on_curve;
  if (direction_path_ && part > 0 && part < 1)
    if (const auto pair = direction_path_->rotary(part, pair_of(on_curve)); pair) set_pair(work, *pair);
  const FiveAxisTransform& space = *d_.space;
  if (d_.pivot) {
    const Vec3 from = space.in_system(main_of(d_.start)), lean = space.direction_of(pair_of(work)) - space.direction_of(pair_of(d_.start));
    set_main(work, space.in_frame(from + *d_.pivot * lean));
  }
  if (d_.contact) {
    const Vec3 to_tip = contact_to_tip(normal(part), space.direction_of(pair_of(work)), d_.radius, d_.corner);
    set_main(work, main_of(on_curve) + (d_.begins ? part : 1.0) * to_tip);
  }
  return work;
}

}  // namespace kadr
