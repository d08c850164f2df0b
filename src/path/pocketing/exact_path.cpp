// This file restores the exact lines and arcs of an offset contour from its polygon. The corners of an offset polygon lie on the offsets of
// the original edges (lines and arcs) and on circles around the end points of these edges. Used by path/pocketing/field; tested by
// tests/path/pocketing/recover_test.cpp.

#include "path/pocketing/exact_path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/tolerance.h"

namespace kadr::area {
namespace {

// The greatest distance between a corner and its carrier, mm: the sum of three chord errors. One is the error of the source, one the error
// of the offset, and one is a reserve.
constexpr double off = 3 * tol::area_chord;
// number of cells in each direction of the grid that finds the carriers (lines and circles) near a point
constexpr std::size_t across = 64;

double away(const Carrier& c, Vec2 p) {
  return c.line ? std::abs(cross(c.direction, p - c.point)) : std::abs(length(p - c.point) - c.radius);
}

Vec2 on_carrier(const Carrier& c, Vec2 p) {
  if (c.line) return c.point + dot(c.direction, p - c.point) * c.direction;
  const Vec2 out = p - c.point;
  return c.point + (c.radius / std::max(length(out), tol::same_point)) * out;
}

bool carries(const Carrier& c, Vec2 a, Vec2 b) {
  if (away(c, a) > off || away(c, b) > off) return false;
  if (c.line) return true;
  const double chord = length(b - a);
  // The chord may lie on the circle if its middle is at most 2 · off away from the circle.
  return chord * chord <= 16 * off * c.radius && c.radius > off;
}

void add_feet(std::vector<Vec2>& points, const Carrier& line, const Carrier& circle) {
  const Vec2 foot = line.point + dot(line.direction, circle.point - line.point) * line.direction;
  const double apart = length(foot - circle.point);
  if (apart > circle.radius + off) return;
  const double half = std::sqrt(std::max(0.0, (circle.radius - apart) * (circle.radius + apart)));
  points.push_back(foot + half * line.direction);
  points.push_back(foot - half * line.direction);
}

std::vector<Vec2> meetings(const Carrier& a, const Carrier& b) {
  std::vector<Vec2> points;
  if (a.line && b.line) {
    const double turn = cross(a.direction, b.direction);
    if (std::abs(turn) > tol::tangential) points.push_back(a.point + (cross(b.point - a.point, b.direction) / turn) * a.direction);
  } else if (a.line) add_feet(points, a, b);
  else if (b.line) add_feet(points, b, a);
  else {
    const Vec2 delta = b.point - a.point;
    const double apart = length(delta);
    if (apart < tol::same_point || apart > a.radius + b.radius + off || apart < std::abs(a.radius - b.radius) - off) return points;
    const double along = (apart * apart + (a.radius - b.radius) * (a.radius + b.radius)) / (2 * apart);
    const double half = std::sqrt(std::max(0.0, (a.radius - along) * (a.radius + along)));
    const Vec2 unit = (1 / apart) * delta;
    for (const double side : {half, -half}) points.push_back(a.point + along * unit + side * Vec2{-unit.y, unit.x});
  }
  return points;
}

/// Returns the angle from `a` to `b` about the centre in degrees, positive counter-clockwise. The angle is ambiguous by multiples of 360°;
/// the value nearest to `about` is returned.
double turned(Vec2 centre, Vec2 a, Vec2 b, double about) {
  const double deg = std::atan2(cross(a - centre, b - centre), dot(a - centre, b - centre)) / rad_per_deg;
  return about + std::remainder(deg - about, 360);
}

/// Appends the arc from `a` to `b` on the circle `c`. The swept angle of the arc is about `about` degrees.
void emit_arc(Edges& path, const Carrier& c, Vec2 a, Vec2 b, double about) {
  const double sweep = turned(c.point, a, b, about);
  const int pieces = std::abs(sweep) > 180 ? 2 : 1;
  const double bulge = std::tan(sweep / pieces / 4 * rad_per_deg);
  const Vec2 middle = pieces == 2 ? c.point + kadr::rotated(a - c.point, sweep / 2) : b;
  path.push_back({a, middle, bulge});
  if (pieces == 2) path.push_back({middle, b, bulge});
}

}  // namespace

/// A sequence of consecutive chords that all lie on the same carrier.
struct Carriers::Run {
  std::size_t first = 0, count = 0;  // index of the first chord of the run, and number of its chords
  std::optional<std::uint32_t> carrier;
};

void Carriers::add(const Edges& source, double by) {
  cells_.clear();
  const auto boxed = [&](Carrier c, const Edge& e) {
    c.box.take(e);
    const double room = by + 2 * off;
    c.box = {c.box.least - Vec2{room, room}, c.box.most + Vec2{room, room}};
    add(c);
  };
  for (const Edge& e : source) {
    if (is_line(e)) {
      const Vec2 tangent = direction(e, 0), normal{-tangent.y, tangent.x};
      boxed({true, e.from + by * normal, tangent, 0, {}}, e);
      if (by > 0) boxed({true, e.from - by * normal, tangent, 0, {}}, e);
    } else {
      const Circle c = circle_of(e);
      boxed({false, c.centre, {}, c.radius + by, {}}, e);
      if (by > 0) boxed({false, c.centre, {}, std::abs(c.radius - by), {}}, e);
    }
    if (by > 0) {
      boxed({false, e.from, {}, by, {}}, {e.from, e.from});
      boxed({false, e.to, {}, by, {}}, {e.to, e.to});
    }
  }
}

void Carriers::index() const {
  if (!cells_.empty()) return;
  cells_.resize(across * across);
  box_ = {};
  for (const Carrier& c : all_) box_.take(c.box.least), box_.take(c.box.most);
  const Vec2 size = box_.most - box_.least;
  const auto cell = [](double at, double least, double extent) {
    return static_cast<std::size_t>(std::clamp((at - least) / std::max(extent, off) * across, 0.0, across - 1.0));
  };
  for (std::uint32_t i = 0; i < all_.size(); ++i) {
    const Bounds& b = all_[i].box;
    for (std::size_t x = cell(b.least.x, box_.least.x, size.x); x <= cell(b.most.x, box_.least.x, size.x); ++x)
      for (std::size_t y = cell(b.least.y, box_.least.y, size.y); y <= cell(b.most.y, box_.least.y, size.y); ++y)
        cells_[x * across + y].push_back(i);
  }
}

std::vector<std::uint32_t> Carriers::on(Vec2 a, Vec2 b) const {
  index();
  const Vec2 size = box_.most - box_.least;
  const auto cell = [](double place, double least, double extent) {
    return static_cast<std::size_t>(std::clamp((place - least) / std::max(extent, off) * across, 0.0, across - 1.0));
  };
  const auto& near = cells_[cell(a.x, box_.least.x, size.x) * across + cell(a.y, box_.least.y, size.y)];
  std::vector<std::uint32_t> found;
  for (const std::uint32_t i : near) {
    const Bounds& box = all_[i].box;
    const bool inside = a.x >= box.least.x && a.x <= box.most.x && a.y >= box.least.y && a.y <= box.most.y;
    if (inside && carries(all_[i], a, b)) found.push_back(i);
  }
  return found;
}

std::vector<Carriers::Run> Carriers::runs(const Polygon& corners, bool closed) const {
  const std::size_t count = corners.size(), chords = closed ? count : count - 1;
  std::size_t start = 0;
  // Cosine of the change of direction at the sharpest corner. The search for runs starts at this corner, because no run continues over it.
  double sharpest = 2;
  for (std::size_t i = 0; closed && i < count; ++i) {
    const Vec2 in = corners[i] - corners[(i + count - 1) % count], out = corners[(i + 1) % count] - corners[i];
    const double cosine = dot(in, out) / std::max(length(in) * length(out), 1e-300);
    if (cosine < sharpest) sharpest = cosine, start = i;
  }
  std::vector<Run> found;
  for (std::size_t done = 0; done < chords;) {
    Run run{(start + done) % count, 1, {}};
    const auto ends = [&](std::size_t i) { return std::pair(corners[(start + i) % count], corners[(start + i + 1) % count]); };
    std::vector<std::uint32_t> left = on(ends(done).first, ends(done).second);
    while (!left.empty()) {
      run.carrier = left.front();
      if (done + run.count == chords) break;
      const auto [a, b] = ends(done + run.count);
      std::erase_if(left, [&, from = a, to = b](std::uint32_t i) { return !carries(all_[i], from, to); });
      if (!left.empty()) ++run.count;
    }
    done += run.count;
    found.push_back(run);
  }
  return found;
}

Edges Carriers::recovered(const Polygon& corners, bool closed) const {
  Edges path;
  if (corners.size() < 2) return path;
  const std::size_t count = corners.size();
  const std::vector<Run> all = runs(corners, closed);
  const auto reach = [&](const Run& run) {  // returns how far, mm, an end point of the run may be moved
    return 0.45 * length(corners[(run.first + run.count) % count] - corners[run.first]) + (run.count == count ? 1e300 : 0);
  };
  const auto joint = [&](const Run& before, const Run& after) {
    const Vec2 corner = corners[after.first];
    const auto& nearest = before.carrier ? before.carrier : after.carrier;
    Vec2 best = nearest ? on_carrier(all_[*nearest], corner) : corner;
    double least = std::max(2 * off, std::min(reach(before), reach(after)));
    if (before.carrier && after.carrier && before.carrier != after.carrier)
      for (const Vec2 p : meetings(all_[*before.carrier], all_[*after.carrier]))
        if (length(p - corner) < least) least = length(p - corner), best = p;
    return best;
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Run& run = all[i];
    const bool begins = !closed && i == 0, ends = !closed && i + 1 == all.size();
    const Vec2 a = begins ? corners.front() : joint(all[(i + all.size() - 1) % all.size()], run);
    const Vec2 b = ends ? corners.back() : joint(run, all[(i + 1) % all.size()]);
    if (!run.carrier || all_[*run.carrier].line) {
      path.push_back({a, b});
      continue;
    }
    const Carrier& c = all_[*run.carrier];
    // Swept angle of the run, degrees. A chord that is short compared with the error of the corners may go backwards, so the angles of all
    // chords are added.
    double about = 0;
    for (std::size_t k = 0; k < run.count; ++k)
      about += turned(c.point, corners[(run.first + k) % count], corners[(run.first + k + 1) % count], 0);
    emit_arc(path, c, a, b, about);
  }
  std::erase_if(path, [](const Edge& e) { return length(e.to - e.from) < tol::same_point; });
  for (std::size_t i = 0; i + (closed ? 0 : 1) < path.size(); ++i) path[(i + 1) % path.size()].from = path[i].to;
  return path;
}

}  // namespace kadr::area
