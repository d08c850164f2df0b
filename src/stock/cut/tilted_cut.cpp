// Cuts a brick with a tilted tool: the part of the code that handles single numbers instead of eight lines at once, and the choice of the
// widest vectors that the processor has. Used by stock/stock.

#include "stock/cut/tilted_cut.h"

#include "base/matrix.h"
#include "stock/cut/tilted_cutter.h"

namespace kadr {
namespace {

constexpr float square_reach = 2 * 1.41422f;  // distance from the middle of a square of 4 × 4 lines to its corners, in lattice cells

/// Returns an enlarged body for lines through the middles of squares: larger sideways by the size of a square, and vertically by the
/// resulting difference in height. Rounded edges count as sharp, so the body is never too small.
TiltedBody around_squares(const TiltedBody& body, const TiltedSweep& s, const BrickScale& scale) {
  const float aside = square_reach * scale.cell, room = s.guess_error() + scale.cell * 1e-3f;
  TiltedBody around = body.larger(aside + room);
  if (body.kind == TiltedBody::Kind::cone) return around;
  const float rise = aside * std::sqrt(s.axes[0][2] * s.axes[0][2] + s.axes[1][2] * s.axes[1][2]) + room;
  if (body.kind == TiltedBody::Kind::rounded) around.kind = TiltedBody::Kind::cylinder;
  const float low = body.kind == TiltedBody::Kind::ball ? body.shaft.low : body.low(), widest = body.widest() + aside + room;
  around.shaft = {low - rise, body.shaft.high + rise, widest, widest};
  return around;
}

float half_shift(const TiltedSweep& s) {
  const float length = std::sqrt(s.shift[0] * s.shift[0] + s.shift[1] * s.shift[1] + s.shift[2] * s.shift[2]);
  return length / 2 + s.guess_error() + 1e-4f;
}

/// Returns a cylinder in the pose half way along the path. The cylinder encloses everything that the body sweeps; for a ball end,
/// everything that the shaft sweeps.
Frustum bounds_of(const TiltedBody& body, const TiltedSweep& s) {
  const float room = s.guess_error() + 1e-4f, rise = std::fabs(s.shift[2]) / 2 + room,
              sideways = std::sqrt(s.shift[0] * s.shift[0] + s.shift[1] * s.shift[1]) / 2 + room;
  const float low = body.kind == TiltedBody::Kind::ball ? body.shaft.low : body.low(), widest = body.widest() + sideways;
  return {low - rise, body.high() + rise, widest, widest};
}

}  // namespace

TiltedSweep::TiltedSweep(const TiltedPath& path, Vec3 corner, double edge) {
  const ToolEnds ends(path);
  const Vec3 centre = corner + edge / 2 * Vec3{1, 1, 1}, first = ends.first(centre), last = ends.last(centre);
  half_turn = float(path.turn() / 2);
  reach = float(edge / 2 * std::sqrt(3.0));
  const Vec3 away = ends.halfway(centre) - 0.5 * (first + last);
  bend = float(std::sqrt(dot(away, away))) + half_turn * half_turn / 2 * reach;
  for (int d = 0; d < 3; ++d) {
    tips[0][d] = float(along(path.from - centre, d)), tips[1][d] = float(along(path.to - centre, d));
    directions[0][d] = float(along(path.from_direction, d)), directions[1][d] = float(along(path.to_direction, d));
    middle[d] = float((along(first, d) + along(last, d)) / 2);
    shift[d] = float(along(last, d) - along(first, d));
    aside[d] = float(along(away, d));
    Vec3 axis;
    along(axis, d) = 1;
    const Vec3 a = ToolEnds::in(ends.axes_first, axis), b = ToolEnds::in(ends.axes_last, axis);
    const Vec3 sum = a + b;
    // Factor that makes the sum of the two unit vectors a unit vector. Half this sum is shorter than 1 by turn² / 8, because the tool turns
    // between the two poses.
    const double per = 1 / std::sqrt(dot(sum, sum));
    for (int i = 0; i < 3; ++i) {
      axes[d][i] = float(per * (along(a, i) + along(b, i)));
      axes_first[d][i] = float(along(a, i)), axes_last[d][i] = float(along(b, i));
      shift_grows[d][i] = float(along(b, i) - along(a, i));
    }
  }
}

TiltedCutter::TiltedCutter(Brick& brick, const BrickScale& scale, const TiltedCut& cut, std::int32_t by, CutOutcome& outcome,
                           LineSet& later)
    : Cutter(brick, scale, cut.tip, cut.upright_body, by, outcome),
      tilted_sweep_(cut.sweep),
      tilted_body_(cut.body),
      outer_(cut.sweep.half_turn > 0 ? cut.body.larger(cut.sweep.guess_error()) : cut.body),
      around_square_(around_squares(cut.body, cut.sweep, scale)),
      half_(scale.edge / 2),
      around_(bounds_of(cut.body, cut.sweep)),
      near_(faces_near()),
      shifts_little_(half_shift(cut.sweep) < 2 * scale.cell),
      around_columns_(bounds_of(around_square_, cut.sweep)),
      widest_(cut.body.widest() + 2 * cut.sweep.guess_error() + margin()),
      ball_(ball_path(cut.body.corner)),
      below_shaft_(is_below_shaft()),
      only_(cut.only),
      later_(later) {}

/// Returns the path of the centre of a ball end.
BallPath TiltedCutter::ball_path(float radius) const {
  BallPath path{{}, {}, radius};
  for (int d = 0; d < 3; ++d) {
    path.from[d] = tilted_sweep_.tips[0][d] + tilted_body_.middle * tilted_sweep_.directions[0][d];
    path.to[d] = tilted_sweep_.tips[1][d] + tilted_body_.middle * tilted_sweep_.directions[1][d];
  }
  return path;
}

/// Returns for each line the interval from the start of the first material to the end of the last material.
void TiltedCutter::material_of_all(const BrickLines& lines, float* from, float* to) {
  std::copy(lines.from, lines.from + brick_lines, from), std::copy(lines.to, lines.to + brick_lines, to);
  for (const FurtherInterval& f : lines.further) {
    const bool any = from[f.line] < to[f.line];
    from[f.line] = any ? std::min(from[f.line], f.from) : f.from, to[f.line] = any ? std::max(to[f.line], f.to) : f.to;
  }
}

/// Returns true if all points of the brick always stay below the lower face of the shaft. This face is inside the ball, so the ball alone
/// cuts the brick.
bool TiltedCutter::is_below_shaft() const {
  float high = tilted_sweep_.middle[2] + std::fabs(tilted_sweep_.shift[2]) / 2 + tilted_sweep_.guess_error() + margin();
  for (int d = 0; d < 3; ++d) high += std::fabs(tilted_sweep_.axes[d][2]) * half_;
  return high < tilted_body_.shaft.low;
}

/// Returns which flat faces of the body may enter the brick during the sweep. The margin covers the enlarged bodies.
FacesNear TiltedCutter::faces_near() const {
  float reach = std::fabs(tilted_sweep_.shift[2]) * 1.5f + tilted_sweep_.guess_error() + 4 * scale_.cell;
  for (int d = 0; d < 3; ++d) reach += std::fabs(tilted_sweep_.axes[d][2]) * half_;
  const float low = tilted_sweep_.middle[2] - reach, high = tilted_sweep_.middle[2] + reach;
  const auto in = [&](float height) { return height >= low && height <= high; };
  FacesNear near;
  near.low = tilted_body_.kind != TiltedBody::Kind::ball && in(tilted_body_.shaft.low), near.high = in(tilted_body_.shaft.high);
  return near;
}

/// Returns true if the sweep removes the whole brick, because the brick is inside the shaft in the pose half way along the path.
bool TiltedCutter::takes_all() const {
  const Frustum& f = tilted_body_.shaft;
  const float reach = tilted_sweep_.reach + tilted_sweep_.guess_error(), height = tilted_sweep_.middle[2];
  if (!(f.high > f.low) || height - reach < f.low || height + reach > f.high) return false;
  const float radius =
      std::sqrt(tilted_sweep_.middle[0] * tilted_sweep_.middle[0] + tilted_sweep_.middle[1] * tilted_sweep_.middle[1]) + reach;
  return radius < std::min(f.low_radius, f.high_radius);
}

bool may_reach(const TiltedSweep& s, const TiltedBody& body, const BrickScale& scale, float top) {
  const float half = scale.edge / 2, tall = top / 2, room = half_shift(s) + scale.cell * 1e-3f;
  // Middle and half edges of the box of the material, mm, in the tool's coordinates in the pose half way along the path.
  float at[3], size[3][3];
  for (int i = 0; i < 3; ++i) {
    at[i] = s.middle[i] + s.axes[2][i] * (tall - half);
    size[0][i] = s.axes[0][i] * half, size[1][i] = s.axes[1][i] * half, size[2][i] = s.axes[2][i] * tall;
  }
  /// Returns the least value that the scalar product of the vector (x, y, z) and a point has among all points of the box.
  const auto least = [&](float x, float y, float z) {
    float sum = at[0] * x + at[1] * y + at[2] * z;
    for (const auto& d : size) sum -= std::fabs(d[0] * x + d[1] * y + d[2] * z);
    return sum;
  };
  if (least(0, 0, 1) > body.high() + room || least(0, 0, -1) > -body.low() + room) return false;
  const float square = at[0] * at[0] + at[1] * at[1];
  if (least(at[0], at[1], 0) > std::sqrt(square) * (body.widest() + room)) return false;
  const float below = at[2] - body.middle;
  if (body.kind != TiltedBody::Kind::ball || below >= 0) return true;
  return least(at[0], at[1], below) - body.middle * below <= std::sqrt(square + below * below) * (body.corner + room);
}

LineSet cut_brick_tilted(Brick& brick, const BrickScale& scale, const TiltedCut& cut, std::int32_t by, CutOutcome& outcome,
                         LaneWidth width) {
  LineSet later;
  TiltedCutter cutter(brick, scale, cut, by, outcome, later);
  if (cutter.takes_all()) {
    cutter.clear();
    return later;
  }
  width == LaneWidth::wide ? cut_tilted_wide(cutter) : cut_tilted_pair(cutter);
  cutter.end();
  return later;
}

}  // namespace kadr
