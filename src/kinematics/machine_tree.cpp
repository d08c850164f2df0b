// Forward and inverse kinematics of a machine that is described by a machine file. Used by session and cli/machines; tested by
// tests/kinematics/machine_tree_test.cpp.

#include "kinematics/machine_tree.h"

#include <algorithm>
#include <cmath>

#include "texts/machine_tree.h"

namespace kadr {
namespace {

constexpr double same_direction = 1e-11;  // two unit vectors that differ by less than this count as equal

/// Returns the angle or distance by which the joint moves: the axis position, with the opposite sign for a reversed joint.
double signed_position(const MachineJoint& joint, double position) { return joint.moves.reversed ? -position : position; }

/// Solves m·v = b for v by Cramer's rule. Returns nullopt if m is singular: its determinant is at most `least`.
std::optional<Vec3> solved(const Mat3& m, Vec3 b, double least) {
  const Vec3 x = m.column(0), y = m.column(1), z = m.column(2);
  const double whole = dot(x, cross(y, z));
  if (!(std::fabs(whole) > least)) return std::nullopt;
  return 1 / whole * Vec3{dot(b, cross(y, z)), dot(x, cross(b, z)), dot(x, cross(y, b))};
}

/// Returns the sum of the matrices v·vᵀ for the vectors v of the list.
Mat3 sum_of_squares(const std::vector<Vec3>& all) {
  Mat3 sum{{Vec3{}, Vec3{}, Vec3{}}};
  for (const Vec3& v : all) {
    sum.rows[0] = sum.rows[0] + v.x * v;
    sum.rows[1] = sum.rows[1] + v.y * v;
    sum.rows[2] = sum.rows[2] + v.z * v;
  }
  return sum;
}

bool is_main(Vec3 direction) {
  const Vec3 d = direction;
  return (d.x == 1 && d.y == 0 && d.z == 0) || (d.x == 0 && d.y == 1 && d.z == 0) || (d.x == 0 && d.y == 0 && d.z == 1);
}

}  // namespace

MachineTree::MachineTree(const MachineProfile& profile, const std::vector<std::string>& axes)
    : tool_direction_(profile.chains.tool_direction) {
  const auto chain = [&](const std::vector<std::string>& names) {
    std::vector<MachineJoint> joints;
    for (const std::string& name : names) {
      const AxisProfile& axis = profile.axes.at(name);
      const auto found = std::find(axes.begin(), axes.end(), name);
      joints.push_back({name, found == axes.end() ? -1 : static_cast<int>(found - axes.begin()), axis.joint, axis.least, axis.most});
    }
    return joints;
  };
  tool_ = chain(profile.chains.tool);
  part_ = chain(profile.chains.part);
}

double MachineTree::position(const MachineJoint& joint, const Axes& axes) {
  return joint.axis < 0 ? 0 : signed_position(joint, axes[static_cast<std::size_t>(joint.axis)]);
}

Pose MachineTree::forward(const Axes& axes, double tool_length) const {
  Pose at{-tool_length * tool_direction_, tool_direction_};
  const auto turn = [&at](const AxisJoint& by, double angle) {
    const Mat3 turned = Mat3::about(by.direction, angle);
    at = {by.through + turned * (at.tip - by.through), turned * at.direction};
  };
  for (auto joint = tool_.rbegin(); joint != tool_.rend(); ++joint) {
    if (joint->moves.turns) turn(joint->moves, position(*joint, axes));
    else at.tip = at.tip + position(*joint, axes) * joint->moves.direction;
  }
  // As seen from the part, a rotary joint that carries the part turns the tool in the opposite sense. For a linear joint, the machine file
  // already states the direction of the tool.
  for (const MachineJoint& joint : part_) {
    if (joint.moves.turns) turn(joint.moves, -position(joint, axes));
    else at.tip = at.tip + position(joint, axes) * joint.moves.direction;
  }
  return at;
}

std::vector<const MachineJoint*> MachineTree::joints(bool rotary) const {
  std::vector<const MachineJoint*> all;
  for (const auto* chain : {&tool_, &part_})
    for (const MachineJoint& joint : *chain)
      if (joint.moves.turns == rotary) all.push_back(&joint);
  return all;
}

/// Returns a FiveAxis that gives the same tool directions as this machine with two rotary axes. Linear axes are omitted, because they do
/// not influence directions.
FiveAxis MachineTree::directions(const std::vector<const MachineJoint*>& rotary) const {
  const auto on_tool = std::count_if(tool_.begin(), tool_.end(), [](const MachineJoint& j) { return j.moves.turns; });
  FiveAxis five;
  five.group = on_tool == 2 ? MachineGroup::head_head : on_tool == 1 ? MachineGroup::head_table : MachineGroup::table_table;
  five.tool = tool_direction_;
  const auto of = [](const MachineJoint& joint) {
    return RotaryJoint{joint.axis, joint.moves.direction, joint.moves.reversed ? -1. : 1., joint.least, joint.most};
  };
  five.first = of(*rotary[0]);
  five.second = of(*rotary[1]);
  return five;
}

/// Turns the tool to the wanted direction with any number of rotary axes. It iterates damped Gauss-Newton steps; each step is the smallest
/// change of the axis positions that gives the missing change of direction.
bool MachineTree::turn_by_steps(Vec3 target, Axes& axes) const {
  const std::vector<const MachineJoint*> rotary = joints(true);
  constexpr int max_steps = 100;
  constexpr double probe = 1e-4;  // step of the axis position, degrees, for the numerical derivative
  for (int step = 0; step < max_steps; ++step) {
    const Vec3 now = direction(axes), missing = target - now;
    if (length(missing) < same_direction) return true;
    std::vector<Vec3> change;
    for (const MachineJoint* joint : rotary) {
      if (joint->axis < 0) continue;
      Axes moved = axes;
      moved[static_cast<std::size_t>(joint->axis)] += probe;
      Axes back = axes;
      back[static_cast<std::size_t>(joint->axis)] -= probe;
      change.push_back(0.5 / (probe * rad_per_deg) * (direction(moved) - direction(back)));
    }
    Mat3 normal = sum_of_squares(change);
    const double damp = 1e-9 + 1e-4 * std::min(1., length(missing)) * length(missing);
    for (int i = 0; i < 3; ++i) (i == 0 ? normal.rows[0].x : i == 1 ? normal.rows[1].y : normal.rows[2].z) += damp;
    const auto weight = solved(normal, missing, 1e-30);
    if (!weight) return false;
    std::size_t i = 0;
    for (const MachineJoint* joint : rotary) {
      if (joint->axis < 0) continue;
      double& at = axes[static_cast<std::size_t>(joint->axis)];
      constexpr double widest = 30;  // greatest change of an axis in one step, degrees
      at = std::clamp(at + std::clamp(dot(change[i++], *weight) / rad_per_deg, -widest, widest), joint->least, joint->most);
    }
  }
  return length(target - direction(axes)) < 1e-9;
}

bool MachineTree::turn_to(Vec3 target, Axes& axes) const {
  if (length(target - direction(axes)) < same_direction) return true;
  const std::vector<const MachineJoint*> rotary = joints(true);
  if (rotary.size() == 2 && rotary[0]->axis >= 0 && rotary[1]->axis >= 0) {
    const auto at = [&](const MachineJoint* joint) -> double& { return axes[static_cast<std::size_t>(joint->axis)]; };
    const auto pair = directions(rotary).chosen(target, {at(rotary[0]), at(rotary[1])});
    if (!pair) return false;
    at(rotary[0]) = pair->first;
    at(rotary[1]) = pair->second;
    return true;
  }
  const Axes start = axes;
  // Starting positions of the iteration, in degrees from the present position. They are tried in this order until the iteration converges.
  constexpr double starts[] = {0, 40, -40, 85, -85, 130, -130, 175};
  for (const double first : starts)
    for (std::size_t which = 0; which < rotary.size(); ++which) {
      axes = start;
      if (rotary[which]->axis >= 0) {
        double& at = axes[static_cast<std::size_t>(rotary[which]->axis)];
        at = std::clamp(at + first, rotary[which]->least, rotary[which]->most);
      }
      if (turn_by_steps(target, axes)) return true;
    }
  return false;
}

/// Moves the tip to `tip` by the smallest change of the linear axes. The position of the tip is a linear function of the positions of these
/// axes.
bool MachineTree::move_to(Vec3 tip, Axes& axes, double tool_length) const {
  const Vec3 here = forward(axes, tool_length).tip;
  std::vector<const MachineJoint*> linear = joints(false);
  std::vector<Vec3> change;
  for (const MachineJoint* joint : linear) {
    Axes moved = axes;
    if (joint->axis >= 0) moved[static_cast<std::size_t>(joint->axis)] += 1;
    change.push_back(forward(moved, tool_length).tip - here);
  }
  const auto weight = solved(sum_of_squares(change), tip - here, 1e-12);
  if (!weight) return length(tip - here) < 1e-9;
  for (std::size_t i = 0; i < linear.size(); ++i) {
    if (linear[i]->axis < 0) continue;
    double& at = axes[static_cast<std::size_t>(linear[i]->axis)];
    at += dot(change[i], *weight);
    constexpr double rounding = 1e-9;
    if (at < linear[i]->least - rounding || at > linear[i]->most + rounding) return false;
  }
  return length(tip - forward(axes, tool_length).tip) < 1e-6;
}

std::optional<Axes> MachineTree::inverse(const Pose& pose, const Axes& near, double tool_length) const {
  Axes axes = near;
  if (!turn_to(unit(pose.direction), axes) || !move_to(pose.tip, axes, tool_length)) return std::nullopt;
  return axes;
}

tl::expected<FiveAxis, std::string> MachineTree::five_axis() const {
  const auto no = [](auto text, const auto&... args) { return tl::unexpected(translated(text, args...)); };
  const std::vector<const MachineJoint*> rotary = joints(true);
  if (rotary.size() != 2) return no(texts::machine_tree::not_two_rotary);
  if (!is_main(tool_direction_)) return no(texts::machine_tree::tool_not_along_axis);
  for (const auto* chain : {&tool_, &part_}) {
    bool turned = false;
    for (const MachineJoint& joint : *chain) {
      turned |= joint.moves.turns;
      if (joint.moves.turns) continue;
      if (turned) return no(texts::machine_tree::axis_turns, joint.name);
      if (!is_main(joint.moves.direction) || joint.moves.reversed) return no(texts::machine_tree::axis_not_along_main, joint.name);
    }
  }
  FiveAxis five = directions(rotary);
  const Vec3 first = rotary[0]->moves.through, second = rotary[1]->moves.through;
  switch (five.group) {
    case MachineGroup::head_head: five.holder = second, five.head = first - second; break;
    case MachineGroup::table_table: five.table = first, five.second_table = second - first; break;
    default: five.holder = first, five.table = second; break;
  }
  return five;
}

}  // namespace kadr
