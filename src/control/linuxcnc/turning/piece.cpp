// Operations on pieces (lines and arcs) of a turned profile: offset, crossings, corners. Used by control/linuxcnc/turning/profile, passes.

#include "control/linuxcnc/turning/piece.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kadr::linuxcnc {
namespace {

constexpr Point quarter{0, 1};
constexpr double corner_within = 1e-2;  // greatest overlap of two offset pieces at a corner, in the unit of the program

/// Returns true if a point of the arc's circle is on the arc, between its start and its end.
bool is_on(const Piece& arc, Point p) {
  const double side = arc.ccw ? 1 : -1;
  const double from_start = std::imag(std::conj(arc.start - arc.center) * (p - arc.center)) * side;
  const double from_end = std::imag(std::conj(arc.end - arc.center) * (p - arc.center)) * side;
  return from_start >= -same_point && from_end <= same_point;
}

Turned two_lines(Piece& before, Piece& after) {
  const Point turn = std::conj(after.start - after.end) / std::abs(after.start - after.end);
  const Point from = (before.start - after.end) * turn, to = (before.end - after.end) * turn;
  if (std::imag(from - to) == 0) return tl::unexpected(std::string("Cannot intersect parallel lines"));
  const double part = std::imag(from) / std::imag(from - to);
  after.start = before.end = (from + part * (to - from)) / turn + after.end;
  return {};
}

/// Returns the intersection of a line and a circle. Of two intersections, returns the one that is nearer to `near`. The line contains the
/// point `origin`; `turn` rotates the line onto the real axis. `of_circle`: a point of the circle.
Point on_circle(Point origin, Point turn, Point center, Point of_circle, Point near) {
  const Point c = (center - origin) * turn, p = (of_circle - origin) * turn;
  const double half = std::sqrt(std::max(0.0, std::norm(c - p) - std::imag(c) * std::imag(c)));
  const Point one = (std::real(c) + half) / turn + origin, other = (std::real(c) - half) / turn + origin;
  return std::abs(near - one) < std::abs(near - other) ? one : other;
}

Point of_two_circles(const Piece& before, const Piece& after) {
  const double a = std::abs(after.start - after.center), b = std::abs(before.start - before.center),
               c = std::abs(after.center - before.center);
  const double cosine = (c * c + a * a - b * b) / 2.0 / a / c;
  const Point turn(cosine, std::sqrt(1 - std::min(1.0, cosine * cosine)));
  return turn * (before.center - after.center) / c * a + after.center;
}

}  // namespace

double Piece::size() const {
  const double chord = std::abs(start - end);
  return is_arc() ? std::min(chord, std::abs(start - center)) : chord;
}

bool Piece::falls() const {
  if (!is_arc()) return std::real(end - start) <= least_piece;
  if (corner != 0) return true;
  const double side = ccw ? 1 : -1;
  return side * std::imag(start - center) >= -least_piece && side * std::imag(end - center) >= -least_piece &&
         std::real(end - start) <= -least_piece;
}

std::vector<double> Piece::crossings(double x) const {
  std::vector<double> all;
  if (!is_arc()) {
    if (std::min(start.imag(), end.imag()) > x + same_point || std::max(start.imag(), end.imag()) < x - same_point) return all;
    if (std::abs(std::imag(start - end)) < same_point) return {start.real(), end.real()};
    return {(x - start.imag()) / (end.imag() - start.imag()) * (end.real() - start.real()) + start.real()};
  }
  const double radius = std::abs(start - center);
  const double square = -(x - radius - center.imag()) * (x + radius - center.imag());
  if (square < -same_point) return all;
  const double half = std::sqrt(std::max(0.0, square));
  for (const double z : {std::real(center + half), std::real(center - half)})
    if (is_on(*this, Point(z, x))) all.push_back(z);
  return all;
}

void Piece::offset(double distance) {
  if (!is_arc()) {
    const Point by = quarter * distance * (start - end) / std::abs(start - end);
    start += by;
    end += by;
    return;
  }
  const double radius = std::abs(start - center);
  const double factor = (radius + (ccw ? 1 : -1) * distance) / radius;
  start = factor * (start - center) + center;
  end = factor * (end - center) + center;
}

void Piece::mirror_x() {
  ccw = !ccw;
  start = std::conj(start);
  end = std::conj(end);
  center = std::conj(center);
}

void Piece::mirror_z() {
  ccw = !ccw;
  start = -std::conj(start);
  end = -std::conj(end);
  center = -std::conj(center);
}

void Piece::quarter_turn() {
  start = -start * quarter;
  end = -end * quarter;
  center = -center * quarter;
}

Turned join(Piece& before, Piece& after) {
  if (!before.is_arc() && !after.is_arc()) return two_lines(before, after);
  if (before.is_arc() && after.is_arc()) {
    before.end = after.start = of_two_circles(before, after);
    return {};
  }
  if (std::abs(after.start - before.end) < same_point) return {};
  if (before.is_arc()) {
    const Point turn = std::conj(after.start - after.end) / std::abs(after.start - after.end);
    after.start = before.end = on_circle(after.end, turn, before.center, before.end, after.start);
  } else {
    const Point turn = std::conj(before.start - before.end) / std::abs(before.start - before.end);
    after.start = before.end = on_circle(before.end, turn, after.center, after.end, after.start);
  }
  return {};
}

/// Inserts a fillet or chamfer. Both pieces are offset by the size of the corner, trimmed at their intersection, and offset back.
Turned place_corner(Piece& before, Piece& corner, Piece& after) {
  if (corner.kind != Piece::Kind::fillet && corner.kind != Piece::Kind::chamfer) return {};
  double size = corner.corner;
  Piece b = before, a = after;
  const auto aside = [&] {
    b = before;
    a = after;
    b.offset(size);
    a.offset(size);
    return std::real(b.end - a.start) <= corner_within;
  };
  if (!aside()) {
    size = -size;
    if (!aside()) return tl::unexpected(fmt::format("Corner finish failed at ({:g},{:g})", before.end.real(), before.end.imag()));
  }
  if (const Turned met = join(b, a); !met) return met;
  const Point center = (b.end + a.start) / 2.0;
  b.offset(-size);
  a.offset(-size);
  corner.start = before.end = b.end;
  corner.end = after.start = a.start;
  corner.corner = 0;
  if (corner.kind == Piece::Kind::chamfer) return {};
  corner.center = center;
  corner.ccw = std::imag(corner.start - center) > 0 || std::imag(corner.end - center) > 0;
  return {};
}

}  // namespace kadr::linuxcnc
