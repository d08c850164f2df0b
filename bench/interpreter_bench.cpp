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

}  // namespace
}  // namespace kadr

BENCHMARK_MAIN();
