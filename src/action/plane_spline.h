#pragma once
// PlaneSpline: a rational B-spline (NURBS) in a plane, clamped, with uniform knots, parametrised by length: a `part` in 0..1 is a part of
// the curve's length. For LinuxCNC G5, G5.1, G5.2 (spec/linuxcnc 7.7). It is stored as Bézier pieces, obtained by blossoms (Ramshaw);
// points and derivatives by de Casteljau's algorithm, as in Piegl, Tiller: The NURBS Book.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "action/box2.h"
#include "base/vec.h"

namespace kadr {

struct ControlPoint {
  Vec2 at;
  double weight = 1;
};

///   law  at(0) and at(1) are the first and the last control point, bit by bit
///   law  turned, mirrored, reversed control points give the curve turned, mirrored, reversed
///   law  the curve lies in the convex hull of its control points
class PlaneSpline {
 public:
  static constexpr std::size_t most_order = 32;    // greatest order: degree 31; usual orders are 3 and 4
  static constexpr std::size_t max_points = 5000;  // limit of control points: no person or CAM system writes a curve of more

  ///   points  control points with weights above 0: at least `order`, at most max_points
  ///   order   degree + 1, from 2 to most_order
  PlaneSpline(const std::vector<ControlPoint>& points, std::size_t order);

  double length() const { return nodes_.back().length; }
  Vec2 at(double part) const;
  /// Returns the unit tangent. If the derivative vanishes (control points coincide), returns the tangent of a nearby point; {} for a
  /// curve of length 0.
  Vec2 direction(double part) const;
  /// Returns the curvature in 1/mm, positive for a left turn.
  double curvature(double part) const;
  /// Returns the greatest absolute curvature at the samples() + 1 sampled points.
  double greatest_curvature() const;
  /// Returns the bounding box between two parts, within 1e-9 mm.
  Box2 box(double from, double to) const;
  /// Returns the number of equal pieces between two parts whose chords stay within `chord` mm of the curve.
  int pieces(double from, double to, double chord) const;
  /// Returns a number of equal pieces of the curve, so many that each coordinate has at most one extreme in each piece; for searches.
  int samples() const;

 private:
  /// A control point in homogeneous coordinates: weight · x, weight · y, weight.
  struct Weighted {
    double x = 0, y = 0, w = 0;
  };
  using Piece = std::vector<Weighted>;  // Bézier piece of `order` control points

  /// A point of the curve, with the length from the curve's start to it.
  struct Node {
    std::uint32_t piece;
    double t;  // parameter of the point on the piece, 0..1
    double length;
  };
  struct Place {
    std::uint32_t piece;
    double t;
  };
  /// A point of the curve, and its first and second derivative with respect to t.
  struct Motion2 {
    Vec2 at, rate, bend;
  };

  static Vec2 flat(const Weighted& point) { return {point.x / point.w, point.y / point.w}; }
  static Weighted blend(const Weighted& a, const Weighted& b, double t);
  Piece piece_of(const std::vector<Weighted>& points, std::size_t span) const;
  Motion2 motion(Place place) const;
  double speed(Place place) const { return kadr::length(motion(place).rate); }
  double length_between(std::uint32_t piece, double from, double to) const;
  void measure(std::uint32_t piece, double from, double to, double whole, int halvings);
  Place place_of(double part) const;
  double off_chord(double from, double to, Vec2 start, Vec2 end, int places) const;
  static std::pair<Piece, Piece> split(const Piece& piece, double t);
  static void widen(Box2& box, const Piece& piece, int halvings);

  std::size_t order_;
  Vec2 first_, last_;
  std::vector<Piece> pieces_;
  std::vector<Node> nodes_;
};

}  // namespace kadr
