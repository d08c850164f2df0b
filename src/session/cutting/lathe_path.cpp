// Converts steps of a lathe's program to paths in the half plane. Used by session/cutting/turned_cutting; tested by tests/run_cut.py.

#include "session/cutting/lathe_path.h"

#include <algorithm>
#include <cmath>

#include "session/cutting/dog_leg.h"

namespace kadr {
namespace {

constexpr double no_travel = 1e-9;  // mm or degrees; travel below this is none
constexpr int most_chords = 4096;   // chords per revolution of an arc
// Parts of a motion at which an arc that leaves the plane of its ends, also a full circle, is outside this plane.
constexpr double between[] = {0.2, 0.5, 0.8};

}  // namespace

/// Returns the machine position of Z0, mm. A shift by G50 X Z is left out, since it states where the tip of one tool is.
double LathePath::origin() const {
  const auto z = std::size_t(roles_.xyz[2]);
  const bool restated = shifted_ && roles_.xyz[0] >= 0 && std::fabs((*shifted_)[std::size_t(roles_.xyz[0])]) > no_travel;
  return placement_.origin[z] - (restated ? (*shifted_)[z] : 0);
}

/// `radius`: the axis along which the tool turns.
Vec2 LathePath::place_of(const Axes& work, int radius) const { return {work[std::size_t(radius)], work[std::size_t(roles_.xyz[2])]}; }

/// Returns the axis, X or Y, along which the motion is in a plane through the axis of the part; nullopt if it is in neither plane.
std::optional<int> LathePath::radius_of(const Step& step) const {
  const auto stays_at_0 = [&](int axis) {
    if (axis < 0) return true;
    const auto is_0 = [axis](const Axes& work) { return std::fabs(work[std::size_t(axis)]) <= no_travel; };
    const Curve& curve = step.curve();
    return is_0(step.motion()->to) && is_0(step.from.work) &&
           (curve.straight() || std::all_of(std::begin(between), std::end(between), [&](double part) { return is_0(curve.at(part)); }));
  };
  if (stays_at_0(roles_.xyz[1])) return roles_.xyz[0];
  return stays_at_0(roles_.xyz[0]) ? std::optional(roles_.xyz[1]) : std::nullopt;
}

bool LathePath::turns_part(const Step& step) const {
  if (step.from.space != nullptr || step.curve().surface() != PathSurface::plane) return true;
  for (std::size_t i = 0; i < roles_.count; ++i)
    if (roles_.is_rotary(i) && std::fabs(step.motion()->machine[i] - step.from.machine[i]) > no_travel) return true;
  return false;
}

void LathePath::add_rapid(const Step& step, int radius, LatheMotion& motion) const {
  const Vec2 from = place_of(step.from.work, radius), to = place_of(step.motion()->to, radius);
  const auto leg = DogLeg::of(step, apart_);
  if (leg)
    for (const double part : leg->corners()) {
      if (part >= 1) continue;
      const double x = leg->gone(std::size_t(radius), part), z = leg->gone(std::size_t(roles_.xyz[2]), part);
      motion.corners.push_back({from.x + x * (to.x - from.x), from.y + z * (to.y - from.y)});
      motion.parts.push_back(part);
    }
}

std::optional<LatheMotion> LathePath::take(const Step& step) {
  if (const auto* const frame = std::get_if<FrameChange>(&step.action.what)) placement_ = frame->placement, shifted_ = frame->shifted;
  const Motion* const motion = step.motion();
  if (motion == nullptr || roles_.xyz[0] < 0 || roles_.xyz[2] < 0) return std::nullopt;
  LatheMotion path;
  path.origin = origin();
  const std::optional<int> own_radius = radius_of(step);
  const int radius = own_radius.value_or(roles_.xyz[0]);
  path.off_plane = !own_radius || turns_part(step);
  path.corners.push_back(place_of(step.from.work, radius));
  path.parts.push_back(0);
  const Curve& curve = step.curve();
  if (curve.straight()) {
    add_rapid(step, radius, path);
  } else if (!path.off_plane) {
    const int count = std::min(curve.pieces(chord_), most_chords * (1 + int(std::min(motion->turns, 1e3))));
    for (int i = 1; i < count; ++i) {
      path.corners.push_back(place_of(curve.at(double(i) / count), radius));
      path.parts.push_back(double(i) / count);
    }
  }
  path.corners.push_back(place_of(motion->to, radius));
  path.parts.push_back(1);
  const bool moves =
      std::any_of(path.corners.begin(), path.corners.end(), [&](Vec2 corner) { return length(corner - path.corners.front()) > no_travel; });
  if (!moves) path.corners.clear(), path.parts.clear();
  return path;
}

}  // namespace kadr
