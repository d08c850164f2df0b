// Measures what an interactive session costs: a step of one block, a snapshot, a jump to one of a million lines.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>

#include "config/control/control_file.h"
#include "session/checkpoints.h"

namespace kadr {
namespace {

std::string surface(int lines) {
  std::string text = "G21 G90 G17\nG1 X0 Y0 Z0 F3000\n";
  char line[64];
  for (int i = 0; i < lines; ++i) {
    const double x = (i % 1000) * 0.1;
    std::snprintf(line, sizeof line, "X%.3fZ%.3f\n", x, 3 * std::sin(x * 0.11) - 8);
    text += line;
  }
  return text;
}

std::unique_ptr<Session> session_of(const char* control, const std::string& text) {
  static const MachineProfile machine = load_machine("generic").value();
  auto def = std::make_shared<const ControlDef>(*load_control(control));
  return std::move(*Session::open({std::move(def), machine, {}, {"surface.nc", text_source(text), Encoding::utf8}}));
}

const char* const controls[] = {"mach3", "nct", "s2c42"};

void step_a_block(benchmark::State& state) {
  auto session = session_of(controls[state.range(0)], surface(2'000'000));
  Stepping stepping(*session);
  for (auto _ : state) benchmark::DoNotOptimize(stepping.go(Stepping::How::block));
  state.SetLabel(controls[state.range(0)]);
}
BENCHMARK(step_a_block)->DenseRange(0, 1);

/// Takes a snapshot. With `planned`, the planner of least time is in the middle of its window.
void take_snapshot(benchmark::State& state) {
  auto session = session_of(controls[state.range(0)], surface(20'000));
  if (state.range(1) != 0) session->plan(0);
  for (int i = 0; i < 100; ++i) (void)session->go_on();
  for (auto _ : state) benchmark::DoNotOptimize(session->snapshot());
  state.SetLabel(std::string(controls[state.range(0)]) + (state.range(1) != 0 ? ", planned" : ""));
}
BENCHMARK(take_snapshot)->ArgsProduct({{0, 1}, {0, 1}});

void restore_snapshot(benchmark::State& state) {
  auto session = session_of(controls[state.range(0)], surface(20'000));
  for (int i = 0; i < 100; ++i) (void)session->go_on();
  const auto now = session->snapshot();
  for (auto _ : state) benchmark::DoNotOptimize(session->restore(*now));
  state.SetLabel(controls[state.range(0)]);
}
BENCHMARK(restore_snapshot)->DenseRange(0, 1);

/// Jumps to random lines of a program of a million lines, after a first pass through it.
void reach_a_line(benchmark::State& state) {
  constexpr int lines = 1'000'000;
  auto session = session_of(controls[state.range(0)], surface(lines));
  Checkpoints checkpoints(*session);
  (void)checkpoints.run();
  Stepping stepping(*session);
  std::mt19937 choose(5);
  for (auto _ : state) {
    StopPoint target;
    target.line = std::uniform_int_distribution<std::uint32_t>(3, lines)(choose);
    benchmark::DoNotOptimize(checkpoints.reach(stepping, target));
  }
  state.SetLabel(std::string(controls[state.range(0)]) + ", " + std::to_string(checkpoints.count()) + " checkpoints");
}
BENCHMARK(reach_a_line)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

void first_pass(benchmark::State& state) {
  constexpr int lines = 1'000'000;
  const std::string text = surface(lines);
  for (auto _ : state) {
    auto session = session_of("mach3", text);
    if (state.range(0) == 0) {
      (void)session->run();
    } else {
      Checkpoints checkpoints(*session);
      (void)checkpoints.run();
    }
  }
  state.SetLabel(state.range(0) == 0 ? "without checkpoints" : "with checkpoints");
}
BENCHMARK(first_pass)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kadr
