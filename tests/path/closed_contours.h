#pragma once
// Closed contours as programmers write them, and the slow reference that computes what the tool does to the part. Contours are inside
// or outside, entered at a corner or in the middle of a side, straight, along an arc or along the extension of a side, and some end
// beyond their beginning. Seeds are fixed.

#include <optional>
#include <random>

#include "contours.h"

namespace kadr::test {

enum class Entry : std::uint8_t { direct, arc, perpendicular, extension, count };
enum class Style : std::uint8_t { by_corner, checked, normal_arc, normal_line, tangent, count };  // nct, nct N1403, 2С42 G36 and G37, mach3

/// A side of the part: a line, or an arc of `turns` revolutions.
struct Side {
  Vec2 from, to;
  double turns = 0;  // counter-clockwise positive; 0 is a line

  Vec2 center() const {
    const Vec2 chord = to - from;
    return from + 0.5 * chord + 0.5 / std::tan(pi * turns) * left_of(chord);
  }
  Vec2 at(double part) const { return turns == 0 ? from + part * (to - from) : center() + rotated(from - center(), 360 * turns * part); }
  Vec2 tangent(double part) const {
    if (turns == 0) return 1 / length(to - from) * (to - from);
    const Vec2 arm = at(part) - center();
    return (turns > 0 ? 1 : -1) / length(arm) * left_of(arm);
  }
  Side piece(double first, double last) const { return {at(first), at(last), turns * (last - first)}; }
};

struct ClosedContour {
  std::vector<Side> loop;  // the part's contour in the direction in which the tool follows it
  std::vector<Motion> motions;
  Vec2 start;
  bool material_inside = false;
  double tool = 0;
};

class ContourMaker {
 public:
  explicit ContourMaker(std::uint64_t seed) : random_(seed) {}

  /// Returns any contour. `slender` gives narrow necks and small radii, for tools that are too large.
  ClosedContour any(bool slender) {
    ClosedContour c;
    c.tool = slender ? number(3, 15) : number(1, 8);
    c.material_inside = below(2) == 0;
    c.loop = slender && below(2) == 0 ? slotted() : star(slender);
    const bool clockwise = below(2) == 0;
    if (clockwise) reverse(c.loop);
    std::rotate(c.loop.begin(), c.loop.begin() + static_cast<std::ptrdiff_t>(below(c.loop.size())), c.loop.end());
    // With G41 the tool is left of the path: inside a counter-clockwise contour.
    side_ = static_cast<std::int8_t>(clockwise == c.material_inside ? 1 : -1);
    write(c, static_cast<Entry>(below(static_cast<std::size_t>(Entry::count))));
    return c;
  }

 private:
  double number(double least, double most) { return least + (most - least) * static_cast<double>(random_() >> 11) * 0x1p-53; }
  std::size_t below(std::size_t most) { return static_cast<std::size_t>(random_() % most); }

  /// Returns sides counter-clockwise around the origin; some are arcs.
  std::vector<Side> star(bool slender) {
    const std::size_t corners = 3 + below(9);
    std::vector<Vec2> at;
    for (std::size_t i = 0; i < corners; ++i) {
      const double angle = 360 * (static_cast<double>(i) + number(0, 0.6)) / static_cast<double>(corners);
      at.push_back(rotated({number(slender ? 12 : 40, 70), 0}, angle));
    }
    std::vector<Side> sides;
    for (std::size_t i = 0; i < corners; ++i)
      sides.push_back({at[i], at[(i + 1) % corners], below(3) == 0 ? number(0.02, 0.12) * (below(2) == 0 ? 1 : -1) : 0});
    return sides;
  }

  /// Returns a rectangle, counter-clockwise, with a slot in its upper side; the bottom of the slot is straight or round.
  std::vector<Side> slotted() {
    const double width = number(4, 40), depth = number(3, 40), half = width / 2;
    const bool round = below(2) == 0;
    std::vector<Side> sides{{{-50, -40}, {50, -40}}, {{50, -40}, {50, 30}}, {{50, 30}, {half, 30}}, {{half, 30}, {half, 30 - depth}}};
    sides.push_back({{half, 30 - depth}, {-half, 30 - depth}, round ? -0.5 : 0});
    sides.push_back({{-half, 30 - depth}, {-half, 30}});
    sides.push_back({{-half, 30}, {-50, 30}});
    sides.push_back({{-50, 30}, {-50, -40}});
    return sides;
  }

  static void reverse(std::vector<Side>& loop) {
    std::reverse(loop.begin(), loop.end());
    for (Side& s : loop) std::swap(s.from, s.to), s.turns = -s.turns;
  }

  /// Writes the programmed path: approach, run-in, loop, run-out, departure.
  void write(ClosedContour& c, Entry entry) {
    std::vector<Side> path;
    const bool in_middle = entry == Entry::arc || (entry != Entry::extension && below(2) == 0);
    if (in_middle) {  // the loop begins within a side
      const Side first = c.loop.front();
      const double part = number(0.2, 0.8);
      c.loop.front() = first.piece(part, 1);
      c.loop.push_back(first.piece(0, part));
    }
    path = c.loop;
    const Side &first = c.loop.front(), &last = c.loop.back();
    const bool over = in_middle && below(2) == 0;  // the path continues beyond the beginning of the loop
    if (over) path.push_back(first.piece(0, number(0.1, 0.5)));
    const Vec2 begin = first.from, ahead = first.tangent(0), end = path.back().to, end_tangent = path.back().tangent(1);
    const double run = c.tool + number(2, 12);
    switch (entry) {
      case Entry::arc: {
        const double radius = c.tool + number(1, 8), turns = side_ * number(0.1, 0.3);
        const Vec2 in_center = begin + side_ * radius * left_of(ahead), out_center = end + side_ * radius * left_of(end_tangent);
        path.insert(path.begin(), {in_center + rotated(begin - in_center, -360 * turns), begin, turns});
        path.push_back({end, out_center + rotated(end - out_center, 360 * turns), turns});
        break;
      }
      case Entry::perpendicular:
        path.insert(path.begin(), {begin + side_ * run * left_of(ahead), begin});
        path.push_back({end, end + side_ * run * left_of(end_tangent)});
        break;
      case Entry::extension:
        if (first.turns == 0) path.insert(path.begin(), {begin - run * ahead, begin});
        if (last.turns == 0) path.push_back({end, end + run * end_tangent});
        if (first.turns == 0 && below(2) == 0) path[0].to = path[1].to, path.erase(path.begin() + 1);  // joins them into one block
        break;
      default: break;
    }
    const Vec2 in = path.front().from, out = path.back().to;
    c.start = in - 3 * c.tool * path.front().tangent(0) + 2 * c.tool * side_ * left_of(path.front().tangent(0));
    add(c, {c.start, in}).side_step = SideStep::begins;
    for (const Side& s : path) add(c, s);
    const Vec2 away = path.back().tangent(1);
    add(c, {out, out + 3 * c.tool * away + 2 * c.tool * side_ * left_of(away)}).side_step = SideStep::ends;
  }

  Motion& add(ClosedContour& c, const Side& s) {
    Motion m = straight(MotionKind::feed, {s.to.x, s.to.y, 0}, 100);
    if (s.turns != 0) {
      const Vec2 center = s.center();
      m = arc(s.turns > 0 ? MotionKind::arc_ccw : MotionKind::arc_cw, {s.to.x, s.to.y, 0}, {center.x, center.y, 0}, std::fabs(s.turns));
    }
    m.named = 3;
    m.side = side_;
    m.tool_radius = c.tool;
    c.motions.push_back(m);
    return c.motions.back();
  }

  std::mt19937_64 random_;
  std::int8_t side_ = 1;
};

struct WatchedRun {
  bool alarm = false;
  double reported = 0;       // reported depth of the cut, mm
  std::vector<Motion> path;  // path of the tool's centre …
  std::vector<bool> along;   // … and for each motion whether it follows the contour, unlike approach and departure
};

inline WatchedRun carried_out(ClosedContour contour, Style style) {
  for (Motion& m : contour.motions) {
    m.entry = style == Style::tangent                                ? CompensationApproach::tangent
              : style == Style::by_corner || style == Style::checked ? CompensationApproach::by_corner
                                                                     : CompensationApproach::normal;
    if (style == Style::normal_arc || style == Style::tangent) m.join_corner = CornerJoin::arc;
    if (style == Style::normal_line) m.join_corner = CornerJoin::straight;
  }
  if (style != Style::by_corner && style != Style::checked) contour.motions.back().side = 0;
  ToolPosition at;
  at.work = at.machine = {contour.start.x, contour.start.y};
  RadiusCompensation compensation{at};
  WatchedRun run;
  const std::size_t count = contour.motions.size();
  for (std::size_t i = 0; i <= count && !run.alarm; ++i) {
    ActionBatch batch;
    if (i == 0) batch.add().what = CompensationCheck{style == Style::checked, false, 0, 0};
    else batch.add() = action(contour.motions[i - 1], static_cast<std::uint32_t>(i));
    run.alarm = compensation.take(batch, i == count).has_value();
    for (const Action& a : batch) {
      const auto* const m = std::get_if<Motion>(&a.what);
      if (m == nullptr) continue;
      run.path.push_back(*m);
      run.along.push_back(a.origin.line > 1 && a.origin.line < count);
    }
    for (const CompensationFault& w : compensation.warnings()) run.reported = std::max(run.reported, w.alarm.args[0].number());
  }
  return run;
}

/// Returns the least distance from a point to a side.
inline double away(Vec2 p, const Side& s) {
  double least = std::min(length(p - s.from), length(p - s.to));
  if (s.turns == 0) {
    const Vec2 delta = s.to - s.from;
    return length(p - s.from - std::clamp(dot(p - s.from, delta) / dot(delta, delta), 0.0, 1.0) * delta);
  }
  const Vec2 start = s.from - s.center(), arm = p - s.center();
  const double swept = angle_deg({dot(start, arm), (s.turns < 0 ? -1 : 1) * cross(start, arm)});
  if ((swept < 0 ? swept + 360 : swept) <= 360 * std::fabs(s.turns)) least = std::min(least, std::fabs(length(arm) - length(start)));
  return least;
}

/// The slow reference: returns how deep the swept disk goes into the part's material, mm; a negative value is its clearance.
inline double true_cut(const ClosedContour& contour, const WatchedRun& run) {
  std::vector<Vec2> polygon;
  for (const Side& s : contour.loop) {
    const int pieces = s.turns == 0 ? 1 : 48;
    for (int i = 0; i < pieces; ++i) polygon.push_back(s.at(double(i) / pieces));
  }
  const auto depth_at = [&](Vec2 p) {
    double least = 1e9;
    bool inside = false;
    for (const Side& s : contour.loop) least = std::min(least, away(p, s));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return contour.tool + (inside == contour.material_inside ? least : -least);
  };
  double deepest = -1e9;
  Axes from{contour.start.x, contour.start.y};
  for (std::size_t i = 0; i < run.path.size(); ++i) {
    if (run.along[i])
      for (const Vec2 p : sampled({run.path[i]}, from)) deepest = std::max(deepest, depth_at(p));
    from = run.path[i].to;
  }
  return deepest;
}

}  // namespace kadr::test
