// PathWatch: checks the shape of the contour. It is used by session/checklist and tested by tests/checklist.py.

#include "session/checklist/path_watch.h"

#include <cmath>
#include <set>

namespace kadr {
namespace {

constexpr std::size_t max_kinks = 1000;
constexpr double pi = 3.14159265358979323846;

double degrees_between(Vec2 a, Vec2 b) { return std::fabs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y)) * 180 / pi; }

Vec2 unit(Vec2 v) {
  const double size = length(v);
  return {v.x / size, v.y / size};
}

/// Returns the unit tangent at `point` of a circle about `center`, in the direction of motion.
Vec2 along_circle(Vec2 point, Vec2 center, bool ccw) {
  const Vec2 out = unit(point - center);
  return ccw ? Vec2{-out.y, out.x} : Vec2{out.y, -out.x};
}

/// Returns the mirror image of the vector `v` in a line with the direction `line` (a unit vector).
Vec2 mirrored(Vec2 v, Vec2 line) {
  const double along = v.x * line.x + v.y * line.y;
  return {2 * along * line.x - v.x, 2 * along * line.y - v.y};
}

}  // namespace

std::optional<PathWatch::Piece> PathWatch::piece_of(const Step& step, const Motion& motion) {
  constexpr double least = 1e-4;  // least length of a motion, mm; a shorter motion has no reliable direction and is ignored
  if ((motion.kind != MotionKind::feed && !is_arc(motion.kind)) || motion.of_cycle) return std::nullopt;
  if (motion.detail && (motion.detail->surface != PathSurface::plane || motion.detail->contour)) return std::nullopt;
  Piece p;
  p.origin = step.action.origin;
  p.first = motion.first, p.second = motion.second;
  p.from = {step.from.work[p.first], step.from.work[p.second]};
  p.to = {motion.to[p.first], motion.to[p.second]};
  p.arc = is_arc(motion.kind);
  const double chord = length(p.to - p.from);
  if (!p.arc) {
    if (chord < least) return std::nullopt;
    p.begins = p.ends = 1 / chord * (p.to - p.from);
    return p;
  }
  p.ccw = motion.kind == MotionKind::arc_ccw;
  p.inch = motion.inch;
  p.center = motion.center;
  p.degrees = motion.turns * 360;
  for (std::size_t axis = 0; axis < step.roles.count; ++axis)
    if (axis != p.first && axis != p.second) p.helix = p.helix || std::fabs(motion.to[axis] - step.from.work[axis]) > least;
  p.full = chord < least;
  if (length(p.from - p.center) < least || length(p.to - p.center) < least) return std::nullopt;
  p.begins = along_circle(p.from, p.center, p.ccw);
  p.ends = along_circle(p.to, p.center, p.ccw);
  return p;
}

/// Checks whether the opposite code (G2 instead of G3, or G3 instead of G2) would make the arc tangent to the motions before and after it.
/// If I and J state the centre, the arc of the opposite code has the same centre. If R states the radius, its centre is mirrored in the
/// chord.
void PathWatch::look_at_arc(const Piece& before, const Piece& arc, const Piece& after) {
  if (!arc.arc || arc.full || before.first != arc.first || after.first != arc.first) return;
  constexpr double smooth = 5, corner = 20;  // degrees; greatest angle of a tangent transition, and least angle of a corner
  const auto retraces = [&](const Piece& other) { return other.arc && length(other.center - arc.center) < 0.01; };
  if (kinks_.size() >= max_kinks || retraces(before) || retraces(after)) return;
  const auto kinks = [&](Vec2 begins, Vec2 ends) {
    return std::pair(degrees_between(before.ends, begins), degrees_between(ends, after.begins));
  };
  const auto fits = [](std::pair<double, double> k) { return k.first <= smooth && k.second <= smooth; };
  const auto now = kinks(arc.begins, arc.ends);
  const char* const other = arc.ccw ? "G2" : "G3";
  const Vec2 chord = unit(arc.to - arc.from);
  const bool same_centre = fits(kinks({-arc.begins.x, -arc.begins.y}, {-arc.ends.x, -arc.ends.y}));
  const bool mirrored_centre = fits(kinks(mirrored(arc.begins, chord), mirrored(arc.ends, chord)));
  if (now.first > corner && now.second > corner && (same_centre || mirrored_centre)) kinks_.push_back({arc.origin, other});
}

/// Checks for an arc that is nearly a full circle. A circle is usually programmed with its end equal to its start, so a small gap is
/// probably a mistake. A gap of some micrometres is accepted, since it comes from rounded words.
void PathWatch::look_at_circle(const Piece& arc, Advices& to) {
  // least angle of the arc, degrees; greatest gap as a fraction of the radius; greatest gaps that rounded words may cause, mm: metric, inch
  constexpr double nearly = 340, small = 0.1, fine = 0.0015, coarse = 0.004;
  const double apart = length(arc.to - arc.from);
  const double radius = length(arc.from - arc.center);
  if (arc.arc && !arc.helix && arc.degrees > nearly && arc.degrees < 360 && apart > (arc.inch ? coarse : fine) && apart < small * radius)
    to.add(AlarmId::arc_nearly_full, arc.origin, 'G', std::floor(arc.degrees * 10) / 10, apart);
}

/// Ends the contour. If the contour is closed, its last motions are compared with its first motions too.
void PathWatch::close() {
  constexpr double same = 0.01;  // mm; a contour counts as closed if its end is closer than this to its start
  if (last_[0] && last_[1] && first_.size() > 1) {
    const Vec2 apart = last_[1]->to - first_[0].from;
    if (length(apart) < same) {
      look_at_arc(*last_[0], *last_[1], first_[0]);
      look_at_arc(*last_[1], first_[0], first_[1]);
    }
  }
  first_.clear();
}

void PathWatch::compensation_over(Advices& to) {
  if (side_) to.add(AlarmId::compensation_left_on, *side_, 'G', side_code_);
  side_.reset();
  ended_.reset();
}

void PathWatch::look_at_side(const Step& step, const Motion& motion, Advices& to) {
  const Ends ends(step.roles, step.from, motion);
  const Origin& origin = step.action.origin;
  const double path_length =
      length(Vec2{motion.to[motion.first] - step.from.work[motion.first], motion.to[motion.second] - step.from.work[motion.second]});
  if (motion.side_step == SideStep::begins && motion.tool_radius > 0 && path_length > 0 && path_length < motion.tool_radius)
    to.add(AlarmId::approach_short, origin, 0, path_length, motion.tool_radius);
  const bool compensated = motion.side != 0 || motion.radius_offset != 0;
  const bool ends_here = compensated_ && !compensated && path_length > 0;
  compensated_ = compensated;
  if (motion.side != 0) {
    if (!side_) side_ = origin;
    side_code_ = motion.side > 0 ? "G41" : "G42";
  } else if (!compensated) {
    side_.reset();
  }
  constexpr int certain = 2;  // A compensation that ends during a cut is reported if at least this many cuts follow its end.
  if (ends_here) {
    ended_.reset();
    if (is_cut(motion)) ended_ = origin, cuts_since_ = 0;
  } else if (ended_) {
    const bool goes_on = is_cut(motion) && !compensated && ends.sideways() && std::fabs(ends.to.z - ends.from.z) < 1e-3;
    if (!goes_on) ended_.reset();
    else if (++cuts_since_ == certain) to.add(AlarmId::compensation_ends_in_cut, *ended_, 'G');
  }
}

void PathWatch::take(const Step& step, Advices& to) {
  const Motion* const motion = step.motion();
  if (motion == nullptr) {
    if (const auto* const change = std::get_if<ToolChange>(&step.action.what); change != nullptr && !change->there) compensation_over(to);
    return;
  }
  look_at_side(step, *motion, to);
  auto piece = piece_of(step, *motion);
  if (piece) look_at_circle(*piece, to);
  // On a machine without Y, a lathe, sharp convex arcs at both ends break edges, so nothing follows from their direction
  const bool has_y = step.roles.xyz[1] >= 0;
  if (has_y && piece && last_[0] && last_[1]) look_at_arc(*last_[0], *last_[1], *piece);
  if (!piece) close();
  else if (first_.size() < 2) first_.push_back(*piece);
  last_[0] = piece ? last_[1] : std::nullopt;
  last_[1] = piece;
}

void PathWatch::finish(Advices& to) {
  close();
  // Greatest number of lines with arcs against their neighbours that are reported. More of them are probably intended.
  constexpr std::size_t slips = 2;
  std::set<std::uint32_t> lines;
  for (const auto& [origin, other] : kinks_) lines.insert(origin.line);
  if (lines.size() <= slips)
    for (const auto& [origin, other] : kinks_) to.add(AlarmId::arc_against_neighbours, origin, 'G', other);
  compensation_over(to);
}

}  // namespace kadr
