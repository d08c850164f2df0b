// Measures the blocks per second of single stages: reading lines, lexing, interpreting.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "config/control/control_file.h"
#include "control/control.h"

namespace kadr {
namespace {

constexpr int lines = 100'000;

/// Returns a program that moves in a zigzag over a surface, like the load program surf_1m.
std::string surface() {
  std::string text = "G21 G90 G17\nG1 X0 Y0 Z0 F3000\n";
  char line[64];
  for (int i = 0; i < lines; ++i) {
    const double x = (i % 1000) * 0.1;
    std::snprintf(line, sizeof line, "X%.3fZ%.3f\n", x, 3 * std::sin(x * 0.11) - 8);
    text += line;
  }
  return text;
}

const ControlDef& mach3() {
  static const ControlDef def = *load_control("mach3");
  return def;
}

void read_lines(benchmark::State& state) {
  const std::string text = surface();
  for (auto _ : state) {
    LineReader reader(text_source(text));
    Line line;
    while (reader.next(line)) benchmark::DoNotOptimize(line.bytes.data());
  }
  state.SetItemsProcessed(state.iterations() * lines);
}
BENCHMARK(read_lines);

void read_blocks(benchmark::State& state) {
  const std::string text = surface();
  auto block = std::make_unique<Block>();
  for (auto _ : state) {
    BlockReader reader(text_source(text), mach3().grammar, Encoding::utf8);
    for (;;) {
      const auto got = reader.next(*block);
      if (!got || *got == BlockReader::Got::end) break;
      benchmark::DoNotOptimize(block->word_count);
    }
  }
  state.SetItemsProcessed(state.iterations() * lines);
}
BENCHMARK(read_blocks);

void interpret(benchmark::State& state) {
  const std::string text = surface();
  for (auto _ : state) {
    Control control(mach3(), Setup{}, Program{"surface", text_source(text), Encoding::utf8}, RunLimits{});
    ActionBatch batch;
    while (control.run(batch) == Control::State::running) benchmark::DoNotOptimize(batch.size());
  }
  state.SetItemsProcessed(state.iterations() * lines);
}
BENCHMARK(interpret);

constexpr int figure_blocks = 500;

/// Returns a lathe's program that roughs a staircase of 500 blocks by G71 (spec/fanuc-t 9.2).
std::string staircase() {
  std::string text = "G0 X320. Z2.\nG71 U2. R0.5\nG71 P10 Q20 U0.4 W0.1 F0.2\nN10 G0 X10.\nG1 Z0\n";
  char line[64];
  for (int i = 1; i < figure_blocks - 2; ++i) {
    if (i % 2 == 0) std::snprintf(line, sizeof line, "X%.3f Z%.3f\n", 10 + 0.6 * i, -0.2 * i);
    else std::snprintf(line, sizeof line, "Z%.3f\n", -0.2 * i);
    text += line;
  }
  return text + "N20 X318.\nM30\n";
}

/// Measures one whole program with G71: opening, reading the figure, all passes.
void rough_turning(benchmark::State& state) {
  static const ControlDef def = *load_control("fanuc-t");
  const std::string text = staircase();
  for (auto _ : state) {
    Control control(def, Setup{}, Program{"staircase", text_source(text), Encoding::utf8}, RunLimits{});
    ActionBatch batch;
    Control::State now = Control::State::running;
    while ((now = control.run(batch)) == Control::State::running) benchmark::DoNotOptimize(batch.size());
    if (now != Control::State::ended) state.SkipWithError("the program did not end");
  }
}
BENCHMARK(rough_turning);

}  // namespace
}  // namespace kadr

BENCHMARK_MAIN();
