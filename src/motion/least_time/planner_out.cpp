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
  for (std::size_t a = 0; a < cells_.axes; ++a) {
    if (way[a] == 0) continue;
    line.speed = std::min(line.speed, limits_.speed[a] / std::fabs(way[a]));
    line.acceleration = std::min(line.acceleration, limits_.acceleration[a] / std::fabs(way[a]));
    line.jerk = std::min(line.jerk, limits_.jerk[a] / std::fabs(way[a]));
  }
  return line;
}

void Planner::straight_line() {
  std::array<double, max_axes> x{}, way{}, x2{};
  path_.evaluate(0, 0, x.data(), way.data(), x2.data());
  out_.clear();
  rest_to_rest(path_.ends(), limits_along(way.data(), path_.feed(0)), out_.laws);
  double s = 0;
  std::size_t piece = 0;
  for (const TimeLaw& law : out_.laws) {
    for (std::size_t a = 0; a < cells_.axes; ++a) out_.path.insert(out_.path.end(), {x[a] + s * way[a], way[a], 0, 0, 0, 0});
    piece = path_.piece_at(s, piece);
    out_.sources.push_back({path_.tag(piece), path_.feed(piece), Bend::none});
    s += law.length;
  }
  hand_on(path_.begins(), path_.ends());
}

double Planner::way_of_cells() const { return std::accumulate(cells_.h.begin(), cells_.h.end(), 0.0); }

/// What a stretch of the path takes with a stop at each corner, s.
double Planner::standing_s(double from, double to) const {
  double seconds = 0;
  for (std::size_t i = path_.piece_at(from, 0); i < path_.pieces() && path_.at(i) < to; ++i) {
    const double way = std::min(to, path_.at(i + 1)) - std::max(from, path_.at(i));
    if (way > 0) seconds += rest_to_rest_s(way, limits_along(path_.direction(i), path_.feed(i)));
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
  ended_ = PlanEnd::too_slow;
  refused_ = {to - from, out_.sources.empty() ? path_.tag(path_.piece_at(from, 0)) : out_.sources[longest].tag};
}

/// The first cells go out; the path begins anew after them.
void Planner::hand_out(std::size_t count) {
  const std::size_t axes = cells_.axes, all = cells_.cells();
  const std::vector<LeastTime::CellSpeeds>& speeds = least_.speeds();
  out_.clear();
  for (std::size_t k = 0; k < count; ++k) {
    const PathSpeed from = speeds[k].start, to = speeds[k].end;
    const double h = cells_.h[k], q = (to.d - from.d) / h;
    if (k == 0 && ends_.from_stop) out_.laws.push_back(TimeLaw::from_rest(h, std::sqrt(to.b), false));
    else if (k + 1 == all && ends_.to_stop) out_.laws.push_back(TimeLaw::from_rest(h, std::sqrt(from.b), true));
    else out_.laws.push_back(TimeLaw::of_squares(h, std::sqrt(from.b), from.d / 2, q / 2));
  }
  out_.path.assign(shapes_.begin(), shapes_.begin() + static_cast<std::ptrdiff_t>(count * axes * TimedCells::terms));
  out_.sources.assign(sources_.begin(), sources_.begin() + static_cast<std::ptrdiff_t>(count));
  const double from = cut_ - way_of_cells();
  hand_on(from, from + std::accumulate(cells_.h.begin(), cells_.h.begin() + static_cast<std::ptrdiff_t>(count), 0.0));
  if (count == all) return;
  ends_.from_stop = false;
  ends_.from = speeds[count].start;
  const auto cut = [](auto& v, std::size_t n) { v.erase(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n)); };
  ends_.guess.assign(least_.middles().begin() + static_cast<std::ptrdiff_t>(count),
                     least_.middles().begin() + static_cast<std::ptrdiff_t>(all));
  cut(sources_, count);
  cut(cells_.h, count);
  cut(cells_.most, count);
  cut(cells_.turns, count);
  for (std::vector<double>* const of_places : {&cells_.x1, &cells_.x2, &cells_.x3}) cut(*of_places, count * TimedPath::places * axes);
  cut(shapes_, count * axes * TimedCells::terms);
  const std::size_t before = path_.pieces();
  path_.forget(cut_ - way_of_cells());
  piece_ -= before - path_.pieces();
}

/// No speed was found: the cells one after the other, as straight lines with a stop after each.
void Planner::cell_by_cell() {
  ++failures_;
  const std::size_t axes = cells_.axes, row = axes * TimedCells::terms;
  out_.clear();
  for (std::size_t k = 0; k < cells_.cells(); ++k) {
    std::array<double, max_axes> from{}, to{}, way{};
    TimedCells cell{axes,
                    {},
                    {},
                    {shapes_.begin() + static_cast<std::ptrdiff_t>(k * row), shapes_.begin() + static_cast<std::ptrdiff_t>((k + 1) * row)}};
    cell.position(0, 0, from.data());
    cell.position(0, cells_.h[k], to.data());
    double squares = 0;
    for (std::size_t a = 0; a < axes; ++a) squares += square(to[a] - from[a]);
    const double length = std::sqrt(squares);
    if (!(length > 0)) continue;
    for (std::size_t a = 0; a < axes; ++a) way[a] = (to[a] - from[a]) / length;
    const std::size_t before = out_.laws.size();
    rest_to_rest(length, limits_along(way.data(), std::sqrt(cells_.most[k])), out_.laws);
    double s = 0;
    for (std::size_t i = before; i < out_.laws.size(); s += out_.laws[i++].length) {
      for (std::size_t a = 0; a < axes; ++a) out_.path.insert(out_.path.end(), {from[a] + s * way[a], way[a], 0, 0, 0, 0});
      out_.sources.push_back(sources_[k]);
    }
  }
  out_.unsolved = true;
  hand_on(cut_ - way_of_cells(), cut_);
  cells_.clear();
  shapes_.clear();
  sources_.clear();
  ends_ = {};
}

}  // namespace kadr
