// G5, G5.1, G5.2, G5.3: curves in X and Y (spec/linuxcnc 7.7; convert_spline, convert_nurbs of LinuxCNC's source). The checks are in the
// order of that source. Tested by tests/cases/linuxcnc/splines.cases.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/plane_spline.h"
#include "base/code_literals.h"
#include "control/emitter.h"
#include "control/functions/functions.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {
namespace {

constexpr std::uint8_t x_axis = 0, y_axis = 1;
constexpr AxisMask in_xy = AxisMask{1} << x_axis | AxisMask{1} << y_axis;

tl::unexpected<Alarm> spline_fault(const BlockContext& m, Span where, std::string text) {
  return linuxcnc_of(m).fault(AlarmId::rs274_motion, where, std::move(text));
}

Vec2 in_plane_xy(const Axes& axes) { return {axes[x_axis], axes[y_axis]}; }

/// Moves along the curve to its last point. Only X and Y move.
void match_paths(Emitter& m, const std::vector<ControlPoint>& points, std::size_t order) {
  Axes end = m.position.programmed;
  end[x_axis] = points.back().at.x;
  end[y_axis] = points.back().at.y;
  m.move_to(end, end, in_xy);
  Motion& motion = m.add_motion(MotionKind::spline, in_xy);
  motion.first = x_axis;
  motion.second = y_axis;
  m.set_feed(motion);
  auto detail = motion.detail ? std::make_shared<MotionDetail>(*motion.detail) : std::make_shared<MotionDetail>();
  detail->spline.curve = std::make_shared<PlaneSpline>(points, order);
  motion.detail = std::move(detail);
}

Status spline_feed(const BlockContext& m, Span where) {
  if (m.modal.feed_mode == FeedMode::inverse_time)
    return m.has('F') ? Status() : Status(spline_fault(m, where, "F word missing with inverse time arc move"));
  if (m.modal.feed_mode == FeedMode::per_minute && !(m.modal.feed_known && m.modal.feed > 0))
    return spline_fault(m, where, "Cannot make arc with zero feed rate");
  return {};
}

/// Returns the end point of the curve of G5 and G5.1.
Result<Vec2> end_in_xy(BlockContext& m, Span where) {
  KADR_TRY(spline_feed(m, where));
  if (m.modal.plane != Plane::xy || is_plane_of_uvw(m)) return spline_fault(m, where, "Splines must be in the XY plane");
  for (const char letter : {'Z', 'A', 'B', 'C'})
    if (m.has(letter)) return spline_fault(m, where, "Splines may not have motion in Z, A, B, or C");
  AxisMask named = 0;
  Axes end;
  KADR_TRY(m.target(end, named));
  return in_plane_xy(end);
}

Vec2 words_of(const BlockContext& m, char x, char y) { return {m.length_value(x), m.length_value(y)}; }

/// Returns the weight of a control point, the word P. In the first block with X and Y, LinuxCNC uses -1 for a missing P. LinuxCNC also uses
/// a P of 0 or less, so that the curve runs to infinity; Kadr warns and uses 1.
double weight_of(Emitter& m, Span where) {
  const double weight = m.has('P') ? m.value('P') : -1;
  if (weight > 0) return weight;
  m.warn(warning(AlarmId::spline_weight_missing, where));
  return 1;
}

/// Checks the words of a block with G5.2, as LinuxCNC does.
Status control_point_words(const BlockContext& m, const std::vector<ControlPoint>& points, Span where) {
  const bool x = m.has('X'), y = m.has('Y');
  const double weight = m.has('P') ? m.value('P') : -1;
  if (x != y) return spline_fault(m, where, "You must specify both X and Y coordinates for Control Points");
  if (!x && weight > 0 && !points.empty()) return spline_fault(m, where, "Can specify P without X and Y only for the first control point");
  if (!(weight > 0) && !points.empty()) return spline_fault(m, where, "Must specify positive weight P for every Control Point");
  if (m.modal.feed_mode == FeedMode::per_minute && !(m.modal.feed_known && m.modal.feed > 0))
    return spline_fault(m, where, "Cannot make a NURBS with 0 feedrate");
  return {};
}

/// Warns of words that LinuxCNC accepts without using them.
void warn_ignored_words(Emitter& m) {
  for (const char letter : {'Z', 'A', 'B', 'C', 'U', 'V', 'W'})
    if (m.has(letter)) m.warn(warning(AlarmId::spline_word_ignored, m.where(letter), letter));
}

}  // namespace
}  // namespace kadr::linuxcnc

namespace kadr::functions {

using linuxcnc::linuxcnc_of;

/// G5: moves along a curve of third degree. P and Q give its tangent at the end. I and J give its tangent at the start; without I and J the
/// curve continues in the direction of the previous curve.
Status cubic_spline(Emitter& m, const Call& call) {
  auto end = linuxcnc::end_in_xy(m, call.where);
  if (!end) return fail(end.error());
  if (m.has('I') != m.has('J')) return linuxcnc::spline_fault(m, call.where, "Must specify both I and J, or neither");
  if (!m.has('P') || !m.has('Q')) return linuxcnc::spline_fault(m, call.where, "Must specify both P and Q with G5");
  const Vec2 start = linuxcnc::in_plane_xy(m.position.programmed);
  CycleMemory& memory = m.cycle_memory;  // in LinuxCNC the cycle G87 uses the same stored I and J
  const Vec2 out = m.has('I') ? linuxcnc::words_of(m, 'I', 'J') : Vec2{memory.i, memory.j};
  const Vec2 in = linuxcnc::words_of(m, 'P', 'Q');
  linuxcnc::match_paths(m, {{start}, {start + out}, {*end + in}, {*end}}, 4);
  memory.i = -in.x;
  memory.j = -in.y;
  return {};
}

/// G5.1: moves along a parabola.
Status quadratic_spline(Emitter& m, const Call& call) {
  auto end = linuxcnc::end_in_xy(m, call.where);
  if (!end) return fail(end.error());
  if (!m.has('I') || !m.has('J')) return linuxcnc::spline_fault(m, call.where, "Must specify both I and J with G5.1");
  const Vec2 start = linuxcnc::in_plane_xy(m.position.programmed);
  linuxcnc::match_paths(m, {{start}, {start + linuxcnc::words_of(m, 'I', 'J')}, {*end}}, 3);
  return {};
}

/// G5.2: adds a control point; the tool does not move.
Status nurbs_point(Emitter& m, const Call& call) {
  linuxcnc::State& state = linuxcnc_of(m).state;
  std::vector<ControlPoint>& points = state.nurbs;
  if (state.motion != call.row->tenth) points.clear();
  KADR_TRY(linuxcnc::control_point_words(m, points, call.where));
  const bool named = m.has('X');
  if (points.empty()) {
    points.push_back({linuxcnc::in_plane_xy(m.position.programmed), !named && m.has('P') ? m.value('P') : 1});
    if (!(points.front().weight > 0)) points.front().weight = 1;
    state.nurbs_order = 3;
  }
  const double order = m.has('L') ? std::round(m.value('L')) : -1;
  if (order > 3) state.nurbs_order = static_cast<std::size_t>(std::min(order, 1e6));
  linuxcnc::warn_ignored_words(m);
  if (!named) return {};
  AxisMask words = 0;
  Axes end;
  KADR_TRY(m.target(end, words));
  if (points.size() == PlaneSpline::max_points)
    return fail(alarm(AlarmId::spline_too_large, call.where, double{PlaneSpline::max_points}, double{PlaneSpline::most_order}));
  points.push_back({linuxcnc::in_plane_xy(end), linuxcnc::weight_of(m, call.where)});
  return {};
}

/// G5.3: moves along the curve that the control points of G5.2 define.
Status nurbs_end(Emitter& m, const Call& call) {
  linuxcnc::LinuxCnc& control = linuxcnc_of(m);
  linuxcnc::State& state = control.state;
  constexpr std::int32_t control_point = 5.2_g;
  if (control.codes.g1() >= 0 && control.codes.g1() != control_point)
    return linuxcnc::spline_fault(m, call.where, "Between G5.2 and G5.3 codes, only additional G5.2 codes are allowed.");
  if (state.motion != control_point) return linuxcnc::spline_fault(m, call.where, "Cannot use G5.3 without G5.2 first");
  if (state.nurbs.size() < state.nurbs_order)
    return linuxcnc::spline_fault(
        m, call.where, fmt::format("You must specify a number of control points at least equal to the order L = {}", state.nurbs_order));
  if (state.nurbs_order > PlaneSpline::most_order)
    return fail(alarm(AlarmId::spline_too_large, call.where, double{PlaneSpline::max_points}, double{PlaneSpline::most_order}));
  linuxcnc::match_paths(m, state.nurbs, state.nurbs_order);
  state.nurbs.clear();
  state.motion = -1;
  m.modal.motion = MotionMode::none;
  m.modal.motion_row = -1;
  return {};
}

}  // namespace kadr::functions
