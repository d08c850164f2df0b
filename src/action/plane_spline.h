#pragma once
// PlaneSpline: a rational B-spline (NURBS) in a plane, clamped, with uniform knots. It is parametrised by length: a `part` is a fraction (0
// to 1) of the curve's length. For LinuxCNC G5, G5.1, G5.2 (spec/linuxcnc 7.7). It is stored as Bézier parts, obtained by blossoms
// (Ramshaw); points and derivatives are computed by de Casteljau's algorithm, as in Piegl, Tiller: The NURBS Book.

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
  static constexpr std::size_t most_order = 32;    // greatest order, which means degree 31; usual orders are 3 and 4
  static constexpr std::size_t max_points = 5000;  // limit of the number of control points; no person or CAM system writes a longer curve

  ///   points  control points with weights above 0: at least `order`, at most max_points
  ///   order   degree + 1, from 2 to most_order
  PlaneSpline(const std::vector<ControlPoint>& points, std::size_t order);

  double length() const { return nodes_.back().length; }
  Vec2 at(double part) const;
  /// Returns the unit tangent. Where the derivative is 0 (control points coincide), returns the tangent of a nearby point; {} for a curve
  /// of length 0.
  Vec2 direction(double part) const;
  /// Returns the curvature in 1/mm, positive for a left turn.
  double curvature(double part) const;
  /// Returns the greatest absolute curvature, in 1/mm, at samples() + 1 equally spaced points.
  double greatest_curvature() const;
  /// Returns the bounding box between two fractions of the length, exact to 1e-9 mm.
  Box2 box(double from, double to) const;
  /// Returns the number of equal parts, between two fractions of the length, whose chords stay within `chord` mm of the curve.
  int pieces(double from, double to, double chord) const;
  /// Returns a number of equal parts of the curve, large enough that each coordinate has at most one extreme in each part; for searches.
  int samples() const;

 private:
  /// A control point in homogeneous coordinates: weight · x, weight · y, weight.
  struct Weighted {
    double x = 0, y = 0, w = 0;
  };
  using Piece = std::vector<Weighted>;  // a part of the spline as a Bézier curve with `order` control points

  /// A point of the curve, with the length of the curve from its start to this point.
  struct Node {
    std::uint32_t piece;
    double t;  // parameter of the point on its Bézier part, 0 to 1
    double length;
  };
  struct Place {
    std::uint32_t piece;
    double t;
  };
  /// A point of the curve, with its first and second derivatives by the parameter t.
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
