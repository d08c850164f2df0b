// WindowTimer finds the speed of a path's cells, window by window. Used by motion/least_time/planner; tested by
// tests/motion/planner_test.cpp.

#include "motion/least_time/window_timer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/arithmetic.h"
#include "motion/least_time/rest_to_rest.h"

namespace kadr {
namespace {

constexpr std::size_t least_window = 600;  // number of waiting cells at which their speeds are computed as one window
// Number of cells. If a window has more cells, some of them are emitted although the crawl at the end of the window may have slowed them
// down.
constexpr std::size_t max_window = 6000;
// squared path speed of the crawl at the end of a window, as a fraction of the squared speed that the slowest cell allows
constexpr double crawl_of_slowest = 0.03;

}  // namespace

WindowTimer::WindowTimer(const MotionLimits& limits) : limits_(limits) {
  now_.cells.path.axes = limits.speed.size();
  now_.cells.path.acceleration = limits.acceleration;
  now_.cells.path.jerk = limits.jerk;
}

void WindowTimer::begin() {
  now_.cells.clear();
  now_.ends = {};
}

void WindowTimer::take(const CutCells& more, bool last, StopToken stop) {
  now_.cells.append(more);
  if (last || now_.cells.count() >= least_window) solve(last, stop);
  if (last) begin();
}

/// Adds the plan of a segment of the path to done() if the plan is valid. Otherwise the function stores the plan as refused.
void WindowTimer::pass_cells_on(TimedCells made, double standing, std::uint64_t tag) {
  const double seconds = made.seconds();
  if (std::isfinite(seconds) && seconds <= most_of_standing * standing) return done_.push_back(std::move(made));
  std::size_t longest = 0;
  double length = 0;
  for (std::size_t k = 0; k < made.laws.size(); ++k) {
    length += made.laws[k].length;
    if (k > 0 && std::isfinite(made.laws[longest].seconds) && !(made.laws[k].seconds <= made.laws[longest].seconds)) longest = k;
  }
  now_.is_refused = true;
  now_.refused = {length, made.sources.empty() ? tag : made.sources[longest].tag};
}

/// Returns the time, s, that the first `count` waiting cells would take if the axes stopped at each corner.
double WindowTimer::standing_of(std::size_t count) const {
  return std::accumulate(now_.cells.standing.begin(), now_.cells.standing.begin() + static_cast<std::ptrdiff_t>(count), 0.0);
}

/// Returns how many cells are final in a solution in which the axes crawl at the end of the path. A cell is final if its speed is not
/// reduced by this crawl.
std::size_t WindowTimer::sure_cells() const {
  const std::vector<CellSpeeds>& speeds = timer_.speeds();
  std::size_t cell = now_.cells.count();
  while (cell > 1 && speeds[cell - 1].start.b >= speeds[cell - 1].end.b) --cell;
  return cell;
}

void WindowTimer::solve(bool last, const StopToken& stop) {
  now_.ends.to_stop = last;
  now_.ends.crawl = crawl_of_slowest * slowest_alone(now_.cells.path);
  bool found = timer_.solve(now_.cells.path, now_.ends, stop);
  // The low speed at the end of the earlier solution is allowed at the new end too if its square is below twice the squared speed that was
  // computed for the new cells.
  constexpr double as_slow = 2, a_little = 1e-6;
  if (const auto& known = now_.ends.guess; !found && !stop.requested() && !known.empty() && known.back() < as_slow * now_.ends.crawl) {
    now_.ends.crawl = std::max(now_.ends.crawl, (1 + a_little) * known.back());
    found = timer_.solve(now_.cells.path, now_.ends, stop);
  }
  if (stop.requested()) return;
  if (!found && stop_where_known(stop)) return last || now_.cells.count() >= least_window ? solve(last, stop) : void();
  if (!found) return cell_by_cell();
  if (last) return deliver(now_.cells.count());
  const std::size_t all = now_.cells.count(), sure = sure_cells();
  if (sure >= all / 3) deliver(sure - sure / 8);
  else if (all > max_window) deliver(all / 3);
}

/// Emits the first `count` cells. The remaining path continues after these cells. `stops` is true if the axes stop after these cells.
void WindowTimer::deliver(std::size_t count, bool stops) {
  const TimedPath& path = now_.cells.path;
  const std::size_t all = path.cells();
  const std::vector<CellSpeeds>& speeds = timer_.speeds();
  TimedCells made;
  made.axes = path.axes;
  made.laws.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const PathSpeed from = speeds[k].start, to = speeds[k].end;
    const double h = path.h[k], q = (to.d - from.d) / h;
    if (k == 0 && now_.ends.from_stop) made.laws.push_back(TimeLaw::from_rest(h, std::sqrt(to.b), false));
    else if (k + 1 == count && (stops || (count == all && now_.ends.to_stop)))
      made.laws.push_back(TimeLaw::from_rest(h, std::sqrt(from.b), true));
    else made.laws.push_back(TimeLaw::of_squares(h, std::sqrt(from.b), from.d / 2, q / 2));
  }
  made.path.assign(path.shapes.begin(), path.shapes.begin() + static_cast<std::ptrdiff_t>(count * path.axes * TimedCells::terms));
  made.sources.assign(now_.cells.sources.begin(), now_.cells.sources.begin() + static_cast<std::ptrdiff_t>(count));
  pass_cells_on(std::move(made), standing_of(count), now_.cells.sources.front().tag);
  if (count == all) return;
  now_.ends.from_stop = stops;
  now_.ends.from = stops ? PathSpeed{} : speeds[count].start;
  now_.ends.guess.clear();
  if (!stops)
    now_.ends.guess.assign(timer_.middles().begin() + static_cast<std::ptrdiff_t>(count),
                           timer_.middles().begin() + static_cast<std::ptrdiff_t>(all));
  now_.cells.forget(count);
}

/// Handles the case that an earlier solution cannot be continued. The axes then stop at the position at which the earlier solution ended at
/// crawling speed, and the remaining path starts from rest at this position.
///   returns  false if the earlier solution has no such position, or the axes cannot stop at this position
bool WindowTimer::stop_where_known(const StopToken& stop) {
  const std::size_t known = now_.ends.guess.size();
  if (now_.ends.from_stop || known < least_cells || known >= now_.cells.count()) return false;
  PathEnds ends = now_.ends;
  ends.to_stop = true;
  if (!timer_.solve(now_.cells.path.first(known), ends, stop)) return false;
  deliver(known, true);
  return true;
}

/// Handles the case that no speed was found. Each cell is timed as a straight line with a stop at its end.
void WindowTimer::cell_by_cell() {
  ++now_.failures;
  const TimedPath& path = now_.cells.path;
  const std::size_t axes = path.axes, row = axes * TimedCells::terms;
  TimedCells made;
  made.axes = axes;
  for (std::size_t k = 0; k < path.cells(); ++k) {
    std::array<double, max_axes> from{}, to{}, direction{};
    TimedCells cell{axes, {}, {}, {path.shape(k, 0), path.shape(k, 0) + row}};
    cell.position(0, 0, from.data());
    cell.position(0, path.h[k], to.data());
    double squares = 0;
    for (std::size_t a = 0; a < axes; ++a) squares += square(to[a] - from[a]);
    const double length = std::sqrt(squares);
    if (!(length > 0)) continue;
    for (std::size_t a = 0; a < axes; ++a) direction[a] = (to[a] - from[a]) / length;
    const std::size_t before = made.laws.size();
    rest_to_rest(length, limits_along(limits_, direction.data(), std::sqrt(path.most[k])), made.laws);
    double s = 0;
    for (std::size_t i = before; i < made.laws.size(); s += made.laws[i++].length) {
      for (std::size_t a = 0; a < axes; ++a) made.path.insert(made.path.end(), {from[a] + s * direction[a], direction[a], 0, 0, 0, 0});
      made.sources.push_back(now_.cells.sources[k]);
    }
  }
  made.unsolved = true;
  pass_cells_on(std::move(made), standing_of(path.cells()), now_.cells.sources.empty() ? 0 : now_.cells.sources.front().tag);
  begin();
}

}  // namespace kadr
