// path/compensation/nose_tip on random contours. The slow reference is the nose circle at samples of the tip's path. fanuc-t 7.2.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "contours.h"
#include "path/compensation/nose_tip.h"
#include "path/compensation/radius_compensation.h"
#include "path/curve/plane_distance.h"

namespace kadr::nose_contour_test {
namespace {

using test::any_number;
using test::Contour;

/// A random contour with its entry and exit. Corners may be inside, outside or tangential.
Contour any_contour(std::int8_t side, double radius) {
  Contour c;
  c.line(20, side, radius).side_step = SideStep::begins;
  for (int i = *rc::gen::inRange(1, 8); i > 0; --i) {
    c.direction = rotated(c.direction, any_number(-60, 140));
    if (*rc::gen::arbitrary<bool>()) c.line(any_number(20, 60), side, radius);
    else c.arc(any_number(10, 60), any_number(-300, 300) / 1000 + 0.0005, side, radius);
  }
  c.line(20, 0, radius).side_step = SideStep::ends;
  return c;
}

/// Compensates the motions; nullopt after an alarm, for example if the offsets do not meet.
std::optional<std::vector<Motion>> compensated(const std::vector<Motion>& motions) {
  RadiusCompensation compensation{ToolPosition{}};
  ActionBatch batch;
  for (const Motion& m : motions) batch.add() = test::action(m);
  if (compensation.take(batch, true)) return std::nullopt;
  std::vector<Motion> path;
  for (const Action& action : batch) path.push_back(std::get<Motion>(action.what));
  return path;
}

std::vector<Motion> with_nose(std::vector<Motion> motions, std::uint8_t nose, CompensationApproach entry) {
  for (Motion& m : motions) {
    m.nose = nose;
    m.entry = entry;
  }
  return motions;
}

RC_GTEST_PROP(nose_contour, the_tips_path_is_that_of_the_centre_moved_by_one_vector, ()) {
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const auto nose = static_cast<std::uint8_t>(*rc::gen::inRange(0, 10));
  const auto entry = *rc::gen::element(CompensationApproach::by_corner, CompensationApproach::square, CompensationApproach::normal);
  const double radius = any_number(1, 3);
  const Contour c = any_contour(side, radius);
  const auto centre = compensated(with_nose(c.motions, 0, entry)), tip = compensated(with_nose(c.motions, nose, entry));
  RC_ASSERT(centre.has_value() == tip.has_value());
  if (!centre) return;
  RC_ASSERT(centre->size() == tip->size());
  const Vec2 by = nose_vector(nose, radius);
  for (std::size_t i = 0; i < centre->size(); ++i) {
    const Motion &a = (*centre)[i], &b = (*tip)[i];
    RC_ASSERT(a.kind == b.kind);
    const Vec2 expected = i + 1 < centre->size() ? by : Vec2{};  // at the end of the exit, the tip is at the programmed point
    RC_ASSERT(length(Vec2{b.to[0] - a.to[0], b.to[1] - a.to[1]} - expected) < 1e-9);
    if (is_arc(a.kind)) RC_ASSERT(length(b.center - a.center - by) < 1e-9 && a.turns == b.turns);
  }
}

PlanePiece piece_of(const Motion& m, Vec2 from) {
  const Vec2 to{m.to[0], m.to[1]};
  if (!is_arc(m.kind)) return PlanePiece::line(from, to);
  return PlanePiece::arc(from, to, m.center, m.kind == MotionKind::arc_ccw ? m.turns : -m.turns);
}

// The slow twin: the nose circle at samples of the tip's path touches the contour and does not cut it.
RC_GTEST_PROP(nose_contour, the_nose_touches_the_contour_and_does_not_cut_it, ()) {
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const auto nose = static_cast<std::uint8_t>(*rc::gen::inRange(0, 10));
  const double radius = any_number(1, 5);
  const std::array<bool, 2> arc{*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
  const int most = arc[0] || arc[1] ? 60 : 140;  // at most this angle keeps the elements apart
  Contour c;
  c.line(20, side, radius).side_step = SideStep::begins;
  for (std::size_t i = 0; i < arc.size(); ++i) {
    if (arc[i]) c.arc(any_number(40, 80), *rc::gen::element(0.2, -0.2), side, radius);
    else c.line(any_number(60, 100), side, radius);
    if (i == 0) c.direction = rotated(c.direction, any_number(-most, most));
  }
  c.line(20, 0, radius).side_step = SideStep::ends;
  const auto path = compensated(with_nose(c.motions, nose, CompensationApproach::square));
  RC_ASSERT(path.has_value());
  std::vector<PlanePiece> contour;
  Vec2 at{20, 0};
  for (std::size_t i = 1; i + 1 < c.motions.size(); ++i) {
    contour.push_back(piece_of(c.motions[i], at));
    at = {c.motions[i].to[0], c.motions[i].to[1]};
  }
  const auto nearest = [&](Vec2 p) {
    double least = 1e9;
    for (const PlanePiece& piece : contour) least = std::min(least, distance(PlanePiece::line(p, p), piece));
    return least;
  };
  const Vec2 by = nose_vector(nose, radius);
  const std::vector<Motion> cutting(path->begin() + 1, path->end() - 1);
  std::size_t touching = 0, all = 0;
  for (const Vec2 tip : test::sampled(cutting, path->front().to)) {
    const double gap = nearest(tip - by) - radius;
    RC_ASSERT(gap > -10 * tol::same_point);
    RC_ASSERT(gap < 1.3 * radius);  // an acute corner: at most √5 radii from the corner
    touching += std::fabs(gap) < 10 * tol::same_point ? 1 : 0;
    ++all;
  }
  RC_ASSERT(2 * touching > all);  // only on the way around the corner does the nose leave the contour
}

// A mirrored program with the mirrored tip on the other side gives the mirrored path.
RC_GTEST_PROP(nose_contour, a_mirrored_program_gives_the_mirrored_path, ()) {
  constexpr std::array<std::uint8_t, 10> mirrored_nose{0, 4, 3, 2, 1, 5, 8, 7, 6, 9};
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const auto nose = static_cast<std::uint8_t>(*rc::gen::inRange(0, 10));
  const double radius = any_number(1, 3);
  const Contour c = any_contour(side, radius);
  std::vector<Motion> mirrored = with_nose(c.motions, mirrored_nose[nose], CompensationApproach::square);
  for (Motion& m : mirrored) {
    m.to[1] = -m.to[1];
    m.machine = m.to;
    m.center.y = -m.center.y;
    m.side = static_cast<std::int8_t>(-m.side);
    if (is_arc(m.kind)) m.kind = m.kind == MotionKind::arc_cw ? MotionKind::arc_ccw : MotionKind::arc_cw;
  }
  const auto path = compensated(with_nose(c.motions, nose, CompensationApproach::square)), other_path = compensated(mirrored);
  RC_ASSERT(path.has_value() == other_path.has_value());
  if (!path) return;
  RC_ASSERT(path->size() == other_path->size());
  for (std::size_t i = 0; i < path->size(); ++i) {
    RC_ASSERT(std::fabs((*path)[i].to[0] - (*other_path)[i].to[0]) < 1e-9);
    RC_ASSERT(std::fabs((*path)[i].to[1] + (*other_path)[i].to[1]) < 1e-9);
  }
}

}  // namespace
}  // namespace kadr::nose_contour_test
