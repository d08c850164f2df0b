// path/compensation/radius_compensation, path/compensation/interference and path/compensation/gouge_detector together. For every contour, a
// path nearer to the part than the tool's radius is reported, and whatever is reported is true. The slow reference samples path and
// contour. NCT 15.5. If the contour crosses itself, path/compensation/contour_closing decides what the part is (its own test is
// gouge_detector_test).

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "contours.h"
#include "path/compensation/contour_closing.h"

namespace kadr::contour_safety_test {
namespace {

using test::any_number;
using test::Contour;

constexpr double tool = 5;

/// Returns lines and arcs with corners of any angle, tiny segments, nearly tangential joints, and arcs about as large as the tool.
Contour any_contour(std::int8_t side) {
  Contour c;
  c.line(20, side, tool).side_step = SideStep::begins;
  const int pieces = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(2, 12));
  for (int i = 0; i < pieces; ++i) {
    const auto joint = *rc::gen::inRange(0, 5);
    if (joint == 0) c.direction = rotated(c.direction, any_number(-120, 120));
    else if (joint == 1) c.direction = rotated(c.direction, any_number(-5, 5) * 1e-4);
    else if (joint == 2) c.direction = rotated(c.direction, any_number(-60, 60));
    if (*rc::gen::arbitrary<bool>()) {
      const double turns = *rc::gen::element(1, -1) * *rc::gen::inRange(20, 700) / 1000.0;
      c.arc(*rc::gen::element(0, 1) == 0 ? any_number(1, 30) : tool + *rc::gen::inRange(-20, 21) * 1e-3, turns, side, tool);
    } else {
      c.line(*rc::gen::element(0, 1) == 0 ? any_number(1, 60) : *rc::gen::inRange(1, 2000) * 1e-3, side, tool);
    }
  }
  c.line(20, 0, tool).side_step = SideStep::ends;
  return c;
}

CompensationCheck any_check() {
  CompensationCheck check;
  check.interference = *rc::gen::arbitrary<bool>();
  check.always_alarm = *rc::gen::arbitrary<bool>();
  check.further = static_cast<std::uint8_t>(*rc::gen::inRange(0, 9));
  return check;
}

struct Outcome {
  std::vector<Action> path;
  std::optional<AlarmId> alarm;
  double reported = 0;  // reported depth of the cut, mm
};

Outcome carried_out(const Contour& contour, const CompensationCheck& check) {
  Outcome outcome;
  RadiusCompensation compensation{ToolPosition{}};
  for (std::size_t i = 0; i <= contour.motions.size() && !outcome.alarm; ++i) {
    ActionBatch batch;
    if (i == 0) batch.add().what = check;
    else batch.add() = test::action(contour.motions[i - 1], static_cast<std::uint32_t>(i));
    const auto fault = compensation.take(batch, i == contour.motions.size());
    if (fault) outcome.alarm = fault->alarm.id;
    for (const Action& action : batch) outcome.path.push_back(action);
    for (const CompensationFault& w : compensation.warnings()) outcome.reported = std::max(outcome.reported, w.alarm.args[0].number());
  }
  return outcome;
}

/// Returns points of the part's contour, without the parts of the path before and after the closed loop.
std::vector<Vec2> part_of(const Contour& contour) {
  std::vector<PlanePiece> pieces;
  for (std::size_t i = 1; i + 1 < contour.motions.size(); ++i) {
    const Motion& m = contour.motions[i];
    const Vec2 from{contour.motions[i - 1].to[0], contour.motions[i - 1].to[1]}, to{m.to[0], m.to[1]};
    pieces.push_back(is_arc(m.kind) ? PlanePiece::arc(from, to, m.center, m.kind == MotionKind::arc_ccw ? m.turns : -m.turns)
                                    : PlanePiece::line(from, to));
  }
  const ContourLoop loop = closing(pieces, 0).value_or(ContourLoop{0, 0, pieces.size() - 1, 1});
  std::vector<Vec2> points;
  for (std::size_t i = loop.first; i <= loop.last; ++i) {
    const PlanePiece p = cut_out(pieces[i], i == loop.first ? loop.first_part : 0, i == loop.last ? loop.last_part : 1);
    Motion m = test::straight(MotionKind::feed, {p.to.x, p.to.y, 0});
    if (p.is_arc)
      m = test::arc(p.turns > 0 ? MotionKind::arc_ccw : MotionKind::arc_cw, {p.to.x, p.to.y, 0}, {p.center.x, p.center.y, 0},
                    std::fabs(p.turns));
    for (const Vec2 at : test::sampled({m}, {p.from.x, p.from.y})) points.push_back(at);
  }
  return points;
}

/// Returns the least sampled distance between the tool's path along the contour and the part.
double nearest(const Contour& contour, const Outcome& outcome) {
  const std::size_t last_line = contour.motions.size();
  const auto programmed = part_of(contour);
  double least = 1e9;
  Axes from{};
  std::size_t taken = 0;
  for (const Action& action : outcome.path) {
    const auto* const m = std::get_if<Motion>(&action.what);
    if (m == nullptr) continue;
    if (action.origin.line > 1 && action.origin.line < last_line) {
      ++taken;
      for (const Vec2 t : test::sampled({*m}, from))
        for (const Vec2 p : programmed) least = std::min(least, length(t - p));
    }
    from = m->to;
  }
  return taken == 0 ? tool : least;
}

/// Returns the ends of the motions block by block, to report a failure.
std::string shown(const Contour& contour, const Outcome& outcome) {
  std::ostringstream text;
  const auto show = [&](std::uint32_t line, const Motion& m) {
    text << line << (is_arc(m.kind) ? m.kind == MotionKind::arc_cw ? " cw " : " ccw " : " line ") << m.to[0] << ' ' << m.to[1];
    if (is_arc(m.kind)) text << " center " << m.center.x << ' ' << m.center.y << " turns " << m.turns;
    text << '\n';
  };
  text << "told " << outcome.reported << " nearest " << nearest(contour, outcome) << "\nprogrammed, side "
       << static_cast<int>(contour.motions.front().side) << '\n';
  for (std::size_t i = 0; i < contour.motions.size(); ++i) show(static_cast<std::uint32_t>(i + 1), contour.motions[i]);
  text << "path\n";
  for (const Action& action : outcome.path)
    if (const auto* const m = std::get_if<Motion>(&action.what)) show(action.origin.line, *m);
  return text.str();
}

RC_GTEST_PROP(contour_safety, what_is_not_told_does_not_cut, ()) {
  const Contour contour = any_contour(*rc::gen::element<std::int8_t>(1, -1));
  const Outcome outcome = carried_out(contour, any_check());
  RC_CLASSIFY(outcome.alarm.has_value(), "alarm");
  RC_CLASSIFY(!outcome.alarm && outcome.reported == 0, "whole");
  if (outcome.alarm) return;  // a cut before the alarm may become known only together with it
  if (outcome.reported == 0 && nearest(contour, outcome) < tool - 2 * tol::same_point) RC_FAIL(shown(contour, outcome));
}

RC_GTEST_PROP(contour_safety, what_is_told_is_true, ()) {
  const Contour contour = any_contour(*rc::gen::element<std::int8_t>(1, -1));
  const Outcome outcome = carried_out(contour, any_check());
  RC_PRE(!outcome.alarm && outcome.reported > 0);
  if (nearest(contour, outcome) > tool - outcome.reported + test::sampling) RC_FAIL(shown(contour, outcome));
  if (nearest(contour, outcome) < tool - outcome.reported - 2 * tol::same_point) RC_FAIL(shown(contour, outcome));
}

/// Returns the cut reported for a straight contour of six lines after `change` has modified its motions.
template <class Change>
double reported_for_line(const Change& change) {
  Contour c;
  c.line(20, 1, tool).side_step = SideStep::begins;
  for (int i = 0; i < 6; ++i) c.line(20, 1, tool);
  c.line(20, 0, tool).side_step = SideStep::ends;
  change(c.motions);
  return carried_out(c, {}).reported;
}

TEST(contour_safety, what_leaves_the_contour_on_purpose_is_not_told) {
  using Motions = std::vector<Motion>;
  EXPECT_EQ(reported_for_line([](Motions&) {}), 0);
  EXPECT_EQ(reported_for_line([](Motions& m) { m[3].tool_radius = m[4].tool_radius = 0; }), 0);  // D0 … D1
  EXPECT_EQ(reported_for_line([](Motions& m) { m[3].tool_radius = tool / 2; }), 0);
  EXPECT_EQ(reported_for_line([](Motions& m) { m[3].kind = m[4].kind = MotionKind::rapid; }), 0);
  EXPECT_EQ(reported_for_line([](Motions& m) {  // G42 in a block without displacement
              m[0].to = m[0].machine = Axes{};
              m[0].named = 3;
            }),
            0);
  EXPECT_GT(reported_for_line([](Motions& m) {  // around a chamfer too short for the tool
              const std::array<Vec2, 4> ends{Vec2{81, 1}, Vec2{81, 60}, Vec2{81, 80}, Vec2{81, 100}};
              for (std::size_t i = 0; i < ends.size(); ++i) m[4 + i].to = m[4 + i].machine = {ends[i].x, ends[i].y};
            }),
            0);
}

/// Returns true if a motion runs against its programmed direction.
bool runs_back(const Contour& contour, const Outcome& outcome) {
  Axes from{};
  for (const Action& action : outcome.path) {
    const auto* const m = std::get_if<Motion>(&action.what);
    if (m == nullptr) continue;
    const std::size_t block = action.origin.line - 1;
    const Motion& programmed = contour.motions[block];
    const Axes start = block == 0 ? Axes{} : contour.motions[block - 1].to;
    const Vec2 delta{m->to[0] - from[0], m->to[1] - from[1]};
    const Vec2 wanted{programmed.to[0] - start[0], programmed.to[1] - start[1]};
    const bool along = block > 0 && block + 1 < contour.motions.size() && !is_arc(programmed.kind);
    const bool of_block = &action == &outcome.path.back() || (&action)[1].origin.line != action.origin.line;  // without its corner
    if (along && of_block && dot(delta, wanted) < -1e-5 * length(wanted)) return true;
    from = m->to;
  }
  return false;
}

RC_GTEST_PROP(contour_safety, the_check_lets_no_block_run_back, ()) {
  const Contour contour = any_contour(*rc::gen::element<std::int8_t>(1, -1));
  CompensationCheck check = any_check();
  check.interference = true;
  const Outcome outcome = carried_out(contour, check);
  if (runs_back(contour, outcome)) RC_FAIL(shown(contour, outcome));
}

RC_GTEST_PROP(contour_safety, always_alarm_is_only_stricter, ()) {
  const Contour contour = any_contour(*rc::gen::element<std::int8_t>(1, -1));
  CompensationCheck check{true, true, 0, 0};
  const Outcome strict = carried_out(contour, check);
  if (strict.alarm) return;
  check.always_alarm = false;  // nothing to correct: the path stays the same
  const Outcome mended = carried_out(contour, check);
  RC_ASSERT(!mended.alarm);
  RC_ASSERT(mended.path.size() == strict.path.size());
  check.interference = false;
  const Outcome unchecked = carried_out(contour, check);
  RC_ASSERT(unchecked.path.size() == strict.path.size());
  for (std::size_t i = 0; i < strict.path.size(); ++i) {
    const auto *const a = std::get_if<Motion>(&strict.path[i].what), *const b = std::get_if<Motion>(&unchecked.path[i].what);
    RC_ASSERT((a == nullptr) == (b == nullptr));
    if (a != nullptr) RC_ASSERT(a->to == b->to);
  }
}

}  // namespace
}  // namespace kadr::contour_safety_test
