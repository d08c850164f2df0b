// Measures the time of one call of the servo clock: Playback::fill for one instant, with a change of the override every 0.1 s.
//
//     build/bench/bench/servo_time [SEGMENTS=20000] [RATE=1000]
//
// A freeform path of short segments (limits of machines/linuxcnc-sim) is planned as fast as the clock needs it, then played. Prints the
// percentiles of the time of a call in µs, and for comparison those of a loop whose work is always the same (its variation comes from the
// computer). Then the path is played several times, and the least time of each call is used: the time of the call alone, without other
// work of the computer. Finally prints the seconds of motion that are planned and played per second of processor time.

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "motion/play/playback.h"

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void print_times(const char* what, std::vector<double>& times) {
  std::sort(times.begin(), times.end());
  const auto percentile = [&](double share) { return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))]; };
  fmt::print("{}, µs: median {:.2f}, 99 % {:.2f}, 99.99 % {:.2f}, greatest {:.1f}\n", what, percentile(0.5), percentile(0.99),
             percentile(0.9999), times.back());
}

/// Changes the override every 0.1 s, between 0 and 100 %, always in the same sequence.
void change_override(kadr::Playback& playback, std::size_t call, double rate) {
  const auto change_every = static_cast<std::size_t>(0.1 * rate);
  if (call % change_every == 0) playback.override_to(0.1 * static_cast<double>(call / change_every * 7 % 11));
}

/// Plays planned cells several times, adding cells when there is space. Returns the least time of each call, µs.
std::vector<double> least_times(const kadr::MotionLimits& limits, double rate, const std::vector<kadr::TimedCells>& planned) {
  constexpr int rounds = 15;
  std::vector<double> least;
  std::array<double, 3> row{};
  for (int round = 0; round < rounds; ++round) {
    kadr::Playback playback(limits, rate);
    std::size_t batch = 0, offered = 0;
    const auto offer = [&] {
      while (batch < planned.size()) {
        offered += playback.offer(planned[batch], offered);
        if (offered < planned[batch].laws.size()) return;
        ++batch, offered = 0;
      }
      playback.finish();
    };
    offer();
    for (std::size_t call = 0; !playback.done(); ++call) {
      offer();
      change_override(playback, call, rate);
      const auto start = Clock::now();
      playback.fill(row.data(), 1);
      const double time = since(start) * 1e6;
      if (call == least.size()) least.push_back(time);
      else least[call] = std::min(least[call], time);
    }
  }
  return least;
}

/// Returns the times of `count` repetitions of the same 1200 additions, some µs each.
std::vector<double> of_the_machine(std::size_t count) {
  std::vector<double> times(count);
  volatile double x = 0;
  for (double& time : times) {
    const auto start = Clock::now();
    for (int i = 0; i < 1200; ++i) x = x * 0.5 + 1;
    time = since(start) * 1e6;
  }
  return times;
}

}  // namespace

int main(int argc, char** argv) {
  const int segments = argc > 1 ? std::atoi(argv[1]) : 20000;
  const double rate = argc > 2 ? std::atof(argv[2]) : 1000;
  const kadr::MotionLimits limits{{200, 200, 200}, {1000, 1000, 1000}, {20000, 20000, 20000}};
  kadr::Playback playback(limits, rate);
  std::vector<double> times;
  std::array<double, 3> row{};
  double planning = 0, planned = 0;
  const auto play = [&](bool all) {
    while (!playback.done() && (all || playback.ahead() > 3 * kadr::Playback::reserve)) {
      change_override(playback, times.size(), rate);
      const auto start = Clock::now();
      if (playback.fill(row.data(), 1) == 0) break;
      times.push_back(since(start) * 1e6);
    }
  };
  double outside = 0;
  std::vector<kadr::TimedCells> all;
  kadr::Planner planner(limits, [&](const kadr::TimedCells& cells) {
    const auto start = Clock::now();
    planned += cells.seconds();
    all.push_back(cells);
    for (std::size_t offered = 0; offered < cells.laws.size(); play(false)) offered += playback.offer(cells, offered);
    outside += since(start);
  });
  planner.begin(row.data());
  const auto start = Clock::now();
  for (int i = 1; i <= segments; ++i) {
    const double x = 0.3 * i;
    const std::array<double, 3> to{x, 0.5 * std::sin(x / 7), std::sin(x / 5) + 0.3 * std::sin(x / 1.7)};
    planner.line_to(to.data(), 80, 0.01, false, static_cast<std::uint64_t>(i));
  }
  planner.stop();
  planning = since(start) - outside;
  playback.finish();
  playback.override_to(1);
  const auto played_at = Clock::now();
  play(true);
  outside += since(played_at);
  fmt::print("{} segments, {:.1f} s of motion, {} calls at {} Hz\n", segments, planned, times.size(), rate);
  print_times("time of a call", times);
  std::vector<double> machine = of_the_machine(times.size());
  print_times("the same work each time", machine);
  std::vector<double> least = least_times(limits, rate, all);
  print_times("the call itself, least of 15", least);
  fmt::print("planning {:.0f} segments/s, {:.0f} times real time; planned and played {:.0f} segments/s, {:.0f} times real time\n",
             segments / planning, planned / planning, segments / (planning + outside), planned / (planning + outside));
}
