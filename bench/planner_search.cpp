// Measures the speed of the planner of least time alone, and checks that its plans keep the path tolerance and the axis limits. The
// distance from the path is checked at every micrometre, by a search for the nearest point that does not use the planner's rounding of
// corners; the limits are checked at the instants of two clocks.
//
//     build/bench/bench/planner_search PROGRAM... [--tolerance 0.01] [--times 5] [--fast]
//
// The programs are for the control mach3, with lines and arcs; the limits are 200 mm/s, 1000 mm/s², 20,000 mm/s³ for each axis. The
// planner gets arcs as chords within 0.0004 mm; the search uses chords within 0.00001 mm. Prints for each program: number of straight
// segments; µs of processor time per segment on one thread; µs of elapsed time per segment with smoothing in parallel; cycle time;
// greatest distance from the path in mm, and as a share of the tolerance of the motions there; greatest share of a limit at 1 kHz and 20
// kHz. --fast: no search.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "config/control/control_file.h"
#include "motion/least_time/planner.h"
#include "motion/time/estimate.h"
#include "path/curve/machine_path.h"
#include "session/session.h"

namespace {

using kadr::TimedCells;
using Point = std::array<double, 3>;

struct Piece {
  Point to;
  double feed, tolerance;  // mm/s; mm, tolerance of the corner at its start, 0: stop there
  bool on_curve;
};

/// The straight segments that are searched, each with the path tolerance in its neighbourhood.
struct Ideal {
  std::vector<Point> points;
  std::vector<double> tolerance;  // tolerance of the segment that ends at each point, mm
};

struct Program {
  Point start{};
  std::vector<Piece> pieces;
  Ideal ideal;
};

Point point_of(const kadr::Axes& axes) { return {axes[0], axes[1], axes[2]}; }

/// Converts motions to straight segments as they arrive.
class Reader {
 public:
  explicit Reader(double tolerance) : tolerance_(tolerance) {}
  void take(const kadr::Step& step) {
    const kadr::Motion* const motion = step.motion();
    if (motion == nullptr) {
      if (step.pause > 0) stands_ = true;
      return;
    }
    constexpr double searched = 1e-5, planned = 0.04;  // chord error: mm in the search; share of the tolerance in the plan
    const kadr::MachinePath path(step);
    if (program_.ideal.points.empty()) program_.ideal = {{program_.start = point_of(path.start())}, {0}};
    const double tolerance = motion->tolerance > 0 ? motion->tolerance : tolerance_;
    const int chords = path.pieces(planned * tolerance), dense = path.pieces(searched);
    double length = 0;
    Point last = point_of(path.start());
    std::vector<Piece> pieces;
    for (int i = 1; i <= chords; ++i) {
      const Point to = point_of(path.at(static_cast<double>(i) / chords));
      length += std::hypot(to[0] - last[0], to[1] - last[1], to[2] - last[2]);
      pieces.push_back({last = to, 0, i == 1 && stands_ ? 0 : tolerance, i > 1});
    }
    if (!(length > 0)) return;
    for (Piece& piece : pieces) {
      piece.feed = length / step.time.seconds;
      program_.pieces.push_back(piece);
    }
    for (int i = 1; i <= dense; ++i) {
      program_.ideal.points.push_back(point_of(path.at(static_cast<double>(i) / dense)));
      program_.ideal.tolerance.push_back(tolerance);
    }
    stands_ = motion->exact;
  }
  const Program& program() const { return program_; }

 private:
  double tolerance_;
  bool stands_ = true;
  Program program_;
};

Program read(const std::string& file, const kadr::MotionLimits& limits, double tolerance) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error(file + ": cannot be read");
  const auto def = std::make_shared<const kadr::ControlDef>(*kadr::load_control("mach3"));
  kadr::MachineProfile profile;
  for (std::size_t a = 0; a < 3; ++a) profile.axes[std::string(1, "XYZ"[a])].rapid = limits.speed[a] * 60;
  profile.tool_change_s = 0;
  const auto session = std::move(*kadr::Session::open({def, profile, {}, {file, kadr::text_source(text.str()), kadr::Encoding::utf8}}));
  Reader reader(tolerance);
  const kadr::Control& control = session->control();
  const std::vector<std::string> axes = control.axes();
  kadr::TimeEstimate clock(kadr::AxisRoles::of(axes, control.rotary()), kadr::rates_of(profile, {}, axes));
  session->outlets().clock = &clock;
  session->outlets().step = [&](const kadr::Step& step) { reader.take(step); };
  session->change_outlets();
  if (session->run() != kadr::Session::State::ended) throw std::runtime_error(file + ": it stops");
  return reader.program();
}

/// Plans the program and passes the cells to `sink`.
template <class Sink>
void plan(const Program& program, const kadr::MotionLimits& limits, bool in_background, const Sink& sink) {
  kadr::Planner planner(limits, sink);
  if (in_background) planner.work_in_background();
  planner.begin(program.start.data());
  for (const Piece& piece : program.pieces) {
    if (piece.tolerance == 0) planner.stop();
    planner.line_to(piece.to.data(), piece.feed, piece.tolerance, piece.on_curve, 0);
  }
  planner.stop();
  if (planner.failures() > 0) fmt::print("  {} stretches for which no speed was found\n", planner.failures());
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double wall_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Returns the median time of `times` plans, s.
template <class Clock>
double median_seconds(const Program& program, const kadr::MotionLimits& limits, bool in_background, int times, const Clock& clock) {
  std::vector<double> all;
  for (int i = 0; i < times; ++i) {
    const double start = clock();
    plan(program, limits, in_background, [](const TimedCells&) {});
    all.push_back(clock() - start);
  }
  std::sort(all.begin(), all.end());
  return all[all.size() / 2];
}

/// Finds the nearest segment, within some millimetres of path around the one found last.
class Search {
 public:
  explicit Search(const Ideal& ideal) : ideal_(ideal), at_(ideal.points.size(), 0) {
    for (std::size_t i = 1; i < at_.size(); ++i) at_[i] = at_[i - 1] + distance(i);
  }
  struct Found {
    double mm, tolerance;
  };
  Found operator()(const Point& p) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t nearest = last_;
    const auto look = [&](std::size_t i) {
      const Point &a = ideal_.points[i - 1], &b = ideal_.points[i];
      double along = 0, squares = 0, off = 0;
      for (std::size_t k = 0; k < 3; ++k) squares += (b[k] - a[k]) * (b[k] - a[k]), along += (b[k] - a[k]) * (p[k] - a[k]);
      const double part = squares > 0 ? std::clamp(along / squares, 0.0, 1.0) : 0;
      for (std::size_t k = 0; k < 3; ++k) off += std::pow(p[k] - a[k] - part * (b[k] - a[k]), 2);
      if (off < least) least = off, nearest = i;
    };
    for (std::size_t i = last_; i > 0 && at_[last_] - at_[i] < around; --i) look(i);
    for (std::size_t i = last_ + 1; i < at_.size() && at_[i - 1] - at_[last_] < around; ++i) look(i);
    last_ = nearest;
    const std::size_t before = std::max<std::size_t>(nearest, 2) - 1, after = std::min(nearest + 1, at_.size() - 1);
    return {std::sqrt(least), std::max({ideal_.tolerance[before], ideal_.tolerance[nearest], ideal_.tolerance[after]})};
  }

 private:
  static constexpr double around = 1;  // mm of path searched on either side
  double distance(std::size_t i) const {
    const Point &a = ideal_.points[i - 1], &b = ideal_.points[i];
    return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }
  const Ideal& ideal_;
  std::vector<double> at_;
  std::size_t last_ = 1;
};

/// Computes the shares of the limits that are used, at the instants of a clock that continues from cell to cell.
class Instants {
 public:
  Instants(const kadr::MotionLimits& limits, double rate) : limits_(limits), period_(1 / rate) {}
  void take(const TimedCells& cells) {
    for (std::size_t k = 0; k < cells.laws.size(); ++k) {
      for (; due_ < cells.laws[k].seconds; due_ += period_) look(cells, k);
      due_ -= cells.laws[k].seconds;
    }
  }
  std::string text() const { return fmt::format("speed {:.3f} acceleration {:.3f} jerk {:.3f}", most_[0], most_[1], most_[2]); }

 private:
  void look(const TimedCells& cells, std::size_t k) {
    const kadr::TimeLaw::State state = cells.laws[k].after(due_);
    for (std::size_t a = 0; a < 3; ++a) {
      const auto x = kadr::Derivatives::at(cells.path.data() + (k * 3 + a) * TimedCells::terms, state.distance);
      const double v = state.speed;
      most_[0] = std::max(most_[0], std::fabs(x.x1 * v) / limits_.speed[a]);
      most_[1] = std::max(most_[1], std::fabs(x.x1 * state.acceleration + x.x2 * v * v) / limits_.acceleration[a]);
      most_[2] = std::max(most_[2], std::fabs(x.x1 * state.jerk + 3 * x.x2 * v * state.acceleration + x.x3 * v * v * v) / limits_.jerk[a]);
    }
  }
  const kadr::MotionLimits& limits_;
  double period_, due_ = 0;
  std::array<double, 3> most_{};
};

void search(const Program& program, const kadr::MotionLimits& limits) {
  constexpr double spacing = 0.001;  // distance between checked points, mm
  Search nearest(program.ideal);
  Instants slow(limits, 1000), fast(limits, 20'000);
  double seconds = 0, farthest = 0, share = 0;
  plan(program, limits, false, [&](const TimedCells& cells) {
    seconds += cells.seconds();
    slow.take(cells);
    fast.take(cells);
    for (std::size_t k = 0; k < cells.laws.size(); ++k)
      for (double s = 0; s < cells.laws[k].length; s += spacing) {
        Point p{};
        cells.position(k, s, p.data());
        const auto [mm, tolerance] = nearest(p);
        farthest = std::max(farthest, mm);
        share = std::max(share, mm / tolerance);
      }
  });
  fmt::print("  {:.3f} s; from the path {:.4f} of the tolerance, {:.5f} mm\n  1 kHz:  {}\n  20 kHz: {}\n", seconds, share, farthest,
             slow.text(), fast.text());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("the planner of least time by itself");
  std::vector<std::string> files;
  double tolerance = 0.01;
  int times = 5;
  bool fast = false;
  app.add_option("programs", files)->required();
  app.add_option("--tolerance", tolerance);
  app.add_option("--times", times);
  app.add_flag("--fast", fast);
  CLI11_PARSE(app, argc, argv);
  const kadr::MotionLimits limits{{200, 200, 200}, {1000, 1000, 1000}, {20'000, 20'000, 20'000}};
  try {
    for (const std::string& file : files) {
      const Program program = read(file, limits, tolerance);
      const double pieces = static_cast<double>(program.pieces.size()),
                   one = median_seconds(program, limits, false, times, processor_seconds),
                   two = median_seconds(program, limits, true, times, wall_seconds);
      fmt::print("{}: {} pieces, one thread {:.3f} µs ({:.0f} a second), side by side {:.3f} µs ({:.0f} a second)\n", file,
                 program.pieces.size(), one * 1e6 / pieces, pieces / one, two * 1e6 / pieces, pieces / two);
      if (!fast) search(program, limits);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
