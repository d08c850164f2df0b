// Steps → pieces of the tip's way. For session/cutting.

#include "session/cutting/tool_way.h"

#include <algorithm>
#include <cmath>

#include "session/cutting/dog_leg.h"

namespace kadr {
namespace {

constexpr int most_pieces = 4096;    // of one turn: chords of 0.1 µm on a radius of 100 m
constexpr double same_place = 1e-9;  // mm
constexpr double leans = 1e-9;       // of the tool's direction, sine

bool is_upright(Vec3 direction) { return std::hypot(direction.x, direction.y) < leans && direction.z > 0; }

}  // namespace

bool is_cutting(MotionKind kind) { return kind != MotionKind::rapid && kind != MotionKind::home && kind != MotionKind::probe; }

ToolWay::ToolWay(const AxisRoles& roles, double chord, std::optional<std::uint8_t> system, const std::optional<Axes>& apart)
    : chain_(roles), chord_(chord), system_(system), apart_(apart) {}

/// Where rotary axes or a frame in space are, the work space knows the place in the part; else it is the sum of origin and coordinates.
Vec3 ToolWay::tip_of(const Step& step, const Axes& work, double part) const {
  const WorkSpace* const space = step.from.space.get();
  if (space != nullptr && space->has_rotary())
    return space->pose(machine_along(step.roles, step.from, *step.motion(), work, part)).tip + space->zero();
  if (!placement_.is_plain() && space != nullptr) return chain_.tip(space, work) + zero_of(chain_, placement_);
  Axes tip = placement_.machine_of(work);
  for (std::size_t i = 0; i < max_axes; ++i) tip[i] -= placement_.length[i];
  return chain_.tip(tip);
}

/// A rapid motion whose axes go apart: pieces from bend to bend. Where rotary axes turn tool or part its way counts as a line.
bool ToolWay::bent(const Step& step, std::vector<WayPiece>& pieces) const {
  const auto leg = DogLeg::of(step, apart_);
  if (!leg || (step.from.space && step.from.space->has_rotary())) return false;
  const Vec3 start = tip_of(step, step.from.work, 0), way = tip_of(step, step.motion()->to, 1) - start;
  const auto gone = [&](std::size_t letter, double part) {
    const int axis = step.roles.xyz[letter];
    return axis < 0 ? part : leg->gone(std::size_t(axis), part);
  };
  Vec3 from = start;
  double begins = 0;
  for (const double part : leg->corners()) {
    const Vec3 to = start + Vec3{gone(0, part) * way.x, gone(1, part) * way.y, gone(2, part) * way.z};
    if (length(to - from) > same_place) pieces.push_back({from, to, begins, part});
    from = to;
    begins = part;
  }
  return true;
}

bool ToolWay::take(const Step& step, std::vector<WayPiece>& pieces) {
  pieces.clear();
  if (const auto* const frame = std::get_if<FrameChange>(&step.action.what)) placement_ = frame->placement;
  const Motion* const motion = step.motion();
  if (motion == nullptr) return true;
  if (!zero_ && (system_ ? motion->system == *system_ : is_cutting(motion->kind))) zero_ = present_zero();
  if (bent(step, pieces)) return true;
  const Curve& curve = step.curve();
  const WorkSpace* const space = step.from.space.get();
  const bool turns = space != nullptr && space->has_rotary();
  if (turns && !(is_upright(space->pose(step.from.machine).direction) && is_upright(space->pose(motion->machine).direction))) return false;
  const int count = curve.straight() && !turns ? 1 : std::min(curve.pieces(chord_), most_pieces * (1 + int(std::min(motion->turns, 1e4))));
  Vec3 from = tip_of(step, step.from.work, 0);
  for (int i = 1; i <= count; ++i) {
    const double part = double(i) / count;
    const Vec3 to = tip_of(step, i == count ? motion->to : curve.at(part), part);
    if (length(to - from) > same_place) pieces.push_back({from, to, double(i - 1) / count, part});
    from = to;
  }
  return true;
}

}  // namespace kadr
