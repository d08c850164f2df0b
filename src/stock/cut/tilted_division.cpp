// Divides the path of a tilted tool into parts that are straight enough, as seen from one brick. Used by stock/stock_tilted.

#include "stock/cut/tilted_division.h"

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

/// The range of heights in mm, above the tip, at which points of the brick are during the path.
struct HeightRange {
  float low, high;
  bool holds(float height) const { return height >= low && height <= high; }
};

HeightRange heights_of(const TiltedSweep& s) {
  const float reach = s.reach + std::fabs(s.shift[2]) / 2 + s.guess_error();
  return {s.middle[2] - reach, s.middle[2] + reach};
}

bool has_face(const TiltedBody& body, const HeightRange& heights) {
  const auto is_near = [&](float height, float radius) { return radius > 0 && heights.holds(height); };
  switch (body.kind) {
    case TiltedBody::Kind::cylinder:
      return is_near(body.shaft.low, body.shaft.low_radius) || is_near(body.shaft.high, body.shaft.high_radius);
    case TiltedBody::Kind::cone:
      return is_near(body.end.low, body.end.low_radius) || is_near(body.end.high, body.end.high_radius) ||
             is_near(body.shaft.high, body.shaft.high_radius);
    case TiltedBody::Kind::ball: return is_near(body.shaft.high, body.shaft.high_radius);
    case TiltedBody::Kind::rounded: return is_near(body.low(), body.flat) || is_near(body.shaft.high, body.shaft.high_radius);
  }
  return true;
}

/// Returns the bend (tilted_division.h) of the path past one body, mm. For a ball the bend of the path of the ball's centre counts; the
/// shaft of a ball end counts only in bricks above the centre.
double bend_of(const TiltedSweep& s, const TiltedBody& body, const HeightRange& heights) {
  if (body.kind != TiltedBody::Kind::ball) return double(s.bend);
  const double of_ball = double(body.middle * s.half_turn * s.half_turn) / 2;
  return heights.high < body.shaft.low ? of_ball : std::max(of_ball, double(s.bend));
}

/// Inserts a fraction of the path into the ascending list `share`. The list has one fraction more than `count`, the number of parts of the
/// path.
void put_between(std::array<double, 5>& share, int& count, double at) {
  std::size_t i = std::size_t(++count);
  for (; share[i - 1] > at; --i) share[i] = share[i - 1];
  share[i] = at;
}

}  // namespace

bool has_flat_face(const TiltedSweep& sweep, const TiltedBody& body) { return has_face(body, heights_of(sweep)); }

TiltedDivision division_of(const TiltedSweep& s, const TiltedBody& body) {
  TiltedDivision division;
  if (s.half_turn == 0) return division;
  const HeightRange heights = heights_of(s);
  std::array<double, 5> at{0, 1};
  int sections = 1;
  if (has_face(body, heights))
    for (int family = 0; family < 3; ++family) {
      const double first = double(s.axes_first[family][2]), last = double(s.axes_last[family][2]);
      if (first * last < 0) put_between(at, sections, first / (first - last));
    }
  const double each = std::sqrt(bend_of(s, body, heights) / bend_in_brick);
  if (sections == 1 && each <= 1) return division;
  division.parts = 0;
  for (int i = 0; i < sections; ++i) {
    const double from = at[std::size_t(i)], wide = at[std::size_t(i + 1)] - from;
    const int room = TiltedDivision::max_parts - division.parts - (sections - 1 - i);
    const int parts = std::clamp(int(std::ceil(wide * each)), 1, room);
    for (int part = 0; part < parts; ++part) division.share[std::size_t(++division.parts)] = from + wide * (part + 1) / parts;
  }
  return division;
}

}  // namespace kadr
