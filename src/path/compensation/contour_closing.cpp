// This file finds the point at which a programmed contour closes, that is, returns to an earlier point. Used by
// path/compensation/gouge_detector.

#include "path/compensation/contour_closing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/tolerance.h"

namespace kadr {
namespace {

// Points whose distance is at most this value, mm, count as the same point. Coordinates in programs have steps of 0.001 to 0.01 mm.
constexpr double touches = 0.01;
// The least length of a closed loop, as a fraction of the whole length. A shorter loop is a self-crossing of an open contour.
constexpr double least_share = 0.25;
// The greatest number of closed loops. A contour with more loops goes around several times, so the whole path counts as the contour.
constexpr std::size_t max_candidates = 1000;
// Fraction of the length of the longest loop. If two nested loops are both longer than this fraction, the inner loop is the workpiece
// contour.
constexpr double inner_share = 0.5;

double length_of(const PlanePiece& p) { return p.is_arc ? p.radius * std::fabs(p.turns) * 2 * pi : length(p.to - p.from); }

Vec2 point_at(const PlanePiece& p, double part) {
  if (part <= 0) return p.from;
  if (part >= 1) return p.to;
  return p.is_arc ? p.center + rotated(p.from - p.center, 360 * p.turns * part) : p.from + part * (p.to - p.from);
}

/// The positions of a point on a piece, as fractions of the piece's length. There are two positions if the point is both the start and the
/// end of a full circle.
struct Places {
  std::array<double, 2> at{};
  std::size_t count = 0;
  void add(double part) { at[count++] = part; }
};
Places places_of(Vec2 point, const PlanePiece& p) {
  Places places;
  if (length(point - p.from) <= touches) places.add(0);
  if (length(point - p.to) <= touches) places.add(1);
  if (places.count > 0) return places;
  if (!p.is_arc) {
    const Vec2 delta = p.to - p.from;
    places.add(std::clamp(dot(point - p.from, delta) / dot(delta, delta), 0.0, 1.0));
    return places;
  }
  const Vec2 start = p.from - p.center, arm = point - p.center;
  const double sense = p.turns < 0 ? -1 : 1;
  // The rotation from the arc's start to the point, in revolutions, above −1/2 and at most 1/2.
  const double swept = angle_deg({dot(start, arm), sense * cross(start, arm)}) / 360;
  places.add(std::clamp((swept < 0 ? swept + 1 : swept) / std::fabs(p.turns), 0.0, 1.0));
  return places;
}

/// The points at which two pieces meet: crossings, and ends that lie on the other piece. If two pieces overlap, the points are the ends of
/// the common section.
struct Points {
  std::array<Vec2, 8> at{};
  std::size_t count = 0;
  void add(Vec2 p) {
    if (count < at.size()) at[count++] = p;
  }
};

PlanePiece point_piece(Vec2 p) { return PlanePiece::line(p, p); }
bool is_on(Vec2 point, const PlanePiece& piece) { return distance(point_piece(point), piece) <= touches; }

void add_crossings(const PlanePiece& a, const PlanePiece& b, Points& points) {
  const auto add = [&](Vec2 p) {
    if (is_on(p, a) && is_on(p, b)) points.add(p);
  };
  if (!a.is_arc && !b.is_arc) {
    const Vec2 u = a.to - a.from, v = b.to - b.from;
    if (const double across = cross(u, v); across != 0) add(a.from + cross(b.from - a.from, v) / across * u);
    return;
  }
  if (a.is_arc && b.is_arc) {
    const Vec2 between = b.center - a.center;
    const double d = length(between);
    if (d == 0 || d > a.radius + b.radius || d < std::fabs(a.radius - b.radius)) return;
    const Vec2 ahead = 1 / d * between;
    const double along = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
    const double height = std::sqrt(std::max(a.radius * a.radius - along * along, 0.0));
    for (const double side : {-1.0, 1.0}) add(a.center + along * ahead + side * height * left_of(ahead));
    return;
  }
  const PlanePiece &line = a.is_arc ? b : a, &arc = a.is_arc ? a : b;
  const Vec2 delta = line.to - line.from;
  const double square = dot(delta, delta);
  if (square == 0) return;
  const double part = dot(arc.center - line.from, delta) / square;
  const Vec2 foot = line.from + part * delta;
  const double height = length(foot - arc.center);
  if (height > arc.radius) return;
  const double half = std::sqrt((arc.radius - height) * (arc.radius + height) / square);
  for (const double side : {-half, half}) add(line.from + (part + side) * delta);
}

Points meetings(const PlanePiece& a, const PlanePiece& b) {
  Points points;
  for (const Vec2 p : {a.from, a.to})
    if (is_on(p, b)) points.add(p);
  for (const Vec2 p : {b.from, b.to})
    if (is_on(p, a)) points.add(p);
  add_crossings(a, b, points);
  return points;
}

bool near(const PlanePiece& a, const PlanePiece& b) {
  return a.box.least.x <= b.box.most.x + touches && b.box.least.x <= a.box.most.x + touches && a.box.least.y <= b.box.most.y + touches &&
         b.box.least.y <= a.box.most.y + touches;
}

struct Candidate {
  ContourLoop loop;
  double begins = 0, ends = 0;  // start and end of the loop as path lengths from the start of the contour, mm
  double length() const { return ends - begins; }
  bool within(const Candidate& outer) const { return begins >= outer.begins - touches && ends <= outer.ends + touches; }
};

/// Returns all closed loops of the contour. Every pair of positions at which the contour meets itself is such a loop.
std::vector<Candidate> candidates(std::span<const PlanePiece> pieces, std::size_t gap) {
  std::vector<double> start(pieces.size() + 1, 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) start[i + 1] = start[i] + length_of(pieces[i]);
  std::vector<Candidate> found;
  for (std::size_t i = 0; i < (gap > 0 ? gap : pieces.size()); ++i)
    for (std::size_t j = gap > 0 ? gap : i + 1; j < pieces.size(); ++j) {
      if (!near(pieces[i], pieces[j])) continue;
      const Points points = meetings(pieces[i], pieces[j]);
      for (std::size_t p = 0; p < points.count; ++p) {
        const Places first = places_of(points.at[p], pieces[i]), last = places_of(points.at[p], pieces[j]);
        for (std::size_t s = 0; s < first.count; ++s)
          for (std::size_t t = 0; t < last.count; ++t)
            found.push_back({{i, first.at[s], j, last.at[t]},
                             start[i] + first.at[s] * (start[i + 1] - start[i]),
                             start[j] + last.at[t] * (start[j + 1] - start[j])});
      }
    }
  return found;
}

}  // namespace

/// Returns the workpiece contour. Run-in and run-out may cross once more away from the workpiece, so the inner of two nested loops is the
/// contour. Loops may also overlap, if the end of the contour overlaps its start or the run-out continues through the workpiece. The
/// contour is then everything that belongs to any of these loops.
std::optional<ContourLoop> closing(std::span<const PlanePiece> pieces, std::size_t gap) {
  double whole = 0, longest = 0;
  for (const PlanePiece& piece : pieces) whole += length_of(piece);
  std::vector<Candidate> all = candidates(pieces, gap);
  for (const Candidate& c : all) longest = std::max(longest, c.length());
  if (all.empty() || all.size() > max_candidates || (gap == 0 && longest < least_share * whole)) return std::nullopt;
  if (gap == 0) std::erase_if(all, [&](const Candidate& c) { return c.length() < inner_share * longest; });
  const Candidate *first = nullptr, *last = nullptr;
  for (const Candidate& c : all) {
    const bool outer =
        std::any_of(all.begin(), all.end(), [&](const Candidate& d) { return d.within(c) && d.length() < c.length() - touches; });
    if (outer) continue;
    if (first == nullptr || c.begins < first->begins) first = &c;
    if (last == nullptr || c.ends > last->ends) last = &c;
  }
  return ContourLoop{first->loop.first, first->loop.first_part, last->loop.last, last->loop.last_part};
}

PlanePiece cut_out(const PlanePiece& piece, double from, double to) {
  const Vec2 a = point_at(piece, from), b = point_at(piece, to);
  if (!piece.is_arc) return PlanePiece::line(a, b);
  PlanePiece cut = PlanePiece::arc(a, b, piece.center, piece.turns * (to - from));
  cut.slack = piece.slack;
  return cut;
}

}  // namespace kadr
