#pragma once
// TiltedCutter: removes what one body of a tilted tool sweeps in one sweep from one brick. Only stock/cut/tilted_cut includes this file,
// and compiles it for each type of processor.
//
// The cutter first finds the squares of 4 × 4 lattice lines along Z that the sweep reaches. Then it finds the lines near the sweep: by
// their distance from the tool's axis, and by a cylinder in the pose half way, enlarged by the tool's shift (its motion without the turn).
// For a cylinder, the poses at both ends of the path decide most lines (tilted_pose.h). For other bodies the cutter tests an enlarged body
// with the shift of the brick's middle. Then it approaches the ends of the swept interval from outside, using the shift at the position on
// the line where the tool leaves the line. A ball end cuts first; the shaft cuts only what the ball leaves.

#include "stock/cut/cutter_lanes.h"
#include "stock/cut/tilted_ball.h"
#include "stock/cut/tilted_cut.h"
#include "stock/cut/tilted_over_rows.h"

namespace kadr {

class TiltedCutter : public Cutter {
 public:
  TiltedCutter(Brick& brick, const BrickScale& scale, const TiltedCut& cut, std::int32_t by, CutOutcome& outcome, LineSet& later);

  bool takes_all() const;
  template <class V>
  void cut();

 private:
  static constexpr int squares_along = 4;
  /// The material that the sweep reaches, in squares of 4 × 4 lattice lines along Z.
  struct Reached {
    std::uint32_t squares = 0;  // one bit for each square
    // For each column and row of reached squares, in mm: the greatest height of material and the least height that the sweep reaches. A
    // column or row is not cut if the first height is below the second.
    float top_x[squares_along], top_y[squares_along], low_x[squares_along], low_y[squares_along];
  };
  template <class V>
  Reached reached(const PathPast<V>& past) const;
  template <class V>
  Swept<V> over_squares(const PathPast<V>& past, const V& x, const V& y) const;
  template <class V>
  TiltedFamily<V> lines_of(int family, const PathPast<V>& past) const;
  template <class V>
  TiltedPosition<V> evenly_shifted_position(const TiltedLines<V>& lines, const Vec3Of<V>& at) const;
  template <class V>
  Vec3Of<V> line_value(const float (&middle)[3], const float (&grows)[3][3], int family, const V& lanes, float row) const;
  template <class V, TiltedBody::Kind kind>
  void cut_kind(const Reached& reached, const PathPast<V>& past);
  template <class V, TiltedBody::Kind kind, int family>
  void cut_family(const Reached& reached, const PathPast<V>& past);
  template <class V, TiltedBody::Kind kind>
  Swept<V> ends_in(const TiltedFamily<V>& all, int family, const TiltedRow<V>& line, const Swept<V>& guess, const Swept<V>& material) const;
  template <class V, TiltedBody::Kind kind>
  bool sweeps(const TiltedFamily<V>& all, int family, int row, int lane, const Swept<V>& material, Swept<V>& swept) const;
  template <class V>
  bool sweeps_cylinder(const TiltedFamily<V>& all, int family, TiltedRow<V>& line, const MarksOf<V>& near, const Swept<V>& material,
                       Swept<V>& swept) const;
  template <class V>
  bool sweeps_ball(const TiltedFamily<V>& all, int family, const BallTube& tube, int row, int lane, const Swept<V>& material,
                   Swept<V>& swept);
  template <class V, TiltedBody::Kind kind>
  Swept<V> by_end(const TiltedFamily<V>& all, int family, const TiltedRow<V>& line, const Swept<V>& guess, const MarksOf<V>& by_from,
                  const MarksOf<V>& sought, const Swept<V>& material) const;
  template <class V>
  void leave_for_later(const MarksOf<V>& later, int family, int row, int lane);
  template <class V, TiltedBody::Kind kind>
  MarksOf<V> for_later(const TiltedFamily<V>& all, int family, int row, int lane, const Swept<V>& swept, const Swept<V>& material);
  template <class V, TiltedBody::Kind kind>
  MarksOf<V> may_reach_farther(const TiltedFamily<V>& all, int family, const TiltedRow<V>& line, const Swept<V>& swept,
                               const Swept<V>& material) const;
  template <class V>
  MarksOf<V> is_where_flat(const TiltedFamily<V>& all, const TiltedRow<V>& line, int family, const V& place) const;
  static void material_of_all(const BrickLines& lines, float* from, float* to);
  struct RowRange {
    int first, last;  // indices of rows; `last` is one after the last row
  };
  static RowRange rows_of(const Reached& reached, int family, int square, int lane, const BrickScale& scale);
  FacesNear faces_near() const;
  BallPath ball_path(float radius) const;
  bool is_below_shaft() const;

  const TiltedSweep& tilted_sweep_;
  const TiltedBody& tilted_body_;
  TiltedBody outer_, around_square_;
  float half_;
  Frustum around_;
  FacesNear near_;
  bool shifts_little_;
  // Encloses what the body (of a ball-end tool: the shaft) sweeps, enlarged by half a square of lines along Z; used only if shifts_little_.
  Frustum around_columns_;
  float widest_;   // greatest radius of the body in mm, with a margin for the error of an estimated shift
  BallPath ball_;  // path of the ball, if the body has a ball end
  bool below_shaft_;
  TiltedOver over_;
  const LineSet* only_;
  LineSet& later_;
};

/// These functions cut a brick, eight lines at a time, with two vectors of 16 bytes (pair) or one vector of 32 bytes (wide, needs AVX2).
void cut_tilted_pair(TiltedCutter& cutter);
void cut_tilted_wide(TiltedCutter& cutter);

/// Accepted error in mm of an end of a swept interval. If the shift of a position x mm away from the end is used, the end has an error of x
/// times the angle in radians by which the tool turns.
inline constexpr float accepted_error = 2.5e-4f;
inline constexpr int quick_steps = 2, max_refined = 16;

template <class V>
KADR_IN_LANES MarksOf<V> meet(const Swept<V>& a, const Swept<V>& b) {
  return (b.from < b.to) & (a.from < b.to) & (a.to > b.from);
}

template <class V>
KADR_IN_LANES Vec3Of<V> vector_of(const float (&v)[3]) {
  return {spread<V>(v[0]), spread<V>(v[1]), spread<V>(v[2])};
}

template <class V>
KADR_IN_LANES Vec3Of<V> TiltedCutter::line_value(const float (&middle)[3], const float (&grows)[3][3], int family, const V& lanes,
                                                 float row) const {
  const auto& u = grows[(family + 1) % 3];
  const auto& v = grows[(family + 2) % 3];
  return {lanes * u[0] + (row * v[0] + middle[0]), lanes * u[1] + (row * v[1] + middle[1]), lanes * u[2] + (row * v[2] + middle[2])};
}

/// Returns the lattice lines of a family in the tool's coordinates. `past` is the motion of the tool past the middle of the brick.
template <class V>
KADR_IN_LANES TiltedFamily<V> TiltedCutter::lines_of(int family, const PathPast<V>& past) const {
  const float* const e = tilted_sweep_.axes[family];
  const auto aside = [&](const float* v) { return v[0] * e[1] - v[1] * e[0]; };
  const float sine = std::sqrt(e[0] * e[0] + e[1] * e[1]),
              reach = widest_ * sine + std::fabs(aside(tilted_sweep_.shift)) / 2 + shortest_path;
  const Heading heading(tilted_sweep_.axes[family]);
  return {{heading, heading, heading, past},
          Heading(tilted_sweep_.axes_first[family]),
          Heading(tilted_sweep_.axes_last[family]),
          aside(tilted_sweep_.middle),
          aside(tilted_sweep_.axes[(family + 1) % 3]),
          aside(tilted_sweep_.axes[(family + 2) % 3]),
          reach};
}
template <class V>
KADR_IN_LANES TiltedPosition<V> TiltedCutter::evenly_shifted_position(const TiltedLines<V>& l, const Vec3Of<V>& at) const {
  const Vec3Of<V> first = plus(at, spread<V>(0.5f), l.past.travel), last = plus(at, spread<V>(-0.5f), l.past.travel);
  return {first, first, last};
}

/// Tests whether the sweep reaches squares of 4 × 4 lines along Z. Each square is replaced by the line through its middle, and the body is
/// enlarged by the size of a square.
template <class V>
KADR_OWN_FUNCTION Swept<V> TiltedCutter::over_squares(const PathPast<V>& past, const V& x, const V& y) const {
  const auto& a = tilted_sweep_.axes;
  const Vec3Of<V> at{x * a[0][0] + y * a[1][0] + tilted_sweep_.middle[0], x * a[0][1] + y * a[1][1] + tilted_sweep_.middle[1],
                     x * a[0][2] + y * a[1][2] + tilted_sweep_.middle[2]};
  const Heading heading(tilted_sweep_.axes[2]);
  const TiltedLines<V> lines{heading, heading, heading, past};
  const TiltedPosition<V> start = evenly_shifted_position(lines, at);
  const auto by_shaft = [&] {
    if (shifts_little_) return in_cylinder(at, heading, around_columns_);
    return in_shifted_frustum<V, Side::straight>(lines, start, around_square_.shaft, near_);
  };
  if (around_square_.kind == TiltedBody::Kind::cone) return tilted_swept<V, TiltedBody::Kind::cone>(lines, around_square_, start, near_);
  if (around_square_.kind != TiltedBody::Kind::ball) return by_shaft();
  const Swept<V> ball = in_ball_tube(BallTube(ball_path(around_square_.corner), 2), x, y);
  return below_shaft_ ? ball : either(ball, by_shaft());
}

template <class V>
KADR_IN_LANES TiltedCutter::Reached TiltedCutter::reached(const PathPast<V>& past) const {
  static constexpr float middles[16] = {2, 6, 10, 14, 2, 6, 10, 14, 2, 6, 10, 14, 2, 6, 10, 14};
  Reached r;
  std::fill(r.top_x, r.top_x + squares_along, -1.f), std::fill(r.top_y, r.top_y + squares_along, -1.f);
  std::fill(r.low_x, r.low_x + squares_along, missed), std::fill(r.low_y, r.low_y + squares_along, missed);
  for (int part = 0; part < 16; part += lane_count) {
    alignas(32) float x_of[lane_count], y_of[lane_count], low_of[lane_count], high_of[lane_count];
    for (int i = 0; i < lane_count; ++i)
      x_of[i] = middles[part + i] * scale_.cell - half_, y_of[i] = float((part + i) / 4 * 4 + 2) * scale_.cell - half_;
    const Swept<V> s = over_squares(past, lanes_at<V>(x_of), lanes_at<V>(y_of));
    store(low_of, s.from), store(high_of, s.to);
    for (int i = 0; i < lane_count; ++i) {
      const int square = part + i;
      const float top = std::min(brick_.top_of_square[std::size_t(square)], high_of[i] + half_), low = low_of[i] + half_;
      if (low_of[i] > high_of[i] || low >= brick_.top_of_square[std::size_t(square)] || top < 0) continue;
      r.squares |= 1u << square;
      const int column = square % squares_along, row = square / squares_along;
      r.top_x[column] = std::max(r.top_x[column], top), r.top_y[row] = std::max(r.top_y[row], top);
      r.low_x[column] = std::min(r.low_x[column], low), r.low_y[row] = std::min(r.low_y[row], low);
    }
  }
  return r;
}

/// Returns the rows in which the sweep may reach one of eight lines; `lane` is the first line, and `square` the row of squares to search.
inline TiltedCutter::RowRange TiltedCutter::rows_of(const Reached& r, int family, int square, int lane, const BrickScale& scale) {
  constexpr int wide = brick_edge / squares_along;
  const RowRange all{square * wide, square * wide + wide}, none{0, 0};
  if (family == 2) return (r.squares >> (square * squares_along + lane / wide) & 3) != 0 ? all : none;
  if (family == 1) return scale.place[lane] <= r.top_x[square] && scale.place[lane + lane_count - 1] >= r.low_x[square] ? all : none;
  const float low = std::min(r.low_y[lane / wide], r.low_y[lane / wide + 1]),
              top = std::max(r.top_y[lane / wide], r.top_y[lane / wide + 1]);
  RowRange rows = all;
  while (rows.first < rows.last && scale.place[rows.first] < low) ++rows.first;
  while (rows.first < rows.last && scale.place[rows.last - 1] > top) --rows.last;
  return rows;
}

template <class V>
KADR_IN_LANES void TiltedCutter::cut() {
  const PathPast<V> past = path_past(vector_of<V>({-tilted_sweep_.shift[0], -tilted_sweep_.shift[1], -tilted_sweep_.shift[2]}));
  const Reached r = reached<V>(past);
  if (r.squares == 0) return;
  over_ = TiltedOver(tilted_sweep_, tilted_body_, scale_.edge);
  switch (tilted_body_.kind) {
    case TiltedBody::Kind::cylinder: return cut_kind<V, TiltedBody::Kind::cylinder>(r, past);
    case TiltedBody::Kind::cone: return cut_kind<V, TiltedBody::Kind::cone>(r, past);
    case TiltedBody::Kind::ball: return cut_kind<V, TiltedBody::Kind::ball>(r, past);
    case TiltedBody::Kind::rounded: return cut_kind<V, TiltedBody::Kind::rounded>(r, past);
  }
}

template <class V, TiltedBody::Kind kind>
KADR_IN_LANES void TiltedCutter::cut_kind(const Reached& r, const PathPast<V>& past) {
  cut_family<V, kind, 2>(r, past);
  cut_family<V, kind, 1>(r, past);
  cut_family<V, kind, 0>(r, past);
}

/// Finds one end of the swept interval of each line in `sought`: where the tool enters the line (in the lanes of `by_from`), else where it
/// leaves the line. A position is swept if the tool, with the shift at exactly this position, contains the position. So the test is
/// repeated at the last position found, then between a position inside and a position outside the tool. A line that is missed with the
/// shift at one position may be met with the shift at a position nearer to the middle of the interval.
template <class V, TiltedBody::Kind kind>
KADR_OWN_FUNCTION Swept<V> TiltedCutter::by_end(const TiltedFamily<V>& all, int family, const TiltedRow<V>& line, const Swept<V>& guess,
                                                const MarksOf<V>& by_from, const MarksOf<V>& sought, const Swept<V>& material) const {
  const V half = spread<V>(half_);
  const auto in_brick = [&](const V& place) { return within(place, -half, half); };
  const Vec3Of<V> grows = vector_of<V>(tilted_sweep_.shift_grows[family]);
  TiltedLines<V> lines{all.even.heading, all.first, all.last, all.even.past};
  V low = -half, high = half, place = in_brick(choose(by_from, guess.from, guess.to) - half);
  V middle = 0.5f * (in_brick(guess.from - half) + in_brick(guess.to - half));
  MarksOf<V> open = sought;
  Swept<V> end_of{spread<V>(missed), spread<V>(-missed)};
  for (int i = 0;; ++i) {
    const Vec3Of<V> here = plus(line.shift, place, grows);
    lines.past = path_past<V>({-here.x, -here.y, -here.z});
    const TiltedPosition<V> at{plus(line.at, spread<V>(-0.5f), here), line.first, line.last};
    Swept<V> found = either(line.at_ends, tilted_between<V, kind>(lines, tilted_body_, at, near_));
    if (over_.family[family].any()) found = either(found, shifted_at_ends<V, kind>(lines, tilted_body_, at.at));
    const V end = choose(by_from, found.from, found.to), moved = most(end - place, place - end);
    const MarksOf<V> misses = found.from > found.to, above = choose(misses, place<middle, end> place);
    end_of = {choose(open, found.from, end_of.from), choose(open, found.to, end_of.to)};
    low = choose(open & above, place, low), high = choose(open & ~above, place, high);
    const V between = i == 0 ? middle : 0.5f * (low + high);
    const V next = choose(misses | (spread<V>(float(i)) > float(quick_steps)), between, within(end, low, high));
    middle = choose(misses, middle, 0.5f * (in_brick(found.from) + in_brick(found.to)));
    const V step = choose(misses, high - low, least(moved, high - low)), room = 0.1f * step;
    open = open & (misses | meet(found, {material.from - room - half_, material.to + room - half_})) &
           (step * tilted_sweep_.half_turn > accepted_error);
    if (i + 1 == max_refined || !any(open)) break;
    place = next;
  }
  // Only ends inside the brick are corrected. Ends outside the brick need not be exact, because no material is removed outside the brick.
  const MarksOf<V> misses = end_of.from > end_of.to, inside = (low > -half) & (high < half);
  const V from = choose(inside, within(end_of.from, low, high), end_of.from), to = choose(inside, within(end_of.to, low, high), end_of.to);
  const Swept<V> end{choose(by_from, from, end_of.from) + half_, choose(by_from, end_of.to, to) + half_};
  return where(~misses, end.from, end.to);
}

/// Returns the intervals of the lines that the tool sweeps. Ends outside `material` need not be exact, because nothing is removed there.
template <class V, TiltedBody::Kind kind>
KADR_IN_LANES Swept<V> TiltedCutter::ends_in(const TiltedFamily<V>& all, int family, const TiltedRow<V>& line, const Swept<V>& guess,
                                             const Swept<V>& material) const {
  const float room = scale_.cell / 8;
  const MarksOf<V> reached = meet(guess, material);
  const MarksOf<V> by_from = (guess.from > material.from - room) | (guess.to > material.to + room);
  const Swept<V> one = by_end<V, kind>(all, family, line, guess, by_from, reached, material);
  // Only an interval in an end pose (start or end of the path) shows with certainty whether the tool leaves the line beyond the material.
  const MarksOf<V> open_from = line.at_ends.from + half_ > material.from, open_to = line.at_ends.to + half_ < material.to;
  const MarksOf<V> other_to = by_from & ((one.to < material.to + room) | open_to);
  const MarksOf<V> other_from = ~by_from & ((one.from > material.from - room) | open_from);
  // The second end is computed even if the line seems to miss the material at the first end, because the shift at the second end differs.
  const MarksOf<V> sought = reached & (one.from <= one.to) & (other_to | other_from);
  if (!any(sought)) return one;
  const Swept<V> two = by_end<V, kind>(all, family, line, one, ~by_from, sought, material);
  return {choose(sought & other_from, two.from, one.from), choose(sought & other_to, two.to, one.to)};
}

/// Computes the intervals of eight lines that the tool, or only its shaft, sweeps.
///   returns  false if none of the intervals meets material
template <class V, TiltedBody::Kind kind>
KADR_OWN_FUNCTION bool TiltedCutter::sweeps(const TiltedFamily<V>& all, int family, int row, int lane, const Swept<V>& material,
                                            Swept<V>& swept) const {
  const V places = lanes_at<V>(scale_.place + lane) - half_;
  const float row_position = scale_.place[row] - half_;
  const V aside = places * all.aside_lane + (row_position * all.aside_row + all.aside);
  const MarksOf<V> within_reach = (material.from < material.to) & (aside <= all.reach) & (aside >= -all.reach);
  if (!any(within_reach)) return false;
  TiltedRow<V> line;
  line.at = line_value(tilted_sweep_.middle, tilted_sweep_.axes, family, places, row_position);
  // A quick test with the pose half way along the path, and a body enlarged by the shift, excludes most lines.
  const Swept<V> nearly = in_cylinder(line.at, all.even.heading, around_);
  const MarksOf<V> near = within_reach & meet({nearly.from + half_, nearly.to + half_}, material);
  if (!any(near)) return false;
  line.shift = line_value(tilted_sweep_.shift, tilted_sweep_.shift_grows, family, places, row_position);
  line.first = plus(line.at, spread<V>(-0.5f), line.shift), line.last = plus(line.at, spread<V>(0.5f), line.shift);
  line.at = plus(line.at, spread<V>(0.5f), vector_of<V>(tilted_sweep_.aside));
  if constexpr (kind == TiltedBody::Kind::cylinder) {
    return sweeps_cylinder<V>(all, family, line, near, material, swept);
  } else {
    const Swept<V> even = tilted_swept<V, kind>(all.even, outer_, evenly_shifted_position(all.even, line.at), near_);
    const Swept<V> guess{even.from + half_, even.to + half_};
    const MarksOf<V> reached = meet(guess, material);
    if (!any(reached)) return false;
    swept = guess;
    if (tilted_sweep_.half_turn == 0) return true;
    line.at_ends =
        tilted_at_ends<V, kind>({all.even.heading, all.first, all.last, all.even.past}, tilted_body_, {line.first, line.first, line.last});
    swept = {line.at_ends.from + half_, line.at_ends.to + half_};
    if (any(reached & ((swept.from > material.from) | (swept.to < material.to))))
      swept = ends_in<V, kind>(all, family, line, guess, material);
    return true;
  }
}

/// Does for a cylinder what sweeps() does for other bodies. Between the end poses, only lines of which more may be swept are tested.
template <class V>
KADR_IN_LANES bool TiltedCutter::sweeps_cylinder(const TiltedFamily<V>& all, int family, TiltedRow<V>& line, const MarksOf<V>& near,
                                                 const Swept<V>& material, Swept<V>& swept) const {
  constexpr auto cylinder = TiltedBody::Kind::cylinder;
  const Frustum& f = tilted_body_.shaft;
  const Pose<V> first = in_pose(line.first, all.first, f), last = in_pose(line.last, all.last, f);
  line.at_ends = either(where(first.in.from <= first.in.to, first.in.from, first.in.to), last.in);
  swept = {line.at_ends.from + half_, line.at_ends.to + half_};
  const PastTool<V> past{line.shift, vector_of<V>(tilted_sweep_.shift_grows[family]), f.low_radius, 4 * tilted_sweep_.half_turn,
                         tilted_sweep_.bend};
  MarksOf<V> open_from = near & (swept.from > material.from), open_to = near & (swept.to < material.to);
  if (any(open_from)) open_from = open_from & ~is_farthest_back(first, last, past);
  if (any(open_to)) open_to = open_to & ~is_farthest_on(first, last, past);
  if (!any(open_from | open_to)) return any(meet(swept, material));
  // Most lines that the cylinder misses in both end poses are missed during the whole path, so a quick test excludes them.
  const MarksOf<V> misses = swept.from > swept.to;
  MarksOf<V> reached = open_from | open_to;
  Swept<V> guess = swept;
  if (tilted_sweep_.half_turn == 0 || any(reached & misses)) {
    const Swept<V> even = tilted_swept<V, cylinder>(all.even, outer_, evenly_shifted_position(all.even, line.at), near_);
    guess = {even.from + half_, even.to + half_};
    reached = reached & meet(guess, material);
    if (!any(reached)) return any(meet(swept, material));
  }
  Swept<V> between = guess;
  if (tilted_sweep_.half_turn > 0) {
    between = by_end<V, cylinder>(all, family, line, guess, open_from, reached, material);
    const MarksOf<V> other = open_from & open_to & reached & (between.from <= between.to);
    if (any(other)) between.to = choose(other, by_end<V, cylinder>(all, family, line, between, ~open_from, other, material).to, between.to);
  }
  swept = {choose(reached & open_from, between.from, swept.from), choose(reached & open_to, between.to, swept.to)};
  return true;
}

template <class V, TiltedBody::Kind kind, int family>
KADR_OWN_FUNCTION void TiltedCutter::cut_family(const Reached& reached, const PathPast<V>& past) {
  BrickLines& lines = brick_.family[std::size_t(family)];
  const bool several = !lines.further.empty();
  alignas(32) float all_from[brick_lines], all_to[brick_lines], all_tips[brick_lines], first[brick_lines], last[brick_lines];
  if (several) {
    std::fill(all_from, all_from + brick_lines, missed), std::fill(all_to, all_to + brick_lines, -missed);
    std::fill(all_tips, all_tips + brick_lines, missed);
    material_of_all(lines, first, last);
  }
  const V none = spread<V>(0.f);
  Taken<V> taken{none, none, none, spread<V>(missed)};  // a tilted tool reports no depth: a tip at the height `missed` gives the depth 0
  const TiltedFamily<V> all = lines_of<V>(family, past);
  [[maybe_unused]] const auto tube = [&] {
    if constexpr (kind == TiltedBody::Kind::ball) return BallTube(ball_, family);
    else return 0;
  }();
  for (int part = 0; part < squares_along * brick_edge / lane_count; ++part) {
    const int lane = part % (brick_edge / lane_count) * lane_count;
    const RowRange rows = rows_of(reached, family, part * lane_count / brick_edge, lane, scale_);
    for (int row = rows.first; row < rows.last; ++row) {
      const int at = row * brick_edge + lane;
      const Swept<V> material{lanes_at<V>((several ? first : lines.from) + at), lanes_at<V>((several ? last : lines.to) + at)};
      if (!any(material.from < material.to)) continue;
      if (only_ != nullptr && only_->bits[family][at / LineSet::at_once] == 0) continue;
      Swept<V> swept;
      if constexpr (kind == TiltedBody::Kind::ball) {
        if (!sweeps_ball<V>(all, family, tube, row, lane, material, swept)) continue;
      } else {
        if (!sweeps<V, kind>(all, family, row, lane, material, swept)) continue;
      }
      if (only_ != nullptr) swept = where(marks_of<V>(only_->bits[family][at / LineSet::at_once]), swept.from, swept.to);
      if (kind != TiltedBody::Kind::ball && over_.family[family].any())
        swept = where(~for_later<V, kind>(all, family, row, lane, swept, material), swept.from, swept.to);
      if (several) store(all_from + at, swept.from), store(all_to + at, swept.to);
      take<V, family>(lines, at, swept, taken);
    }
  }
  if (several) take_further(lines, family, all_from, all_to, all_tips);
  add_taken<V, family>(taken);
}

}  // namespace kadr
