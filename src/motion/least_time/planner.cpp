// Planner: a path of straight pieces and stops → positions in time, with the least time that the axes' limits and the path's tolerances
// allow (mode `optimal` of a machine profile). For the rest of motion; tested by tests/motion/planner_test.cpp.

#include "motion/least_time/planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "action/action.h"
#include "path/smooth/soft_corner.h"

namespace kadr {
namespace {

constexpr std::size_t planned_at = 1024;   // pieces: so many come in before the next plan
constexpr std::size_t least_window = 600;  // cells
constexpr std::size_t most_window = 6000;  // cells: then some are handed out though the window's end may have slowed them
constexpr double crawl_of_slowest = 0.03;  // of ṡ² that the slowest cell allows: after the window's end
constexpr double growth = 0.2;             // of the cells, by their distance from what made them small
constexpr double corner_part = 1.0 / SoftCorner::cells;
constexpr double gentle = 0.1;       // |Δu| of corners that are like those of a curve
constexpr double longest_s = 0.014;  // of a cell, at the commanded speed
constexpr double fastest = 1e12;     // mm²/s²: no limit of ṡ², in numbers that can be calculated with

double square(double x) { return x * x; }

/// The polynomial of the fifth degree with position and two derivatives given at 0 and h.
void quintic(const std::array<double, 3>& from, const std::array<double, 3>& to, double h, double* c) {
  const double way = to[0] - from[0] - h * (from[1] + h * from[2] / 2);
  const double slope = to[1] - from[1] - h * from[2], bend = to[2] - from[2];
  c[0] = from[0];
  c[1] = from[1];
  c[2] = from[2] / 2;
  c[3] = (10 * way - h * (4 * slope - h * bend / 2)) / (h * h * h);
  c[4] = (-15 * way + h * (7 * slope - h * bend)) / (h * h * h * h);
  c[5] = (6 * way - h * (3 * slope - h * bend / 2)) / (h * h * h * h * h);
}

}  // namespace

Planner::Planner(MotionLimits limits, Sink sink) : limits_(std::move(limits)), sink_(std::move(sink)), now_(limits_.speed.size()) {
  now_.cells.axes = out_.axes = limits_.speed.size();
  now_.cells.acceleration = limits_.acceleration;
  now_.cells.jerk = limits_.jerk;
}

void Planner::begin(const double* at) {
  now_.at.assign(at, at + now_.cells.axes);
  now_.way.clear();
  now_.path.begin(at);
  now_.cells.clear();
  now_.sources.clear();
  now_.cut = 0;
  now_.has_knot = false;
  now_.piece = now_.fresh = 0;
  now_.fresh_s = 0;
  now_.ends = {};
}

/// The next piece goes another way than the last.
bool Planner::turns(const double* to) const {
  constexpr double straight = 1e-9;  // |Δu|
  if (now_.way.empty()) return false;
  double squares = 0, bend = 0;
  for (std::size_t a = 0; a < now_.cells.axes; ++a) squares += square(to[a] - now_.at[a]);
  const double length = std::sqrt(squares);
  for (std::size_t a = 0; a < now_.cells.axes; ++a) bend += square((to[a] - now_.at[a]) / length - now_.way[a]);
  return bend > square(straight);
}

void Planner::line_to(const double* to, double feed, double tolerance, bool on_curve, std::uint64_t tag, bool paced) {
  if (halted()) return;
  if (tolerance <= 0 && turns(to)) stop();
  const std::size_t before = now_.path.pieces();
  now_.path.line_to(to, feed, tolerance, on_curve, tag, paced);
  if (now_.path.pieces() == before) return;
  double squares = 0;
  for (std::size_t a = 0; a < now_.cells.axes; ++a) squares += square(to[a] - now_.at[a]);
  now_.way.resize(now_.cells.axes);
  for (std::size_t a = 0; a < now_.cells.axes; ++a) now_.way[a] = (to[a] - now_.at[a]) / std::sqrt(squares);
  now_.at.assign(to, to + now_.cells.axes);
  ++now_.fresh;
  now_.fresh_s += std::sqrt(squares) / feed;
  if (is_due()) plan(false);
}

bool Planner::is_due() const { return now_.fresh >= planned_at || (plan_each_ > 0 && now_.fresh_s >= plan_each_); }

void Planner::stop() {
  if (!halted() && !now_.path.empty()) plan(true);
  const std::vector<double> at = now_.at;
  begin(at.data());
}

bool Planner::halted() {
  if (now_.ended == PlanEnd::none && stop_.asked()) now_.ended = PlanEnd::stopped;
  return now_.ended != PlanEnd::none;
}

void Planner::plan(bool last) {
  now_.fresh = 0, now_.fresh_s = 0;
  if (last && now_.cells.cells() == 0 && now_.ends.from_stop && now_.path.is_one_line()) return straight_line();
  now_.path.settle(last, stop_);
  if (halted()) return;
  cut_cells(last);
  if (halted()) return;
  if (last || now_.cells.cells() >= least_window) solve(last);
}

bool Planner::feed_changes(std::size_t vertex) const {
  constexpr double of_way = 1e-6,
                   on_surface = 0.05;  // relative: the feed is the way divided by its time; on a surface it changes all along
  if (now_.path.is_paced(vertex)) return false;
  const double same = now_.path.on_curve(vertex) ? on_surface : of_way;
  const double before = now_.path.feed(vertex - 1), behind = now_.path.feed(vertex);
  return std::fabs(before - behind) > same * (before + behind);
}

/// A cell has the lowest feed of its pieces: of a short one that is much slower it must not reach far beyond it, mm.
double Planner::room_at_feed_change(std::size_t vertex) const {
  constexpr double much = 2;
  const std::size_t slower = now_.path.feed(vertex - 1) < now_.path.feed(vertex) ? vertex - 1 : vertex, faster = 2 * vertex - 1 - slower;
  if (now_.path.feed(faster) < much * now_.path.feed(slower)) return now_.path.ends() - now_.path.begins();
  return now_.path.at(slower + 1) - now_.path.at(slower);
}

/// Longer than any ramp to a speed lasts, s: farther from the ends of a piece it is passed evenly.
double Planner::ramp_s(double speed) const {
  double seconds = 0;
  for (std::size_t a = 0; a < now_.cells.axes; ++a)
    seconds = std::max(seconds, speed / limits_.acceleration[a] + limits_.acceleration[a] / limits_.jerk[a]);
  return seconds;
}

/// Size of a cell at a length: small at corners, turns, stops and changes of feed, growing away from them; no longer than is
/// passed in longest_s, but in the middle of a long piece. `curve_part`: of a rounding's
/// width, of those between the chords of a curve.
double Planner::size_at(double s, std::size_t piece, bool last, double curve_part) const {
  const double feed = now_.path.feed(piece), nearest = std::min(s - now_.path.at(piece), now_.path.at(piece + 1) - s);
  double size = longest_s * feed + growth * std::max(0.0, nearest - feed * ramp_s(feed));
  const auto ramp_part = [](double way) { return 0.01 * std::min(1.0, way); };  // beside a stop: a part of the way that a ramp takes
  const auto rest = [&](std::size_t vertex) { return ramp_part(now_.path.room(vertex)); };
  size = std::min(size, rest(0) + growth * s);
  if (last) size = std::min(size, rest(now_.path.pieces()) + growth * (now_.path.ends() - s));
  const SmoothPath& path = now_.path;
  const double reach = SmoothPath::widest + size / growth;
  const auto take = [&](std::size_t i) {
    const double w = path.width(i), away = std::fabs(s - path.at(i));
    if (path.turns_back(i)) size = std::min(size, rest(i) + growth * away);
    else if (feed_changes(i)) size = std::min(size, ramp_part(room_at_feed_change(i)) + growth * away);
    if (w > 0 && !path.is_chained(i))
      size = std::min(size, w * (path.on_curve(i) || path.turn(i) < gentle ? curve_part : corner_part) + growth * std::max(0.0, away - w));
  };
  const std::vector<std::size_t>& marks = path.marks();
  auto mark = std::lower_bound(marks.begin(), marks.end(), s - reach, [&](std::size_t i, double from) { return path.at(i) < from; });
  for (; mark != marks.end() && path.at(*mark) < s + reach; ++mark) take(*mark);
  return std::min(size, size_in_chain(s, piece, reach));
}

/// Of a cell among the chain's corners.
double Planner::size_in_chain(double s, std::size_t piece, double reach) const {
  constexpr double part = 1;  // of the width
  const SmoothPath& path = now_.path;
  double away = reach;
  for (std::size_t i = piece + 1; i-- > 1 && s - path.at(i) < away;)
    if (path.is_chained(i)) away = s - path.at(i);
  for (std::size_t i = piece + 1; i < path.pieces() && path.at(i) - s < away; ++i)
    if (path.is_chained(i)) away = path.at(i) - s;
  if (away >= reach) return reach;
  const double w = path.width_at(s, piece).w;
  return part * w + growth * std::max(0.0, away - w);
}

/// The path bends so evenly along a cell that one polynomial shows it: in its middle as in the mean of its ends.
bool Planner::is_even(double h) {
  constexpr double uneven = 0.02;        // of the curvature
  constexpr double unimportant = 0.008;  // of the acceleration that the axis may have
  Memory::Knot middle, end;
  const std::size_t half = now_.path.piece_at(now_.cut + h / 2, now_.piece), far = now_.path.piece_at(now_.cut + h, half);
  now_.path.evaluate(now_.cut + h / 2, half, middle.x.data(), middle.x1.data(), middle.x2.data());
  now_.path.evaluate(now_.cut + h, far, end.x.data(), end.x1.data(), end.x2.data());
  double off = 0, most = 0;
  const double by_speed = unimportant / square(now_.path.feed(now_.piece));
  for (std::size_t a = 0; a < now_.cells.axes; ++a) {
    const double of_axis = std::fabs(middle.x2[a] - (now_.knot.x2[a] + end.x2[a]) / 2);
    if (of_axis > by_speed * limits_.acceleration[a]) off = std::max(off, of_axis);
    most = std::max({most, std::fabs(now_.knot.x2[a]), std::fabs(middle.x2[a]), std::fabs(end.x2[a])});
  }
  return off <= uneven * most;
}

double Planner::next_size(bool last) {
  constexpr double wide = 0.2;
  double size = size_at(now_.cut, now_.piece, last, wide);
  const double least = size_at(now_.cut, now_.piece, last, corner_part);
  while (size > least && (now_.cut + size > now_.path.ends() || !is_even(size))) size = std::max(least, size / 2);
  return size;
}

void Planner::set_knot(double s, std::size_t piece) {
  now_.path.evaluate(s, piece, now_.knot.x.data(), now_.knot.x1.data(), now_.knot.x2.data());
}

/// Of the roundings that reach into a cell the tightest one.
Bend Planner::bend_at(double to, std::size_t end_piece) const {
  const SmoothPath& path = now_.path;
  const double from = now_.cut, chain_before = path.width_at(from, now_.piece).w, chain_behind = path.width_at(to, end_piece).w;
  Bend bend = Bend::none;
  double tightest = 0;
  const auto take = [&](std::size_t i, double chain) {
    const double w = path.is_chained(i) ? chain : path.width(i);
    if (w <= 0 || path.at(i) - w >= to || path.at(i) + w <= from || path.turn(i) <= tightest * w) return;
    tightest = path.turn(i) / w;
    bend = path.on_curve(i) ? Bend::curve : Bend::corner;
  };
  for (std::size_t i = now_.piece + 1; i-- > 1 && from - path.at(i) < SmoothPath::widest;) take(i, chain_before);
  for (std::size_t i = now_.piece + 1; i < path.pieces() && path.at(i) - to < SmoothPath::widest; ++i) take(i, chain_behind);
  return bend;
}

/// How far a cell with these polynomials, from the knot on, is beyond the tolerance of the path, as a share of it: at vertices, halfway
/// between, and in more places if it has few pieces.
double Planner::beyond(const double* c, double to, std::size_t last_piece) const {
  constexpr double dense = 12;  // places in a cell within one piece
  const SmoothPath& path = now_.path;
  double most = 0;
  const auto look = [&](double s, std::size_t piece) {
    const double z = s - now_.cut;
    std::array<double, max_axes> x{};
    double squares = 0;
    for (std::size_t a = 0; a < now_.cells.axes; ++a) {
      const double* const q = c + a * TimedPath::terms;
      x[a] = q[0] + z * (q[1] + z * (q[2] + z * (q[3] + z * (q[4] + z * q[5]))));
      squares += square(x[a] - path.point(piece)[a] - (s - path.at(piece)) * path.direction(piece)[a]);
    }
    const double tolerance = std::max(path.tolerance(piece), path.tolerance(piece + 1));
    if (squares > square(tolerance)) most = std::max(most, path.beyond(s, piece, x.data()));
  };
  for (std::size_t i = now_.piece; i <= last_piece; ++i) {
    const double from = std::max(now_.cut, path.at(i)), until = std::min(to, path.at(i + 1));
    const double places = std::clamp(std::ceil(dense * (until - from) / (to - now_.cut)), 2.0, dense);
    for (double k = 0; k < places; ++k) look(from + (until - from) * k / places, i);
  }
  look(to, last_piece);
  return most;
}

/// The lowest feed of the pieces from where the last cell ends; where it changes with the path, the lowest in places of the cell.
double Planner::feed_between(double from, double to) const {
  const SmoothPath& path = now_.path;
  double feed = path.feed(now_.piece);
  bool paced = now_.piece > 0 && path.is_paced(now_.piece);
  for (std::size_t i = now_.piece; i + 1 < path.pieces(); ++i) {
    if (path.at(i + 1) >= to) {
      paced |= path.is_paced(i + 1);
      break;
    }
    if (path.is_paced(i + 1)) paced = true;
    else feed = std::min(feed, path.feed(i + 1));
  }
  if (!paced) return feed;
  feed = std::numeric_limits<double>::infinity();
  constexpr int places = 3;
  std::size_t piece = now_.piece;
  for (int i = 0; i < places; ++i) {
    const double s = from + (to - from) * i / (places - 1);
    piece = path.piece_at(s, piece);
    feed = std::min(feed, path.feed_at(s, piece));
  }
  return feed;
}

/// The polynomials of a cell from the knot to a length, and the knot there.
///   returns  how far it is beyond the tolerance
double Planner::draw_cell(double to, std::size_t end_piece, double* c, Memory::Knot& end) {
  const bool straight = bend_at(to, end_piece) == Bend::none;
  now_.path.evaluate(to, end_piece, end.x.data(), end.x1.data(), end.x2.data());
  const Memory::Knot& start = now_.knot;
  for (std::size_t a = 0; a < now_.cells.axes; ++a) {
    double* const of_axis = c + a * TimedPath::terms;
    std::fill(of_axis, of_axis + TimedPath::terms, 0);
    if (straight)
      of_axis[0] = start.x[a], of_axis[1] = start.x1[a];  // no rounding of small differences, whose third derivative would slow it
    else quintic({start.x[a], start.x1[a], start.x2[a]}, {end.x[a], end.x1[a], end.x2[a]}, to - now_.cut, of_axis);
  }
  return straight ? 0 : beyond(c, to, end_piece);
}

/// A cell from the knot on, of this size or, where that leaves the tolerance, a smaller one.
///   returns  where it ends
double Planner::add_cell(double to, double least, bool turns) {
  constexpr double smaller = 0.6;
  double* const c = now_.cells.add_shapes();
  const double from = now_.cut;
  Memory::Knot end;
  std::size_t next = now_.path.piece_at(to, now_.piece);
  double beyond = draw_cell(to, turns ? next - 1 : next, c, end);
  for (double size = smaller * (to - from); beyond > 0 && size > least; size *= smaller) {
    turns = false;
    to = from + size;
    next = now_.path.piece_at(to, now_.piece);
    beyond = draw_cell(to, next, c, end);
  }
  const double h = to - from, feed = feed_between(from, to);
  now_.sources.push_back({now_.path.tag(now_.piece), feed, bend_at(to, next)});
  now_.sources.back().beyond = beyond;
  now_.piece = next;
  now_.knot = end;
  double most = fastest;
  std::array<double, LeastTime::places> squares{};
  for (std::size_t a = 0; a < now_.cells.axes; ++a)
    for (std::size_t p = 0; p < squares.size(); ++p) {
      const double x1 = Derivatives::at(c + a * TimedPath::terms, LeastTime::place_parts[p] * h).x1;
      if (x1 != 0) most = std::min(most, square(limits_.speed[a] / x1));
      squares[p] += square(x1);
    }
  for (const double way : squares) most = std::min(most, square(feed) / way);
  now_.cells.h.push_back(h);
  now_.cells.most.push_back(most);
  now_.cells.turns.push_back(turns ? 1 : 0);
  if (turns) set_knot(to, next);
  return to;
}

void Planner::cut_cells(bool last) {
  if (!now_.has_knot) set_knot(now_.cut, now_.piece = now_.path.piece_at(now_.cut, 0));
  now_.has_knot = true;
  constexpr double rest = 1.5;  // cells: what is left before an end becomes one
  const double settled = now_.path.settled();
  for (std::size_t turn = now_.piece + 1; now_.cut < settled && !stop_.asked();) {
    while (turn < now_.path.pieces() && (now_.path.at(turn) <= now_.cut || !now_.path.turns_back(turn))) ++turn;
    const bool known = turn < now_.path.pieces();
    const double end = known ? now_.path.at(turn) : now_.path.ends(), size = next_size(last);
    const bool at_end = (known || last) && now_.cut + rest * size >= end;
    const double to = at_end ? end : now_.cut + size;
    if (to > settled) break;
    now_.cut = add_cell(to, size_at(now_.cut, now_.piece, last, corner_part) / 4, at_end && known);
  }
}

/// How many cells of a solution that ends crawling are as they will be: up to the last speed that the end has not lowered.
std::size_t Planner::sure_cells() const {
  const std::vector<CellSpeeds>& speeds = timer_.speeds();
  std::size_t cell = now_.cells.cells();
  while (cell > 1 && speeds[cell - 1].start.b >= speeds[cell - 1].end.b) --cell;
  return cell;
}

void Planner::solve(bool last) {
  now_.ends.to_stop = last;
  now_.ends.crawl = crawl_of_slowest * slowest_alone(now_.cells);
  bool found = timer_.solve(now_.cells, now_.ends, stop_);
  constexpr double as_slow = 2, a_little = 1e-6;  // the earlier solution's crawl does, where the new cells are hardly slower than its own
  if (const auto& known = now_.ends.guess; !found && !halted() && !known.empty() && known.back() < as_slow * now_.ends.crawl) {
    now_.ends.crawl = std::max(now_.ends.crawl, (1 + a_little) * known.back());
    found = timer_.solve(now_.cells, now_.ends, stop_);
  }
  if (halted()) return;
  if (!found && stop_where_known()) return last || now_.cells.cells() >= least_window ? solve(last) : void();
  if (!found) return cell_by_cell();
  if (last) return hand_out(now_.cells.cells());
  const std::size_t all = now_.cells.cells(), sure = sure_cells();
  if (sure >= all / 3) hand_out(sure - sure / 8);
  else if (all > most_window) hand_out(all / 3);
}

}  // namespace kadr
