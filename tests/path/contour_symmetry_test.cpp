// path/compensation/radius_compensation: if the contour is rotated, mirrored, reversed
// or divided, its path is rotated, mirrored, reversed or unchanged. NCT 15.5.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "contours.h"

namespace kadr::contour_symmetry_test {
namespace {

using test::any_number;

constexpr double tool = 4;

/// A single segment of a contour.
struct Piece {
  Vec2 to;
  bool arc = false;
  Vec2 center{};
  double turns = 0;  // counter-clockwise positive
};
struct Pieces {
  Vec2 from;
  std::vector<Piece> all;
};

/// Returns corners to both sides. Segments are long enough for the tool, but may come near each other.
Pieces any_pieces() {
  Pieces p;
  Vec2 at, direction{1, 0};
  const int count = *rc::gen::inRange(1, 8);
  for (int i = 0; i < count; ++i) {
    if (i > 0) direction = rotated(direction, any_number(-100, 100));
    if (*rc::gen::arbitrary<bool>()) {
      const double turns = *rc::gen::element(1, -1) * any_number(50, 400) / 1000, radius = any_number(10, 40);
      const Vec2 center = at + (turns > 0 ? radius : -radius) * left_of(direction);
      at = center + rotated(at - center, 360 * turns);
      direction = rotated(direction, 360 * turns);
      p.all.push_back({at, true, center, turns});
    } else {
      at = at + any_number(20, 60) * direction;
      p.all.push_back({at});
    }
  }
  return p;
}

Motion motion_of(const Piece& piece, std::int8_t side) {
  const Vec3 to{piece.to.x, piece.to.y, 0}, center{piece.center.x, piece.center.y, 0};
  Motion m = piece.arc ? test::arc(piece.turns > 0 ? MotionKind::arc_ccw : MotionKind::arc_cw, to, center, std::fabs(piece.turns))
                       : test::straight(MotionKind::feed, to);
  m.named = 3;
  m.side = side;
  m.tool_radius = tool;
  return m;
}

Vec2 start_tangent(const Pieces& p) {
  const Piece& first = p.all.front();
  return (first.arc ? ContourElement::arc(p.from, first.to, first.center, first.turns) : ContourElement::line(p.from, first.to)).start;
}

/// Returns the ends of the tool's path along the segments, with a straight approach before them.
std::optional<std::vector<Vec2>> path_of(const Pieces& p, std::int8_t side) {
  ToolPosition start{};
  const Vec2 before = p.from - 30 * start_tangent(p);
  start.work[0] = start.machine[0] = before.x;
  start.work[1] = start.machine[1] = before.y;
  RadiusCompensation compensation{start};
  ActionBatch batch;
  batch.add().what = motion_of({p.from}, side);
  std::get<Motion>(batch[0].what).side_step = SideStep::begins;
  for (const Piece& piece : p.all) batch.add().what = motion_of(piece, side);
  if (compensation.take(batch, true)) return std::nullopt;
  std::vector<Vec2> ends;
  for (const Action& a : batch) ends.push_back({std::get<Motion>(a.what).to[0], std::get<Motion>(a.what).to[1]});
  return ends;
}

bool same(const std::optional<std::vector<Vec2>>& a, const std::optional<std::vector<Vec2>>& b, double within = tol::same_point) {
  if (!a || !b) return !a && !b;
  if (a->size() != b->size()) return false;
  for (std::size_t i = 0; i < a->size(); ++i)
    if (length((*a)[i] - (*b)[i]) > within) return false;
  return true;
}

template <class Map>
Pieces mapped(const Pieces& p, double sense, const Map& map) {
  Pieces q{map(p.from), {}};
  for (const Piece& piece : p.all) q.all.push_back({map(piece.to), piece.arc, map(piece.center), sense * piece.turns});
  return q;
}

RC_GTEST_PROP(contour_symmetry, turned, ()) {
  const Pieces p = any_pieces();
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const double angle = any_number(-180, 180);
  const Vec2 shift{any_number(-500, 500), any_number(-500, 500)};
  const auto turn = [&](Vec2 v) { return rotated(v, angle) + shift; };
  auto path = path_of(p, side);
  const auto other = path_of(mapped(p, 1, turn), side);
  if (path)
    for (Vec2& v : *path) v = turn(v);
  RC_ASSERT(same(path, other));
}

RC_GTEST_PROP(contour_symmetry, mirrored, ()) {
  const Pieces p = any_pieces();
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const auto mirror = [&](Vec2 v) { return Vec2{-v.x, v.y}; };
  auto path = path_of(p, side);
  const auto other = path_of(mapped(p, -1, mirror), static_cast<std::int8_t>(-side));
  if (path)
    for (Vec2& v : *path) v = mirror(v);
  RC_ASSERT(same(path, other, 0));  // bit by bit
}

RC_GTEST_PROP(contour_symmetry, reversed, ()) {
  const Pieces p = any_pieces();
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  Pieces back{p.all.back().to, {}};
  for (std::size_t i = p.all.size(); i-- > 0;) {
    const Piece& piece = p.all[i];
    back.all.push_back({i == 0 ? p.from : p.all[i - 1].to, piece.arc, piece.center, -piece.turns});
  }
  auto path = path_of(p, side);
  const auto other = path_of(back, static_cast<std::int8_t>(-side));
  if (path) path = std::vector<Vec2>(path->rbegin(), path->rend());
  RC_ASSERT(same(path, other));
}

RC_GTEST_PROP(contour_symmetry, split, ()) {
  const Pieces p = any_pieces();
  const auto side = *rc::gen::element<std::int8_t>(1, -1);
  const auto which = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(p.all.size())));
  const Vec2 from = which == 0 ? p.from : p.all[which - 1].to;
  Pieces q{p.from, {}};
  Vec2 offset;
  for (std::size_t i = 0; i < p.all.size(); ++i) {
    const Piece& piece = p.all[i];
    if (i != which) {
      q.all.push_back(piece);
      continue;
    }
    Piece half = piece;
    half.turns /= 2;
    half.to = piece.arc ? piece.center + rotated(from - piece.center, 360 * half.turns) : 0.5 * (from + piece.to);
    const Vec2 direction = piece.arc ? (piece.turns > 0 ? 1 : -1) * left_of(half.to - piece.center) : piece.to - from;
    offset = half.to + tool / length(direction) * side_normal(direction, side);
    q.all.push_back(half);
    q.all.push_back({piece.to, piece.arc, piece.center, half.turns});
  }
  const auto path = path_of(p, side);
  auto other = path_of(q, side);
  RC_ASSERT(path.has_value() == other.has_value());
  if (!path) return;
  RC_ASSERT(other->size() == path->size() + 1);  // one more point, at the cut
  const auto cut = std::find_if(other->begin(), other->end(), [&](Vec2 v) { return length(v - offset) < tol::same_point; });
  RC_ASSERT(cut != other->end());
  other->erase(cut);
  RC_ASSERT(same(path, other));
}

}  // namespace
}  // namespace kadr::contour_symmetry_test
