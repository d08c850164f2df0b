#pragma once
// The pen of the SVG reader: converts shapes in user units to edges in mm.

#include <functional>

#include "config/drawing/drawing.h"

namespace kadr::svg {

/// Maps the point (x, y) to (x', y') with x' = a·x + c·y + e, y' = b·x + d·y + f; the coefficients are in SVG's order.
struct Matrix {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  friend Matrix operator*(const Matrix& m, const Matrix& n) {
    return {m.a * n.a + m.c * n.b, m.b * n.a + m.d * n.b,       m.a * n.c + m.c * n.d,
            m.b * n.c + m.d * n.d, m.a * n.e + m.c * n.f + m.e, m.b * n.e + m.d * n.f + m.f};
  }
};

/// An elliptical arc. The axis of the ellipse is rotated by `turn` degrees. The arc starts at the angle `from` and covers `sweep`, both in
/// degrees of the ellipse's parameter, positive towards +Y.
struct EllipseArc {
  Vec2 centre;
  double rx = 0, ry = 0, turn = 0, from = 0, sweep = 360;
};

class Pen {
 public:
  Pen(EdgeList& edges, const Matrix& to_mm) : edges_(edges), to_mm_(to_mm) {}

  void line(Vec2 from, Vec2 to) { edges_.line(to_mm_(from), to_mm_(to)); }
  /// Draws a curve as arcs and lines, within tol::contour_curve. The function `at` returns the point for a fraction (0 to 1) of the curve.
  void curve(const std::function<Vec2(double)>& at);
  /// Draws an elliptical arc. A circle remains an exact circle if the matrix maps it to a circle.
  void ellipse(const EllipseArc& arc);
  bool full() const { return edges_.full(); }

 private:
  void piece(const std::function<Vec2(double)>& at, double from, double to, int depth);

  EdgeList& edges_;
  Matrix to_mm_;
};

/// Draws the path that the attribute `d` of an SVG element describes.
///   returns  the position in `d` at which it cannot be read; npos if all of `d` was read
std::size_t draw_path(std::string_view d, Pen& pen);

/// Reads a list of numbers, separated by blanks or commas.
///   returns  false if the text contains anything else
bool read_numbers(std::string_view text, std::vector<double>& numbers);

}  // namespace kadr::svg
