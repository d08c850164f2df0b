// Compares the cycle time of Kadr's planner of least time with that of reference solvers, on the same path and with the same limits. Used
// by bench/optimality.
//
//   kadr_reference PROGRAM [--jerk J] [--parts N] [--starts N] [--seconds S] [--no-jerk]

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

#include "reachability.h"
#include "with_jerk.h"

namespace kadr::reference {
namespace {

struct Asked {
  std::string program;
  Machine machine;
  int parts = 2, starts = 3;
  double seconds = 200;
  bool no_jerk = false;
};

struct Sums {
  double kadr = 0, window = 0, reference = 0;
  std::size_t cells = 0, intervals = 0;
  Shares of_kadr, of_reference;
  int starts = 0, steps = 0;
};

void add(Shares& sum, const Shares& more) {
  sum.speed = std::max(sum.speed, more.speed);
  sum.acceleration = std::max(sum.acceleration, more.acceleration);
  sum.jerk = std::max(sum.jerk, more.jerk);
}

PathMotion slowed(PathMotion motion, double times) {
  for (double& v : motion.v) v /= times;
  for (double& a : motion.a) a /= times * times;
  for (double& t : motion.seconds) t *= times;
  return motion;
}

PathMotion best_with_jerk(const Stretch& stretch, const MotionLimits& limits, const Grid& grid, const Asked& asked, Sums& sums) {
  const PathMotion own = motion_of(stretch, grid);
  std::optional<PathMotion> best;
  for (int i = 0; i < asked.starts; ++i) {
    const PathMotion start = i == 0 ? own : i == 1 ? slowed(own, 2) : slowed(without_jerk(grid, limits), 1.5);
    const auto found = with_jerk(grid, limits, start, asked.seconds);
    fmt::print(stderr, "{} intervals, start {}: {} -> {} in {} steps\n", grid.intervals(), i, start.total(),
               found ? found->motion.total() : 0, found ? found->steps : 0);
    if (!found) continue;
    ++sums.starts;
    sums.steps += found->steps;
    if (!best || found->motion.total() < best->total()) best = found->motion;
  }
  if (!best) throw std::runtime_error("the reference found no motion");
  return *best;
}

void measure(const Stretch& stretch, const MotionLimits& limits, const Asked& asked, Sums& sums) {
  constexpr double longest = 0.0025, longest_without_jerk = 0.0005;  // greatest length of a grid interval, as a share of the stretch
  const Grid grid = grid_of(stretch, limits, asked.parts, asked.no_jerk ? longest_without_jerk : longest);
  const PathMotion motion = asked.no_jerk ? without_jerk(grid, limits) : best_with_jerk(stretch, limits, grid, asked, sums);
  sums.kadr += stretch.cells.seconds();
  sums.window += seconds_as_one_window(stretch, limits);
  sums.reference += motion.total();
  sums.cells += stretch.cells.laws.size();
  sums.intervals += grid.intervals();
  add(sums.of_kadr, shares_planned(stretch, limits));
  add(sums.of_reference, shares_of(stretch, limits, grid, motion));
}

int run(const Asked& asked) {
  Sums sums;
  const Planned all = planned(asked.program, asked.machine);
  for (const Stretch& stretch : all.stretches) measure(stretch, all.limits, asked, sums);
  const auto shares = [](const Shares& s) { return fmt::format(R"([{:.5f},{:.5f},{:.5f}])", s.speed, s.acceleration, s.jerk); };
  fmt::print(R"({{"kadr":{:.5f},"one_window":{:.5f},"reference":{:.5f},"cells":{},"intervals":{},"shares":{},"shares_reference":{},)"
             R"("starts":{},"steps":{}}})"
             "\n",
             sums.kadr, sums.window, sums.reference, sums.cells, sums.intervals, shares(sums.of_kadr), shares(sums.of_reference),
             sums.starts, sums.steps);
  return 0;
}

}  // namespace
}  // namespace kadr::reference

int main(int argc, char** argv) {
  kadr::reference::Asked asked;
  CLI::App app("Kadr's planner beside reference solvers of the same path and limits");
  app.add_option("program", asked.program)->required();
  app.add_option("--jerk", asked.machine.jerk, "mm/s³");
  app.add_option("--acceleration", asked.machine.acceleration, "mm/s²");
  app.add_option("--parts", asked.parts, "intervals in each of the planner's cells");
  app.add_option("--starts", asked.starts, "motions to begin with");
  app.add_option("--seconds", asked.seconds, "that a start may take");
  app.add_flag("--no-jerk", asked.no_jerk, "the reference has no limit of jerk");
  CLI11_PARSE(app, argc, argv);
  try {
    return kadr::reference::run(asked);
  } catch (const std::exception& failed) {
    fmt::print(stderr, "{}\n", failed.what());
    return 1;
  }
}
