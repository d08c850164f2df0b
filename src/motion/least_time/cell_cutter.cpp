// CellCutter divides a smooth curve into cells. Used by motion/least_time/planner; tested by tests/motion/planner_test.cpp.

#include "motion/least_time/cell_cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.h"
#include "motion/least_time/least_time.h"
#include "motion/least_time/rest_to_rest.h"
#include "path/smooth/soft_corner.h"

namespace kadr {
namespace {

// Growth of the cell size per mm of distance from the corner, stop or change of feed at which the cells must be small.
constexpr double cell_growth = 0.2;
constexpr double corner_part = 1.0 / SoftCorner::cells;
// The greatest change of direction |Δu| at which a corner is treated like a corner between two chords of a curve.
constexpr double gentle = 0.1;
constexpr double longest_s = 0.014;  // duration of the longest cell at the commanded speed, s
// This value of ṡ², in mm²/s², means that there is no limit. It is finite so that it can be used in calculations.
constexpr double fastest = 1e12;

/// Computes the polynomial of the fifth degree that has the given values and first two derivatives at 0 and at `h`.
void quintic(const std::array<double, 3>& from, const std::array<double, 3>& to, double h, double* c) {
  const double delta = to[0] - from[0] - h * (from[1] + h * from[2] / 2);
  const double slope = to[1] - from[1] - h * from[2], bend = to[2] - from[2];
  c[0] = from[0];
  c[1] = from[1];
  c[2] = from[2] / 2;
  c[3] = (10 * delta - h * (4 * slope - h * bend / 2)) / (h * h * h);
  c[4] = (-15 * delta + h * (7 * slope - h * bend)) / (h * h * h * h);
  c[5] = (6 * delta - h * (3 * slope - h * bend / 2)) / (h * h * h * h * h);
}

}  // namespace

void CutCells::clear() {
  path.clear();
  sources.clear();
  standing.clear();
}

void CutCells::append(const CutCells& more) {
  path.append(more.path);
  sources.insert(sources.end(), more.sources.begin(), more.sources.end());
  standing.insert(standing.end(), more.standing.begin(), more.standing.end());
}

void CutCells::forget(std::size_t count) {
  path.forget(count);
  sources.erase(sources.begin(), sources.begin() + static_cast<std::ptrdiff_t>(count));
  standing.erase(standing.begin(), standing.begin() + static_cast<std::ptrdiff_t>(count));
}

CellCutter::CellCutter(const MotionLimits& limits) : axes_(limits.speed.size()), limits_(limits) {}

void CellCutter::begin() {
  cut_ = 0, piece_ = passed_ = 0, has_knot_ = false;
  needed_from_ = 0;
}

bool CellCutter::feed_changes(std::size_t vertex) const {
  // Relative changes of feed that are ignored. The feed is computed as length / time, with numerical errors. In polar or cylindrical
  // interpolation the feed varies along the whole path, so a greater change is ignored in these motions.
  constexpr double on_line = 1e-3, on_surface = 0.05;
  if (path_->is_paced(vertex)) return false;
  const double same = path_->on_curve(vertex) ? on_surface : on_line;
  const double before = path_->feed(vertex - 1), after = path_->feed(vertex);
  return std::fabs(before - after) > same * (before + after);
}

/// Returns the length, mm, that bounds the size of the cells at a change of feed. If the feed of the slower piece is at most half of the
/// other feed, this is the length of the slower piece; otherwise it is the length of the whole path. A cell has the lowest feed of its
/// pieces, so a cell must not extend far beyond a short and much slower piece.
double CellCutter::room_at_feed_change(std::size_t vertex) const {
  constexpr double much = 2;
  const std::size_t slower = path_->feed(vertex - 1) < path_->feed(vertex) ? vertex - 1 : vertex, faster = 2 * vertex - 1 - slower;
  if (path_->feed(faster) < much * path_->feed(slower)) return path_->ends() - path_->begins();
  return path_->at(slower + 1) - path_->at(slower);
}

/// Returns a time, s, that is longer than any ramp to `speed`. At positions farther than this time from both ends of a piece, the speed is
/// constant.
double CellCutter::ramp_s(double speed) const {
  double seconds = 0;
  for (std::size_t a = 0; a < axes_; ++a)
    seconds = std::max(seconds, speed / limits_.acceleration[a] + limits_.acceleration[a] / limits_.jerk[a]);
  return seconds;
}

/// Returns the cell size, mm, at the path length `s`. Cells are small at corners, reversals, stops and changes of feed, and their size
/// grows with the distance from these positions. A cell takes at most longest_s, except in the middle of a long piece. `curve_part` is the
/// cell size at the rounded corners between the chords of a curve, as a fraction of the width of these corners.
double CellCutter::size_at(double s, std::size_t piece, bool last, double curve_part) const {
  const double feed = path_->feed(piece), nearest = std::min(s - path_->at(piece), path_->at(piece + 1) - s);
  double size = longest_s * feed + cell_growth * std::max(0.0, nearest - feed * ramp_s(feed));
  // The cell size next to a stop, mm: a hundredth of `length`, but at most 0.01 mm. `length` is the length in which the speed can rise.
  const auto ramp_part = [](double length) { return 0.01 * std::min(1.0, length); };
  const auto rest = [&](std::size_t vertex) { return ramp_part(path_->room(vertex)); };
  size = std::min(size, rest(0) + cell_growth * s);
  if (last) size = std::min(size, rest(path_->pieces()) + cell_growth * (path_->ends() - s));
  const double reach = SmoothPath::widest + size / cell_growth;
  const auto take = [&](std::size_t i) {
    const double w = path_->width(i), away = std::fabs(s - path_->at(i));
    if (path_->turns_back(i)) size = std::min(size, rest(i) + cell_growth * away);
    else if (feed_changes(i)) size = std::min(size, ramp_part(room_at_feed_change(i)) + cell_growth * away);
    if (w > 0 && !path_->is_chained(i))
      size = std::min(
          size, w * (path_->on_curve(i) || path_->turn(i) < gentle ? curve_part : corner_part) + cell_growth * std::max(0.0, away - w));
  };
  const std::vector<std::size_t>& marks = path_->marks();
  auto mark = std::lower_bound(marks.begin(), marks.end(), s - reach, [&](std::size_t i, double from) { return path_->at(i) < from; });
  for (; mark != marks.end() && path_->at(*mark) < s + reach; ++mark) take(*mark);
  return std::min(size, size_in_chain(s, piece, reach));
}

/// Returns the size of a cell, mm, in a chain. A chain consists of gentle corners that are rounded together (path/smooth/smooth_path.h).
/// Between programmed lines the length of a cell is the width of the rounded corners, so that the cell smooths the path further. Between
/// the chords of a curve the path is already smooth. The cells are shorter on such a curve, because shorter cells follow the changes of
/// speed better.
double CellCutter::size_in_chain(double s, std::size_t piece, double reach) const {
  constexpr double between_lines = 1, on_curves = 0.45;  // cell size as a fraction of the width of the rounded corners
  double away = reach;
  bool on_curve = false;
  const auto take = [&](std::size_t i, double off) {
    if (off >= away || !path_->is_chained(i)) return;
    away = off;
    on_curve |= path_->on_curve(i);
  };
  for (std::size_t i = piece + 1; i-- > 1 && s - path_->at(i) < away;) take(i, s - path_->at(i));
  for (std::size_t i = piece + 1; i < path_->pieces() && path_->at(i) - s < away; ++i) take(i, path_->at(i) - s);
  if (away >= reach) return reach;
  const double w = path_->width_at(s, piece).w;
  return (on_curve ? on_curves : between_lines) * w + cell_growth * std::max(0.0, away - w);
}

/// Returns true if one polynomial can describe the path in a cell of the length `h`. This is the case if the curvature in the middle is
/// about the mean of the curvatures at both ends.
bool CellCutter::is_even(double h) {
  constexpr double uneven = 0.02;        // allowed deviation of the middle curvature from the mean, as a fraction of the curvature
  constexpr double unimportant = 0.008;  // A deviation that causes less than this fraction of the axis' acceleration limit is ignored.
  Knot middle, end;
  const std::size_t half = path_->piece_at(cut_ + h / 2, piece_), far = path_->piece_at(cut_ + h, half);
  path_->evaluate(cut_ + h / 2, half, middle.x.data(), middle.x1.data(), middle.x2.data());
  path_->evaluate(cut_ + h, far, end.x.data(), end.x1.data(), end.x2.data());
  double off = 0, most = 0;
  const double by_speed = unimportant / square(path_->feed(piece_));
  for (std::size_t a = 0; a < axes_; ++a) {
    const double of_axis = std::fabs(middle.x2[a] - (knot_.x2[a] + end.x2[a]) / 2);
    if (of_axis > by_speed * limits_.acceleration[a]) off = std::max(off, of_axis);
    most = std::max({most, std::fabs(knot_.x2[a]), std::fabs(middle.x2[a]), std::fabs(end.x2[a])});
  }
  return off <= uneven * most;
}

double CellCutter::next_size(bool last) {
  constexpr double wide = 0.2;
  double size = size_at(cut_, piece_, last, wide);
  const double least = size_at(cut_, piece_, last, corner_part);
  while (size > least && (cut_ + size > path_->ends() || !is_even(size))) size = std::max(least, size / 2);
  return size;
}

void CellCutter::set_knot(double s, std::size_t piece) { path_->evaluate(s, piece, knot_.x.data(), knot_.x1.data(), knot_.x2.data()); }

/// Returns the type (corner or curve) of the tightest rounded corner that extends into a cell. The cell starts at the last knot (the end of
/// the previous cell) and ends at the path length `to`.
Bend CellCutter::bend_at(double to, std::size_t end_piece) const {
  const double from = cut_, chain_before = path_->width_at(from, piece_).w, chain_after = path_->width_at(to, end_piece).w;
  Bend bend = Bend::none;
  double tightest = 0;
  const auto take = [&](std::size_t i, double chain) {
    const double w = path_->is_chained(i) ? chain : path_->width(i);
    if (w <= 0 || path_->at(i) - w >= to || path_->at(i) + w <= from || path_->turn(i) <= tightest * w) return;
    tightest = path_->turn(i) / w;
    bend = path_->on_curve(i) ? Bend::curve : Bend::corner;
  };
  for (std::size_t i = piece_ + 1; i-- > 1 && from - path_->at(i) < SmoothPath::widest;) take(i, chain_before);
  for (std::size_t i = piece_ + 1; i < path_->pieces() && path_->at(i) - to < SmoothPath::widest; ++i) take(i, chain_after);
  return bend;
}

/// Returns by how much the deviation of a cell from the path exceeds the tolerance, as a fraction of the tolerance. The cell starts at the
/// end of the previous cell and has the polynomial coefficients `c`. The deviation is checked at the vertices and halfway between them. If
/// the cell has few pieces, it is checked at more positions.
double CellCutter::beyond(const double* c, double to, std::size_t last_piece) const {
  constexpr double dense = 16;  // number of checked positions in a cell that lies within one piece
  // Fraction of the tolerance that a cell may use at the checked positions. The rest is a reserve for the positions between them.
  constexpr double used = 0.992;
  double most = 0;
  const auto look = [&](double s, std::size_t piece) {
    const double z = s - cut_;
    std::array<double, max_axes> x{};
    double squares = 0;
    for (std::size_t a = 0; a < axes_; ++a) {
      const double* const q = c + a * TimedPath::terms;
      x[a] = q[0] + z * (q[1] + z * (q[2] + z * (q[3] + z * (q[4] + z * q[5]))));
      squares += square(x[a] - path_->point(piece)[a] - (s - path_->at(piece)) * path_->direction(piece)[a]);
    }
    const double tolerance = std::max(path_->tolerance(piece), path_->tolerance(piece + 1));
    if (squares > square(used * tolerance)) most = std::max(most, path_->beyond(s, piece, x.data(), used));
  };
  for (std::size_t i = piece_; i <= last_piece; ++i) {
    const double from = std::max(cut_, path_->at(i)), until = std::min(to, path_->at(i + 1));
    const double places = std::clamp(std::ceil(dense * (until - from) / (to - cut_)), 2.0, dense);
    for (double k = 0; k < places; ++k) look(from + (until - from) * k / places, i);
  }
  look(to, last_piece);
  return most;
}

/// Returns the lowest feed, mm/s, of the pieces of a cell that starts at the end of the previous cell. Where the feed varies along the
/// path, it is the lowest feed at sample positions of the cell.
double CellCutter::feed_between(double from, double to) const {
  double feed = path_->feed(piece_);
  bool paced = piece_ > 0 && path_->is_paced(piece_);
  for (std::size_t i = piece_; i + 1 < path_->pieces(); ++i) {
    if (path_->at(i + 1) >= to) {
      paced |= path_->is_paced(i + 1);
      break;
    }
    if (path_->is_paced(i + 1)) paced = true;
    else feed = std::min(feed, path_->feed(i + 1));
  }
  if (!paced) return feed;
  feed = std::numeric_limits<double>::infinity();
  constexpr int places = 3;
  std::size_t piece = piece_;
  for (int i = 0; i < places; ++i) {
    const double s = from + (to - from) * i / (places - 1);
    piece = path_->piece_at(s, piece);
    feed = std::min(feed, path_->feed_at(s, piece));
  }
  return feed;
}

/// Computes the polynomials of a cell from the end of the previous cell to the path length `to`, and the end of the new cell.
///   returns  the excess of the cell's deviation over the tolerance, as a fraction of the tolerance
double CellCutter::draw_cell(double to, std::size_t end_piece, double* c, Knot& end) {
  const bool straight = bend_at(to, end_piece) == Bend::none;
  path_->evaluate(to, end_piece, end.x.data(), end.x1.data(), end.x2.data());
  const Knot& start = knot_;
  for (std::size_t a = 0; a < axes_; ++a) {
    double* const of_axis = c + a * TimedPath::terms;
    std::fill(of_axis, of_axis + TimedPath::terms, 0);
    if (straight)
      // A straight cell gets a linear polynomial. In a polynomial of the fifth degree, numerical errors would cause a third derivative, and
      // the jerk limit would then slow the cell down.
      of_axis[0] = start.x[a], of_axis[1] = start.x1[a];
    else quintic({start.x[a], start.x1[a], start.x2[a]}, {end.x[a], end.x1[a], end.x2[a]}, to - cut_, of_axis);
  }
  return straight ? 0 : beyond(c, to, end_piece);
}

/// Returns the greatest ṡ², mm²/s², that the feed and the axes' speed limits allow in a cell of the length `h`.
double CellCutter::most_in(const double* c, double h, double feed) const {
  double most = fastest;
  std::array<double, LeastTime::places> squares{};
  for (std::size_t a = 0; a < axes_; ++a)
    for (std::size_t p = 0; p < squares.size(); ++p) {
      const double x1 = Derivatives::at(c + a * TimedPath::terms, LeastTime::place_parts[p] * h).x1;
      if (x1 != 0) most = std::min(most, square(limits_.speed[a] / x1));
      squares[p] += square(x1);
    }
  for (const double rate_squared : squares) most = std::min(most, square(feed) / rate_squared);
  return most;
}

/// Returns the time, s, of the segment from `from` to `to` if the axes stopped at both ends of each piece. `piece` is the index of the
/// piece in which the segment starts.
double CellCutter::standing_s(double from, double to, std::size_t piece) {
  double seconds = 0;
  for (std::size_t i = piece; i < path_->pieces() && path_->at(i) < to; ++i) {
    if (standing_.piece != i) {
      const double length = path_->at(i + 1) - path_->at(i);
      standing_ = {i, rest_to_rest_s(length, limits_along(limits_, path_->direction(i), path_->feed(i))) / length};
    }
    seconds += standing_.per_mm * std::max(0.0, std::min(to, path_->at(i + 1)) - std::max(from, path_->at(i)));
  }
  return seconds;
}

/// Divides the last cell into several cells on the same path if the shape of the path, and not the feed, limits the speed. A cell on a
/// smooth path is long; after the division the speed can change within this length. `width` is the width in mm of the corners that are
/// rounded together in the cell.
void CellCutter::divide(double width, CutCells& out) const {
  constexpr double part = 0.2;  // length of a part of the cell as a fraction of `width`
  constexpr int max_parts = 8;
  const std::size_t last = out.count() - 1;
  const double h = out.path.h[last];
  const auto parts = static_cast<std::size_t>(std::clamp(std::ceil(h / (part * width)), 1.0, static_cast<double>(max_parts)));
  if (parts == 1 || fastest_alone(out.path, last) >= out.path.most[last]) return;
  out.path.divide_last(parts);
  out.sources.resize(out.count(), CellSource(out.sources.back()));
  out.standing.back() /= static_cast<double>(parts);
  out.standing.resize(out.count(), double(out.standing.back()));
  for (std::size_t k = last; k < out.count(); ++k) out.path.most[k] = most_in(out.path.shape(k, 0), out.path.h[k], out.sources[k].feed);
}

/// Adds a cell from the end of the previous cell to the path length `to`. If this cell would exceed the tolerance, a shorter cell is added.
///   returns  the path length at the end of the cell
double CellCutter::add_cell(double to, double least, bool turns, CutCells& out) {
  constexpr double smaller = 0.6;
  double* const c = out.path.add_shapes();
  const double from = cut_;
  Knot end;
  std::size_t next = path_->piece_at(to, piece_);
  double beyond = draw_cell(to, turns ? next - 1 : next, c, end);
  for (double size = smaller * (to - from); beyond > 0 && size > least; size *= smaller) {
    turns = false;
    to = from + size;
    next = path_->piece_at(to, piece_);
    beyond = draw_cell(to, next, c, end);
  }
  const double h = to - from, feed = feed_between(from, to);
  out.sources.push_back({path_->tag(piece_), feed, bend_at(to, next)});
  out.sources.back().beyond = beyond;
  out.standing.push_back(standing_s(from, to, piece_));
  out.path.h.push_back(h);
  out.path.most.push_back(most_in(c, h, feed));
  out.path.turns.push_back(turns ? 1 : 0);
  divide(path_->width_at(from, piece_).w, out);
  piece_ = next;
  knot_ = end;
  if (turns) set_knot(to, next);
  return to;
}

void CellCutter::cut(SmoothPath& path, bool last, StopToken stop, CutCells& out) {
  // Number of cells. If the remaining path before an end is shorter than this number of cells, the remaining path becomes one cell.
  constexpr double rest = 1.5;
  path_ = &path;
  standing_ = {};
  piece_ = passed_ - std::min(passed_, path.forgotten());
  if (!has_knot_) set_knot(cut_, piece_ = path.piece_at(cut_, 0));
  has_knot_ = true;
  const double settled = path.settled();
  for (std::size_t turn = piece_ + 1; cut_ < settled && !stop.requested();) {
    while (turn < path.pieces() && (path.at(turn) <= cut_ || !path.turns_back(turn))) ++turn;
    const bool known = turn < path.pieces();
    const double end = known ? path.at(turn) : path.ends(), size = next_size(last);
    const bool at_end = (known || last) && cut_ + rest * size >= end;
    const double to = at_end ? end : cut_ + size;
    if (to > settled) break;
    cut_ = add_cell(to, size_at(cut_, piece_, last, corner_part) / 4, at_end && known, out);
  }
  passed_ = piece_ + path.forgotten();
  double fastest_feed = 0;
  for (std::size_t i = piece_; i < path.pieces(); ++i) fastest_feed = std::max(fastest_feed, path.feed(i));
  // Distance in mm. Corners that are farther away are ignored, because they would only shorten very long cells.
  constexpr double farthest = 50;
  needed_from_ = path.at(piece_) - std::min(farthest, fastest_feed * longest_s / cell_growth);
}

}  // namespace kadr
