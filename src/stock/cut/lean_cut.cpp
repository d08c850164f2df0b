// Cuts with a tilted tool: the part that handles no lanes, and the selection of the vector width. Used by stock/stock.

#include "stock/cut/lean_cut.h"

#include "base/matrix.h"
#include "stock/cut/lean_cutter.h"

namespace kadr {
namespace {

constexpr float square_reach = 2 * 1.41422f;  // distance from the middle of a square of 4 × 4 lines to its corners, in cells

/// Enlarges the body for lines through the middles of squares: sideways by the size of a square, and vertically by the difference in
/// height that results from this. Rounded edges count as sharp.
LeanBody around_squares(const LeanBody& body, const LeanSweep& s, const BrickScale& scale) {
  const float aside = square_reach * scale.cell, room = s.guess_error() + scale.cell * 1e-3f;
  LeanBody around = body.larger(aside + room);
  if (body.kind == LeanBody::Kind::cone) return around;
  const float rise = aside * std::sqrt(s.axes[0][2] * s.axes[0][2] + s.axes[1][2] * s.axes[1][2]) + room;
  if (body.kind == LeanBody::Kind::rounded) around.kind = LeanBody::Kind::cylinder;
  const float low = body.kind == LeanBody::Kind::ball ? body.shaft.low : body.low(), widest = body.widest() + aside + room;
  around.shaft = {low - rise, body.shaft.high + rise, widest, widest};
  return around;
}

float half_shift(const LeanSweep& s) {
  const float length = std::sqrt(s.shift[0] * s.shift[0] + s.shift[1] * s.shift[1] + s.shift[2] * s.shift[2]);
  return length / 2 + s.guess_error() + 1e-4f;
}

/// Returns a cylinder, in the pose half way, that encloses everything the body sweeps; for a ball end, everything its shaft sweeps.
Frustum bounds_of(const LeanBody& body, const LeanSweep& s) {
  const float room = s.guess_error() + 1e-4f, rise = std::fabs(s.shift[2]) / 2 + room,
              beside = std::sqrt(s.shift[0] * s.shift[0] + s.shift[1] * s.shift[1]) / 2 + room;
  const float low = body.kind == LeanBody::Kind::ball ? body.shaft.low : body.low(), widest = body.widest() + beside;
  return {low - rise, body.high() + rise, widest, widest};
}

}  // namespace

LeanSweep::LeanSweep(const LeanWay& way, Vec3 corner, double edge) {
  const ToolEnds ends(way);
  const Vec3 centre = corner + edge / 2 * Vec3{1, 1, 1}, first = ends.first(centre), last = ends.last(centre);
  half_turn = float(way.turn() / 2);
  reach = float(edge / 2 * std::sqrt(3.0));
  const Vec3 away = ends.halfway(centre) - 0.5 * (first + last);
  bend = float(std::sqrt(dot(away, away))) + half_turn * half_turn / 2 * reach;
  for (int d = 0; d < 3; ++d) {
    tips[0][d] = float(along(way.from - centre, d)), tips[1][d] = float(along(way.to - centre, d));
    directions[0][d] = float(along(way.from_direction, d)), directions[1][d] = float(along(way.to_direction, d));
    middle[d] = float((along(first, d) + along(last, d)) / 2);
    shift[d] = float(along(last, d) - along(first, d));
    aside[d] = float(along(away, d));
    Vec3 axis;
    along(axis, d) = 1;
    const Vec3 a = ToolEnds::in(ends.axes_first, axis), b = ToolEnds::in(ends.axes_last, axis);
    const Vec3 sum = a + b;
    const double per = 1 / std::sqrt(dot(sum, sum));  // normalises the mean direction, which is too short by turn² / 8
    for (int i = 0; i < 3; ++i) {
      axes[d][i] = float(per * (along(a, i) + along(b, i)));
      axes_first[d][i] = float(along(a, i)), axes_last[d][i] = float(along(b, i));
      shift_grows[d][i] = float(along(b, i) - along(a, i));
    }
  }
}

LeanCutter::LeanCutter(Brick& brick, const BrickScale& scale, const LeanCut& cut, std::int32_t by, CutOutcome& outcome, LineSet& later)
    : Cutter(brick, scale, cut.tip, cut.upright_body, by, outcome),
      lean_(cut.sweep),
      body_leaning_(cut.body),
      outer_(cut.sweep.half_turn > 0 ? cut.body.larger(cut.sweep.guess_error()) : cut.body),
      around_square_(around_squares(cut.body, cut.sweep, scale)),
      half_(scale.edge / 2),
      around_(bounds_of(cut.body, cut.sweep)),
      near_(faces_near()),
      shifts_little_(half_shift(cut.sweep) < 2 * scale.cell),
      around_columns_(bounds_of(around_square_, cut.sweep)),
      widest_(cut.body.widest() + 2 * cut.sweep.guess_error() + margin()),
      ball_(ball_way(cut.body.corner)),
      below_shaft_(is_below_shaft()),
      only_(cut.only),
      later_(later) {}

/// Returns the path of the centre of a ball end.
BallWay LeanCutter::ball_way(float radius) const {
  BallWay way{{}, {}, radius};
  for (int d = 0; d < 3; ++d) {
    way.from[d] = lean_.tips[0][d] + body_leaning_.middle * lean_.directions[0][d];
    way.to[d] = lean_.tips[1][d] + body_leaning_.middle * lean_.directions[1][d];
  }
  return way;
}

/// Returns for each line the interval from the start of its first interval to the end of its last one.
void LeanCutter::material_of_all(const BrickLines& lines, float* from, float* to) {
  std::copy(lines.from, lines.from + brick_lines, from), std::copy(lines.to, lines.to + brick_lines, to);
  for (const FurtherInterval& f : lines.further) {
    const bool any = from[f.line] < to[f.line];
    from[f.line] = any ? std::min(from[f.line], f.from) : f.from, to[f.line] = any ? std::max(to[f.line], f.to) : f.to;
  }
}

/// True if all points of the brick are always below the lower face of the shaft, which is inside the ball: then the ball alone cuts.
bool LeanCutter::is_below_shaft() const {
  float high = lean_.middle[2] + std::fabs(lean_.shift[2]) / 2 + lean_.guess_error() + margin();
  for (int d = 0; d < 3; ++d) high += std::fabs(lean_.axes[d][2]) * half_;
  return high < body_leaning_.shaft.low;
}

/// Finds out which flat faces of the body can be in the brick, with a margin for enlarged bodies.
FacesNear LeanCutter::faces_near() const {
  float reach = std::fabs(lean_.shift[2]) * 1.5f + lean_.guess_error() + 4 * scale_.cell;
  for (int d = 0; d < 3; ++d) reach += std::fabs(lean_.axes[d][2]) * half_;
  const float low = lean_.middle[2] - reach, high = lean_.middle[2] + reach;
  const auto in = [&](float height) { return height >= low && height <= high; };
  FacesNear near;
  near.low = body_leaning_.kind != LeanBody::Kind::ball && in(body_leaning_.shaft.low), near.high = in(body_leaning_.shaft.high);
  return near;
}

/// True if the brick is inside the shaft in the pose half way.
bool LeanCutter::takes_all() const {
  const Frustum& f = body_leaning_.shaft;
  const float reach = lean_.reach + lean_.guess_error(), height = lean_.middle[2];
  if (!(f.high > f.low) || height - reach < f.low || height + reach > f.high) return false;
  const float radius = std::sqrt(lean_.middle[0] * lean_.middle[0] + lean_.middle[1] * lean_.middle[1]) + reach;
  return radius < std::min(f.low_radius, f.high_radius);
}

bool may_reach(const LeanSweep& s, const LeanBody& body, const BrickScale& scale, float top) {
  const float half = scale.edge / 2, tall = top / 2, room = half_shift(s) + scale.cell * 1e-3f;
  float at[3], size[3][3];  // middle and half edges of the material's box, in the tool's coordinates in the pose half way
  for (int i = 0; i < 3; ++i) {
    at[i] = s.middle[i] + s.axes[2][i] * (tall - half);
    size[0][i] = s.axes[0][i] * half, size[1][i] = s.axes[1][i] * half, size[2][i] = s.axes[2][i] * tall;
  }
  /// Returns the least value over the box of the scalar product with the vector x, y, z.
  const auto least = [&](float x, float y, float z) {
    float sum = at[0] * x + at[1] * y + at[2] * z;
    for (const auto& d : size) sum -= std::fabs(d[0] * x + d[1] * y + d[2] * z);
    return sum;
  };
  if (least(0, 0, 1) > body.high() + room || least(0, 0, -1) > -body.low() + room) return false;
  const float square = at[0] * at[0] + at[1] * at[1];
  if (least(at[0], at[1], 0) > std::sqrt(square) * (body.widest() + room)) return false;
  const float below = at[2] - body.middle;
  if (body.kind != LeanBody::Kind::ball || below >= 0) return true;
  return least(at[0], at[1], below) - body.middle * below <= std::sqrt(square + below * below) * (body.corner + room);
}

LineSet cut_brick_leaning(Brick& brick, const BrickScale& scale, const LeanCut& cut, std::int32_t by, CutOutcome& outcome,
                          LaneWidth width) {
  LineSet later;
  LeanCutter cutter(brick, scale, cut, by, outcome, later);
  if (cutter.takes_all()) {
    cutter.clear();
    return later;
  }
  width == LaneWidth::wide ? cut_leaning_wide(cutter) : cut_leaning_pair(cutter);
  cutter.end();
  return later;
}

}  // namespace kadr
