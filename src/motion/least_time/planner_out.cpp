// What a planner hands out: cells with their speed, a straight line, cells one by one where no speed was found; never what is no plan.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "action/action.h"
#include "motion/least_time/planner.h"

namespace kadr {
namespace {

double square(double x) { return x * x; }

}  // namespace

LineLimits Planner::limits_along(const double* way, double feed) const {
  constexpr double none = std::numeric_limits<double>::infinity();
  LineLimits line{feed, none, none};
  for (std::size_t a = 0; a < now_.cells.axes; ++a) {
    if (way[a] == 0) continue;
    line.speed = std::min(line.speed, limits_.speed[a] / std::fabs(way[a]));
    line.acceleration = std::min(line.acceleration, limits_.acceleration[a] / std::fabs(way[a]));
    line.jerk = std::min(line.jerk, limits_.jerk[a] / std::fabs(way[a]));
  }
  return line;
}

void Planner::straight_line() {
  std::array<double, max_axes> x{}, way{}, x2{};
  now_.path.evaluate(0, 0, x.data(), way.data(), x2.data());
  out_.clear();
  rest_to_rest(now_.path.ends(), limits_along(way.data(), now_.path.feed(0)), out_.laws);
  double s = 0;
  std::size_t piece = 0;
  for (const TimeLaw& law : out_.laws) {
    for (std::size_t a = 0; a < now_.cells.axes; ++a) out_.path.insert(out_.path.end(), {x[a] + s * way[a], way[a], 0, 0, 0, 0});
    piece = now_.path.piece_at(s, piece);
    out_.sources.push_back({now_.path.tag(piece), now_.path.feed(piece), Bend::none});
    s += law.length;
  }
  hand_on(now_.path.begins(), now_.path.ends());
}

double Planner::way_of_cells() const { return std::accumulate(now_.cells.h.begin(), now_.cells.h.end(), 0.0); }

/// What a stretch of the path takes with a stop at each corner, s.
double Planner::standing_s(double from, double to) const {
  double seconds = 0;
  for (std::size_t i = now_.path.piece_at(from, 0); i < now_.path.pieces() && now_.path.at(i) < to; ++i) {
    const double way = std::min(to, now_.path.at(i + 1)) - std::max(from, now_.path.at(i));
    if (way > 0) seconds += rest_to_rest_s(way, limits_along(now_.path.direction(i), now_.path.feed(i)));
  }
  return seconds;
}

/// Out goes what was planned of a stretch of the path, if it is a plan.
void Planner::hand_on(double from, double to) {
  const double seconds = out_.seconds();
  if (std::isfinite(seconds) && seconds <= most_of_standing * standing_s(from, to)) return sink_(out_);
  std::size_t longest = 0;
  for (std::size_t k = 1; k < out_.laws.size() && std::isfinite(out_.laws[longest].seconds); ++k)
    if (!(out_.laws[k].seconds <= out_.laws[longest].seconds)) longest = k;
  now_.ended = PlanEnd::too_slow;
  now_.refused = {to - from, out_.sources.empty() ? now_.path.tag(now_.path.piece_at(from, 0)) : out_.sources[longest].tag};
}

/// The first cells go out; the path begins anew after them, from a stop if they end with one.
void Planner::hand_out(std::size_t count, bool stops) {
  const std::size_t axes = now_.cells.axes, all = now_.cells.cells();
  const std::vector<CellSpeeds>& speeds = timer_.speeds();
  out_.clear();
  for (std::size_t k = 0; k < count; ++k) {
    const PathSpeed from = speeds[k].start, to = speeds[k].end;
    const double h = now_.cells.h[k], q = (to.d - from.d) / h;
    if (k == 0 && now_.ends.from_stop) out_.laws.push_back(TimeLaw::from_rest(h, std::sqrt(to.b), false));
    else if (k + 1 == count && (stops || (count == all && now_.ends.to_stop)))
      out_.laws.push_back(TimeLaw::from_rest(h, std::sqrt(from.b), true));
    else out_.laws.push_back(TimeLaw::of_squares(h, std::sqrt(from.b), from.d / 2, q / 2));
  }
  out_.path.assign(now_.cells.shapes.begin(), now_.cells.shapes.begin() + static_cast<std::ptrdiff_t>(count * axes * TimedCells::terms));
  out_.sources.assign(now_.sources.begin(), now_.sources.begin() + static_cast<std::ptrdiff_t>(count));
  const double from = now_.cut - way_of_cells();
  hand_on(from, from + std::accumulate(now_.cells.h.begin(), now_.cells.h.begin() + static_cast<std::ptrdiff_t>(count), 0.0));
  if (count == all) return;
  now_.ends.from_stop = stops;
  now_.ends.from = stops ? PathSpeed{} : speeds[count].start;
  const auto cut = [](auto& v, std::size_t n) { v.erase(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n)); };
  now_.ends.guess.clear();
  if (!stops)
    now_.ends.guess.assign(timer_.middles().begin() + static_cast<std::ptrdiff_t>(count),
                           timer_.middles().begin() + static_cast<std::ptrdiff_t>(all));
  cut(now_.sources, count);
  now_.cells.forget(count);
  const std::size_t before = now_.path.pieces();
  now_.path.forget(now_.cut - way_of_cells());
  now_.piece -= before - now_.path.pieces();
}

/// No speed was found that goes on from an earlier solution: where that ended crawling the axes stop, and the rest begins from there.
///   returns  false: there is no such place, or they cannot stop there
bool Planner::stop_where_known() {
  const std::size_t known = now_.ends.guess.size();
  if (now_.ends.from_stop || known < least_cells || known >= now_.cells.cells()) return false;
  PathEnds ends = now_.ends;
  ends.to_stop = true;
  if (!timer_.solve(now_.cells.first(known), ends, stop_)) return false;
  hand_out(known, true);
  return true;
}

/// No speed was found: the cells one after the other, as straight lines with a stop after each.
void Planner::cell_by_cell() {
  ++now_.failures;
  const std::size_t axes = now_.cells.axes, row = axes * TimedCells::terms;
  out_.clear();
  for (std::size_t k = 0; k < now_.cells.cells(); ++k) {
    std::array<double, max_axes> from{}, to{}, way{};
    TimedCells cell{axes,
                    {},
                    {},
                    {now_.cells.shapes.begin() + static_cast<std::ptrdiff_t>(k * row),
                     now_.cells.shapes.begin() + static_cast<std::ptrdiff_t>((k + 1) * row)}};
    cell.position(0, 0, from.data());
    cell.position(0, now_.cells.h[k], to.data());
    double squares = 0;
    for (std::size_t a = 0; a < axes; ++a) squares += square(to[a] - from[a]);
    const double length = std::sqrt(squares);
    if (!(length > 0)) continue;
    for (std::size_t a = 0; a < axes; ++a) way[a] = (to[a] - from[a]) / length;
    const std::size_t before = out_.laws.size();
    rest_to_rest(length, limits_along(way.data(), std::sqrt(now_.cells.most[k])), out_.laws);
    double s = 0;
    for (std::size_t i = before; i < out_.laws.size(); s += out_.laws[i++].length) {
      for (std::size_t a = 0; a < axes; ++a) out_.path.insert(out_.path.end(), {from[a] + s * way[a], way[a], 0, 0, 0, 0});
      out_.sources.push_back(now_.sources[k]);
    }
  }
  out_.unsolved = true;
  hand_on(now_.cut - way_of_cells(), now_.cut);
  now_.cells.clear();
  now_.sources.clear();
  now_.ends = {};
}

}  // namespace kadr
