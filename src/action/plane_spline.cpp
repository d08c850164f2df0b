// PlaneSpline: a rational B-spline in a plane, traversed at constant speed. Used by action/flat_path; tested by
// tests/action/plane_spline_test.cpp.

#include "action/plane_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kadr {
namespace {

constexpr int max_spline_pieces = 100'000;
// A speed (length per unit of t) below this fraction of the curve's length counts as 0; direction() then uses the tangent of a nearby
// point.
constexpr double standing = 1e-9;

/// Gauss quadrature with eight points in [-1, 1]. The points are symmetric about 0, so only the four positive points and their weights are
/// listed.
constexpr std::array<double, 4> gauss_place = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
constexpr std::array<double, 4> gauss_weight = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

}  // namespace

PlaneSpline::Weighted PlaneSpline::blend(const Weighted& a, const Weighted& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.w + t * (b.w - a.w)};
}

PlaneSpline::PlaneSpline(const std::vector<ControlPoint>& points, std::size_t order)
    : order_(order), first_(points.front().at), last_(points.back().at) {
  std::vector<Weighted> weighted;
  weighted.reserve(points.size());
  for (const ControlPoint& p : points) weighted.push_back({p.weight * p.at.x, p.weight * p.at.y, p.weight});
  for (std::size_t span = 0; span + order <= points.size(); ++span) pieces_.push_back(piece_of(weighted, span));
  nodes_.push_back({0, 0, 0});
  for (std::uint32_t piece = 0; piece < pieces_.size(); ++piece) {
    constexpr int max_halvings = 12;
    for (const auto& [from, to] : {std::pair{0.0, 0.5}, std::pair{0.5, 1.0}})
      measure(piece, from, to, length_between(piece, from, to), max_halvings);
  }
}

/// Returns the control points of the Bézier part between the knots `span` and `span` + 1. They are the values of the spline's polar form
/// (blossom) with each argument equal to one of the two knots. The knots are 0 (`order` times), 1, 2, …, the last (`order` times).
PlaneSpline::Piece PlaneSpline::piece_of(const std::vector<Weighted>& points, std::size_t span) const {
  const std::size_t degree = order_ - 1;
  const double last = static_cast<double>(points.size() - degree);
  const auto knot = [&](std::size_t i) { return std::clamp(static_cast<double>(i) - static_cast<double>(degree), 0.0, last); };
  Piece piece;
  for (std::size_t at_end = 0; at_end <= degree; ++at_end) {
    std::vector<Weighted> d(points.begin() + static_cast<std::ptrdiff_t>(span),
                            points.begin() + static_cast<std::ptrdiff_t>(span + order_));
    for (std::size_t level = 1; level <= degree; ++level) {
      const double argument = static_cast<double>(span) + (level <= at_end ? 1.0 : 0.0);
      for (std::size_t j = degree; j >= level; --j) {
        const double low = knot(span + j), high = knot(span + j + degree - level + 1);
        d[j] = blend(d[j - 1], d[j], (argument - low) / (high - low));
      }
    }
    piece.push_back(d[degree]);
  }
  return piece;
}

PlaneSpline::Motion2 PlaneSpline::motion(Place place) const {
  std::array<Weighted, most_order> d;
  std::copy(pieces_[place.piece].begin(), pieces_[place.piece].end(), d.begin());
  const std::size_t degree = order_ - 1;
  Weighted first{}, second{};  // first and second derivative of the homogeneous coordinates
  for (std::size_t level = degree; level > 0; --level) {
    const double n = static_cast<double>(degree);
    if (level == 2) {
      const double k = n * (n - 1);
      second = {k * (d[2].x - 2 * d[1].x + d[0].x), k * (d[2].y - 2 * d[1].y + d[0].y), k * (d[2].w - 2 * d[1].w + d[0].w)};
    } else if (level == 1) {
      first = {n * (d[1].x - d[0].x), n * (d[1].y - d[0].y), n * (d[1].w - d[0].w)};
    }
    for (std::size_t i = 0; i < level; ++i) d[i] = blend(d[i], d[i + 1], place.t);
  }
  const double w = d[0].w;
  Motion2 m;
  m.at = flat(d[0]);
  m.rate = {(first.x - first.w * m.at.x) / w, (first.y - first.w * m.at.y) / w};
  m.bend = {(second.x - 2 * first.w * m.rate.x - second.w * m.at.x) / w, (second.y - 2 * first.w * m.rate.y - second.w * m.at.y) / w};
  return m;
}

double PlaneSpline::length_between(std::uint32_t piece, double from, double to) const {
  const double half = (to - from) / 2, middle = from + half;
  double sum = 0;
  for (std::size_t i = 0; i < gauss_place.size(); ++i)
    sum += gauss_weight[i] * (speed({piece, middle - half * gauss_place[i]}) + speed({piece, middle + half * gauss_place[i]}));
  return half * sum;
}

/// Adds nodes to `nodes_`, so densely that the length between two neighbouring nodes is exact to the rounding error.
void PlaneSpline::measure(std::uint32_t piece, double from, double to, double whole, int halvings) {
  constexpr double close = 1e-12;
  const double middle = from + (to - from) / 2;
  const double one = length_between(piece, from, middle), other = length_between(piece, middle, to);
  if (halvings == 0 || std::fabs(one + other - whole) <= close * std::max(1.0, whole)) {
    nodes_.push_back({piece, to, nodes_.back().length + one + other});
    return;
  }
  measure(piece, from, middle, one, halvings - 1);
  measure(piece, middle, to, other, halvings - 1);
}

/// Finds the point at the fraction `part` (0 to 1) of the length, by Newton's method between two nodes. A Newton step that would leave the
/// interval between the nodes is replaced by bisection.
PlaneSpline::Place PlaneSpline::place_of(double part) const {
  const double target = part * length();
  const auto next = std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, target, [](double l, const Node& n) { return l < n.length; });
  const Node& before = *(next - 1);
  const std::uint32_t piece = next->piece;
  const double start = before.piece == piece ? before.t : 0;
  double low = start, high = next->t;
  const double span = next->length - before.length;
  if (!(span > 0)) return {piece, low};
  double t = low + (high - low) * (target - before.length) / span;
  constexpr int max_steps = 60;
  constexpr double near_enough = 1e-13;
  for (int step = 0; step < max_steps; ++step) {
    const double off = before.length + length_between(piece, start, t) - target;
    (off > 0 ? high : low) = t;
    const double rate = speed({piece, t});
    double better = rate > 0 ? t - off / rate : low;
    if (!(better > low && better < high)) better = low + (high - low) / 2;
    const double moved = std::fabs(better - t);
    t = better;
    if (moved <= near_enough) break;
  }
  return {piece, t};
}

Vec2 PlaneSpline::at(double part) const {
  if (part <= 0) return first_;
  if (part >= 1) return last_;
  return motion(place_of(part)).at;
}

Vec2 PlaneSpline::direction(double part) const {
  if (!(length() > 0)) return {};
  constexpr double nearby = 1e-5;  // distance to the nearby point whose tangent is used, as a fraction of the curve's length
  for (const double shift : {0.0, nearby, 10 * nearby, 100 * nearby}) {
    const double there = std::clamp(part < 0.5 ? part + shift : part - shift, 0.0, 1.0);
    const Vec2 rate = motion(place_of(there)).rate;
    const double speed_there = kadr::length(rate);
    if (speed_there > standing * length()) return (1 / speed_there) * rate;
  }
  const Vec2 chord = last_ - first_;
  const double chord_length = kadr::length(chord);
  return chord_length > 0 ? (1 / chord_length) * chord : Vec2{1, 0};
}

double PlaneSpline::curvature(double part) const {
  const Motion2 m = motion(place_of(part));
  const double rate = kadr::length(m.rate);
  return rate > standing * length() ? cross(m.rate, m.bend) / (rate * rate * rate) : 0;
}

double PlaneSpline::greatest_curvature() const {
  const int count = samples();
  double most = 0;
  for (int i = 0; i <= count; ++i) most = std::max(most, std::fabs(curvature(static_cast<double>(i) / count)));
  return most;
}

std::pair<PlaneSpline::Piece, PlaneSpline::Piece> PlaneSpline::split(const Piece& piece, double t) {
  Piece left, right(piece.size()), d = piece;
  for (std::size_t level = piece.size(); level > 0; --level) {
    left.push_back(d[0]);
    right[level - 1] = d[level - 1];
    for (std::size_t i = 0; i + 1 < level; ++i) d[i] = blend(d[i], d[i + 1], t);
  }
  return {left, right};
}

/// Extends the box to contain the Bézier part `piece`, using the convex hulls of smaller and smaller halves. The box must already contain
/// the ends of `piece`.
void PlaneSpline::widen(Box2& box, const Piece& piece, int halvings) {
  constexpr double close = 1e-9;  // precision of the box, mm
  Box2 hull{flat(piece[0]), flat(piece[0])};
  for (const Weighted& point : piece) hull.take(flat(point));
  const bool inside = hull.least.x >= box.least.x - close && hull.least.y >= box.least.y - close && hull.most.x <= box.most.x + close &&
                      hull.most.y <= box.most.y + close;
  if (inside || halvings == 0) return;
  const auto [left, right] = split(piece, 0.5);
  box.take(flat(right[0]));
  widen(box, left, halvings - 1);
  widen(box, right, halvings - 1);
}

Box2 PlaneSpline::box(double from, double to) const {
  Box2 box{at(from), at(from)};
  box.take(at(to));
  const Place start = place_of(std::max(from, 0.0)), end = place_of(std::min(to, 1.0));
  constexpr int max_halvings = 40;
  for (std::uint32_t i = start.piece; i <= end.piece; ++i) {
    Piece piece = pieces_[i];
    const double t0 = i == start.piece ? start.t : 0, t1 = i == end.piece ? end.t : 1;
    if (t1 < 1) piece = split(piece, t1).first;
    if (t0 > 0 && t1 > 0) piece = split(piece, std::min(1.0, t0 / t1)).second;
    box.take(flat(piece.front()));
    box.take(flat(piece.back()));
    widen(box, piece, max_halvings);
  }
  return box;
}

int PlaneSpline::samples() const { return static_cast<int>(std::min<std::size_t>(pieces_.size() * 4 * order_, max_spline_pieces)); }

/// Returns the greatest distance of the curve from the chord between two fractions of its length, sampled at `places` - 1 inner points.
/// `start` and `end` are the points at these two fractions.
double PlaneSpline::off_chord(double from, double to, Vec2 start, Vec2 end, int places) const {
  const Vec2 delta = end - start;
  const double squared = dot(delta, delta);
  double worst = 0;
  for (int i = 1; i < places; ++i) {
    const Vec2 off = at(from + (to - from) * i / places) - start;
    // At a cusp, the point of the line that is nearest to the sample may lie beyond the chord's end, so it is clamped to the chord.
    const double along = squared > 0 ? std::clamp(dot(delta, off) / squared, 0.0, 1.0) : 0;
    worst = std::max(worst, kadr::length(off - along * delta));
  }
  return worst;
}

/// Where the curve is smooth, its distance from a chord falls with the square of the chord's length; at a cusp, with the length itself.
/// Therefore the number of parts is raised until the distance is small enough. A curve of length s whose ends are c apart lies within an
/// ellipse (string construction), so it is at most √(s² − c²)/2 from the chord. A smooth curve comes close to this bound, and samples near
/// its middle find the greatest distance. If the sampled distance is far below the bound, more points are sampled.
int PlaneSpline::pieces(double from, double to, double chord) const {
  constexpr double used = 0.8;        // fraction of the tolerance that is used; the rest is a margin, because the distance is only sampled
  constexpr double fastest_rise = 4;  // greatest factor by which the number of parts rises from one trial to the next
  constexpr double of_ellipse = 0.5;  // a smooth curve reaches more than this fraction of the ellipse's bound; a circular arc reaches 0.87
  double count = std::max(1.0, std::ceil((to - from) * samples() / 4));
  while (true) {
    const double hopeless = fastest_rise * fastest_rise * used * chord;
    const double run = (to - from) * length() / count;
    double worst = 0;
    Vec2 before = at(from);
    for (double i = 0; i < count && worst <= hopeless; ++i) {
      const double low = from + (to - from) * i / count, high = from + (to - from) * (i + 1) / count;
      const Vec2 after = at(high);
      double off = off_chord(low, high, before, after, 4);
      const double ellipse = std::sqrt(std::max(0.0, run * run - dot(after - before, after - before))) / 2;
      if (off <= used * chord && ellipse > used * chord && off < of_ellipse * ellipse) off = off_chord(low, high, before, after, 16);
      worst = std::max(worst, off);
      before = after;
    }
    const double target = std::ceil(count * std::sqrt(worst / (used * chord)));
    if (worst <= used * chord || count >= max_spline_pieces) return static_cast<int>(count);
    count = std::min<double>(max_spline_pieces, std::clamp(target, count + 1, fastest_rise * count));
  }
}

}  // namespace kadr
