// ToolPath: converts steps to straight segments of the path of the tool tip. It is used by session/cutting.

#include "session/cutting/tool_path.h"

#include <algorithm>
#include <cmath>

#include "kinematics/five_axis_transform.h"
#include "session/cutting/dog_leg.h"

namespace kadr {
namespace {

// greatest number of segments per revolution; the chords are then accurate to 0.1 µm up to a radius of 340 mm
constexpr int max_pieces = 4096;
constexpr double same_position = 1e-9;  // mm; positions that differ by less count as equal
// Assumed length of a tool, mm. An error of the tool's direction moves the upper end of the tool the farthest, which is at this distance
// from the tip.
constexpr double reach = 100;
constexpr double tilted_chord = 5e-4;  // tolerance for a tilted tool, mm; the sweeps of tilted tools are accurate to 2.5 µm (docs/stock.md)
constexpr double turn_of_chord = 5;    // permitted deviation of the upper end of the tool, as a multiple of the tolerance of the tip
// Degrees. A rotation greater than this is always divided, since after a great rotation the end direction may equal the start direction.
constexpr double undivided = 45;
constexpr int max_depth = 16;

bool has_rotary_axis(const MachineTree& tree) {
  const auto turns = [](const MachineJoint& j) { return j.moves.turns && j.axis >= 0; };
  return std::any_of(tree.tool().begin(), tree.tool().end(), turns) || std::any_of(tree.part().begin(), tree.part().end(), turns);
}

/// Returns the rotation of the rotary axis that turns the most in the step, degrees.
double rotary_travel(const Step& step) {
  const Motion& motion = *step.motion();
  double most = 0;
  for (std::size_t i = 0; i < step.roles.count; ++i) {
    if (!step.roles.is_rotary(i)) continue;
    const bool rolls = motion.detail && (motion.detail->rolled >> i & 1U) != 0;
    most = std::max(most, std::fabs(rolls ? motion.detail->travel[i] : motion.machine[i] - step.from.machine[i]));
  }
  return most;
}

bool is_nowhere(const PathSegment& p) { return length(p.to - p.from) <= same_position && p.from_direction == p.to_direction; }

}  // namespace

bool is_cutting(MotionKind kind) { return kind != MotionKind::rapid && kind != MotionKind::home && kind != MotionKind::probe; }

ToolPath::ToolPath(const AxisRoles& roles, double chord, std::optional<std::uint16_t> system, std::shared_ptr<const MachineTree> tree,
                   const std::optional<Axes>& apart)
    : chain_(roles), chord_(chord), system_(system), apart_(apart) {
  if (tree != nullptr && has_rotary_axis(*tree)) tree_ = std::move(tree);
}

bool ToolPath::turns(const Step& step) const {
  const WorkTransform* const space = step.from.space.get();
  return tree_ != nullptr || (space != nullptr && space->has_rotary());
}

/// Returns the work coordinates in force, without a shift by G52 or G92. The shift is normally part of the origin, so it is subtracted. If
/// the coordinates are rotated, the shift is stored separately.
Placement ToolPath::without_shift() const {
  Placement plain = placement_;
  plain.shift = {};
  for (std::size_t a = 0; shifted_ && a < plain.origin.size(); ++a) plain.origin[a] -= (*shifted_)[a];
  return plain;
}

/// Returns the tool length that the control applies in the step, mm. With tool centre point control the transform of the rotary axes
/// contains the length.
double ToolPath::length_on(const Step& step) const {
  const auto* const space = dynamic_cast<const FiveAxisTransform*>(step.from.space.get());
  if (space != nullptr && space->has_rotary()) {
    const Vec3 along = space->data().length, tool = space->data().machine.tool;
    return along.x * tool.x + along.y * tool.y + along.z * tool.z;
  }
  return chain_.tip(placement_.length).z;
}

/// Returns the tip and the direction of the tool. With rotary axes or a tilted frame they come from the transform in force or from the
/// machine's kinematics. Otherwise the position of the tip is the sum of origin and coordinates.
Pose ToolPath::pose_of(const Step& step, const Axes& work, double part) const {
  const WorkTransform* const space = step.from.space.get();
  if (space != nullptr && space->has_rotary()) {
    Pose pose = space->pose(machine_along(step.roles, step.from, *step.motion(), work, part));
    pose.tip = pose.tip + space->zero();
    return pose;
  }
  if (tree_ != nullptr) {
    Axes axes = machine_along(step.roles, step.from, *step.motion(), work, part);
    for (const int across : {step.roles.xyz[0], step.roles.xyz[1]})  // a turning tool also has lengths across the direction of the tool
      if (across >= 0) axes[std::size_t(across)] -= placement_.length[std::size_t(across)];
    return tree_->forward(axes, length_in_force());
  }
  if (!placement_.is_plain() && space != nullptr) return {chain_.tip(space, work) + work_origin_of(chain_, placement_), {0, 0, 1}};
  Axes tip = placement_.machine_of(work);
  for (std::size_t i = 0; i < max_axes; ++i) tip[i] -= placement_.length[i];
  return {chain_.tip(tip), {0, 0, 1}};
}

Axes ToolPath::work_at(const Step& step, double part) {
  return part >= 1 ? step.motion()->to : part <= 0 ? step.from.work : step.curve().at(part);
}

Pose ToolPath::pose_at(const Step& step, double part) const { return pose_of(step, work_at(step, part), part); }

Axes ToolPath::axes_at(const Step& step, double part) {
  return machine_along(step.roles, step.from, *step.motion(), work_at(step, part), part);
}

/// Halves the segment until, in the middle of each half, the true tip and direction agree with a tool that moves straight and rotates
/// evenly between the ends.
void ToolPath::divide(const Step& step, const PathSegment& p, int depth, std::vector<PathSegment>& pieces) const {
  const double part = (p.begins + p.ends) / 2;
  const Pose middle = pose_at(step, part);
  const Vec3 between = p.from_direction + p.to_direction;
  const double size = length(between), off = size > 0 ? length((1 / size) * between - middle.direction) : 2;
  const double allowed = std::max(chord_, tilted_chord);
  const bool straight = length(0.5 * (p.from + p.to) - middle.tip) <= allowed && off * reach <= turn_of_chord * allowed;
  if (depth >= max_depth || straight) {
    if (!is_nowhere(p)) pieces.push_back(p);
    return;
  }
  divide(step, {p.from, middle.tip, p.begins, part, p.from_direction, middle.direction}, depth + 1, pieces);
  divide(step, {middle.tip, p.to, part, p.ends, middle.direction, p.to_direction}, depth + 1, pieces);
}

/// Divides a rapid motion of independent axes into segments from corner to corner. Returns false if rotary axes turn the tool or the part:
/// the path of such a motion is treated as a straight line.
bool ToolPath::bent(const Step& step, std::vector<PathSegment>& pieces) const {
  const auto leg = DogLeg::of(step, apart_);
  if (!leg || turns(step)) return false;
  const Vec3 start = pose_at(step, 0).tip, delta = pose_at(step, 1).tip - start;
  const auto gone = [&](std::size_t letter, double part) {
    const int axis = step.roles.xyz[letter];
    return axis < 0 ? part : leg->gone(std::size_t(axis), part);
  };
  Vec3 from = start;
  double begins = 0;
  for (const double part : leg->corners()) {
    const Vec3 to = start + Vec3{gone(0, part) * delta.x, gone(1, part) * delta.y, gone(2, part) * delta.z};
    if (length(to - from) > same_position) pieces.push_back({from, to, begins, part});
    from = to;
    begins = part;
  }
  return true;
}

void ToolPath::take(const Step& step, std::vector<PathSegment>& pieces) {
  pieces.clear();
  if (const auto* const frame = std::get_if<FrameChange>(&step.action.what)) placement_ = frame->placement, shifted_ = frame->shifted;
  const Motion* const motion = step.motion();
  if (motion == nullptr) return;
  length_ = length_on(step);
  if (!zero_ && system_ && motion->system == *system_) zero_ = work_origin_of(chain_, without_shift());
  if (!zero_ && !system_ && is_cutting(motion->kind)) zero_ = present_origin();
  if (bent(step, pieces)) return;
  const Curve& curve = step.curve();
  const double turn = turns(step) ? rotary_travel(step) : 0;
  int count = curve.straight() ? 1 : std::min(curve.pieces(chord_), max_pieces * (1 + int(std::min(motion->turns, 1e4))));
  count = std::max(count, int(std::min(std::ceil(turn / undivided), 1e5)));
  Pose from = pose_at(step, 0);
  for (int i = 1; i <= count; ++i) {
    const double part = double(i) / count;
    const Pose to = pose_at(step, part);
    const PathSegment piece{from.tip, to.tip, double(i - 1) / count, part, from.direction, to.direction};
    if (turn > 0) divide(step, piece, 0, pieces);
    else if (!is_nowhere(piece)) pieces.push_back(piece);
    from = to;
  }
}

}  // namespace kadr
