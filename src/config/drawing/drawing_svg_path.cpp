// SVG: the pen, which converts shapes to edges, and the reader of path data (SVG 1.1, 8.3; arcs F.6).

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/ascii.h"
#include "base/tolerance.h"
#include "config/drawing/drawing_svg_pen.h"

namespace kadr::svg {
namespace {

/// Returns the distance of `p` from the circle through a, b, c; if these three points are collinear, from the line through a and c.
double off_arc(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
  const double doubled = 2 * cross(b - a, c - a);
  if (std::abs(doubled) < tol::same_point * length(c - a)) return std::abs(cross(c - a, p - a)) / std::max(length(c - a), tol::same_point);
  const double ab = dot(b - a, b - a), ac = dot(c - a, c - a);
  const Vec2 centre{((c - a).y * ab - (b - a).y * ac) / doubled, ((b - a).x * ac - (c - a).x * ab) / doubled};
  return std::abs(length(p - a - centre) - length(centre));
}

double bulge_through(Vec2 a, Vec2 b, Vec2 c) {
  const double at_b = std::atan2(cross(b - a, c - b), dot(b - a, c - b));  // half the angle that the arc sweeps
  return std::tan(at_b / 2);
}

class PathReader {
 public:
  PathReader(std::string_view d, Pen& pen) : d_(d), pen_(pen) {}

  std::size_t read() {
    char command = 0;
    for (skip(); at_ < d_.size() && !pen_.full(); skip()) {
      if (is_letter(d_[at_])) command = d_[at_++];
      else if (command == 0 || command == 'Z' || command == 'z') return at_;
      if (!step(command)) return at_;
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    return std::string_view::npos;
  }

 private:
  void skip() {
    while (at_ < d_.size() && (d_[at_] == ' ' || d_[at_] == ',' || d_[at_] == '\n' || d_[at_] == '\r' || d_[at_] == '\t')) ++at_;
  }
  bool number(double& value) {
    skip();
    if (at_ < d_.size() && d_[at_] == '+') ++at_;
    const auto [end, error] = fast_float::from_chars(d_.data() + at_, d_.data() + d_.size(), value);
    if (error != std::errc()) return false;
    at_ = static_cast<std::size_t>(end - d_.data());
    return std::isfinite(value);
  }
  bool flag(bool& value) {
    skip();
    if (at_ >= d_.size() || (d_[at_] != '0' && d_[at_] != '1')) return false;
    value = d_[at_++] == '1';
    return true;
  }
  bool point(Vec2& p, bool relative) {
    if (!number(p.x) || !number(p.y)) return false;
    if (relative) p = p + now_;
    return true;
  }
  void line_to(Vec2 p) {
    pen_.line(now_, p);
    now_ = p;
  }

  bool step(char command) {
    const bool relative = command >= 'a';
    const char what = static_cast<char>(relative ? command - 'a' + 'A' : command);
    Vec2 p = now_;
    if (what != 'C' && what != 'S') control_cubic_.reset();
    if (what != 'Q' && what != 'T') control_quadratic_.reset();
    switch (what) {
      case 'M': return point(p, relative) && (now_ = first_ = p, true);
      case 'L': return point(p, relative) && (line_to(p), true);
      case 'H': return number(p.x) && (p.x += relative ? now_.x : 0, line_to(p), true);
      case 'V': return number(p.y) && (p.y += relative ? now_.y : 0, line_to(p), true);
      case 'Z': line_to(first_); return true;
      case 'C':
      case 'S': return cubic(what == 'S', relative);
      case 'Q':
      case 'T': return quadratic(what == 'T', relative);
      case 'A': return arc(relative);
      default: --at_; return false;
    }
  }

  bool cubic(bool smooth, bool relative) {
    Vec2 b = control_cubic_ ? 2 * now_ - *control_cubic_ : now_, c, d;
    if ((!smooth && !point(b, relative)) || !point(c, relative) || !point(d, relative)) return false;
    const Vec2 a = now_;
    pen_.curve([=](double t) {
      const double u = 1 - t;
      return u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d;
    });
    control_cubic_ = c;
    now_ = d;
    return true;
  }

  bool quadratic(bool smooth, bool relative) {
    Vec2 b = control_quadratic_ ? 2 * now_ - *control_quadratic_ : now_, c;
    if ((!smooth && !point(b, relative)) || !point(c, relative)) return false;
    const Vec2 a = now_;
    pen_.curve([=](double t) { return (1 - t) * (1 - t) * a + 2 * (1 - t) * t * b + t * t * c; });
    control_quadratic_ = b;
    now_ = c;
    return true;
  }

  bool arc(bool relative) {
    EllipseArc e;
    bool large = false, towards_y = false;
    Vec2 to;
    if (!number(e.rx) || !number(e.ry) || !number(e.turn) || !flag(large) || !flag(towards_y) || !point(to, relative)) return false;
    const Vec2 from = now_;
    e.rx = std::abs(e.rx), e.ry = std::abs(e.ry);
    if (e.rx < tol::same_point || e.ry < tol::same_point || from == to) {
      line_to(to);
      return true;
    }
    const Vec2 half = rotated(0.5 * (from - to), -e.turn);  // half the chord in the axes of the ellipse (SVG 1.1, F.6.5)
    const double x = half.x / e.rx, y = half.y / e.ry, beyond = x * x + y * y;
    if (beyond > 1) e.rx *= std::sqrt(beyond), e.ry *= std::sqrt(beyond);
    const double ux = half.x / e.rx, uy = half.y / e.ry;
    const double k = (large == towards_y ? -1 : 1) * std::sqrt(std::max(0.0, 1 / std::max(ux * ux + uy * uy, 1e-300) - 1));
    const Vec2 c{k * uy, -k * ux};  // centre of the arc in coordinates in which the ellipse is the unit circle
    e.centre = 0.5 * (from + to) + rotated({e.rx * c.x, e.ry * c.y}, e.turn);
    e.from = angle_deg(Vec2{ux, uy} - c);
    e.sweep = angle_deg(-1.0 * Vec2{ux, uy} - c) - e.from;
    if (towards_y && e.sweep < 0) e.sweep += 360;
    if (!towards_y && e.sweep > 0) e.sweep -= 360;
    pen_.ellipse(e);
    now_ = to;
    return true;
  }

  std::string_view d_;
  Pen& pen_;
  std::size_t at_ = 0;
  Vec2 now_, first_;
  std::optional<Vec2> control_cubic_, control_quadratic_;
};

}  // namespace

void Pen::piece(const std::function<Vec2(double)>& at, double from, double to, int depth) {
  constexpr int deepest = 12;
  if (edges_.full()) return;
  const double middle = (from + to) / 2;
  const Vec2 a = to_mm_(at(from)), b = to_mm_(at(middle)), c = to_mm_(at(to));
  const double off = std::max(off_arc(to_mm_(at((from + middle) / 2)), a, b, c), off_arc(to_mm_(at((middle + to) / 2)), a, b, c));
  const double bulge = bulge_through(a, b, c);
  if (depth == deepest || (off < tol::contour_curve && std::abs(bulge) < 0.5)) {
    edges_.bulged(a, c, std::abs(cross(b - a, c - a)) < tol::contour_curve * length(c - a) / 4 ? 0 : bulge);
    return;
  }
  piece(at, from, middle, depth + 1);
  piece(at, middle, to, depth + 1);
}

void Pen::curve(const std::function<Vec2(double)>& at) {
  constexpr int pieces = 4;  // number of parts of the curve, so many that the middle of an S-shaped curve is not mistaken for a line
  for (int i = 0; i < pieces; ++i) piece(at, double(i) / pieces, double(i + 1) / pieces, 0);
}

void Pen::ellipse(const EllipseArc& e) {
  const auto at = [&](double t) {
    const SinCos turn = sincos_deg(e.from + t * e.sweep);
    return e.centre + rotated({e.rx * turn.cos, e.ry * turn.sin}, e.turn);
  };
  const Vec2 x{to_mm_.a, to_mm_.b}, y{to_mm_.c, to_mm_.d};
  const double size = length(x) * e.rx;
  const bool round = std::abs(e.rx - e.ry) * length(x) < tol::same_point && std::abs(length(x) - length(y)) * e.rx < tol::same_point &&
                     std::abs(dot(x, y)) * e.rx * e.rx < tol::same_point * std::max(size, tol::same_point);
  if (!round) return curve(at);
  const int pieces = std::abs(e.sweep) > 180 ? 2 : 1;
  const double bulge = std::copysign(std::tan(std::abs(e.sweep) / pieces / 4 * rad_per_deg), e.sweep * cross(x, y));
  for (int i = 0; i < pieces; ++i) edges_.bulged(to_mm_(at(double(i) / pieces)), to_mm_(at(double(i + 1) / pieces)), bulge);
}

std::size_t draw_path(std::string_view d, Pen& pen) { return PathReader(d, pen).read(); }

bool read_numbers(std::string_view text, std::vector<double>& numbers) {
  for (std::size_t at = text.find_first_not_of(" ,\t\r\n"); at != std::string_view::npos; at = text.find_first_not_of(" ,\t\r\n", at)) {
    double value = 0;
    if (text[at] == '+') ++at;
    const auto [end, error] = fast_float::from_chars(text.data() + at, text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return false;
    numbers.push_back(value);
    at = static_cast<std::size_t>(end - text.data());
  }
  return true;
}

}  // namespace kadr::svg
