// Measures motions per second with collision checks of a machine's eleven solid bodies. The spindle nose moves at a given distance (mm)
// above the jaws of a vise, over a surface in steps of 0.5 mm; with three axes, and with five, of which two swing to and fro.

#include <benchmark/benchmark.h>

#include <cmath>

#include "stock/bodies/moving_bodies.h"

namespace kadr {
namespace {

constexpr int motions = 100'000, row_length = 200;
constexpr double jaws = -330;  // Z of the top of the jaws

BodyShape box(Vec3 least, Vec3 most) { return {BodyShape::Form::box, least, most, {}, 0, 0, 0, {}}; }
BodyShape cylinder(double bottom, double top, double diameter) {
  return {BodyShape::Form::cylinder, {}, {}, {}, bottom, top, diameter, {}};
}

MachineProfile machine(bool five) {
  MachineProfile machine;
  machine.axes["X"].joint = {false, {1, 0, 0}, {}, false, false};
  machine.axes["Y"].joint = {false, {0, 1, 0}, {}, false, false};
  machine.axes["Z"].joint = {false, {0, 0, 1}, {}, false, false};
  machine.axes["A"].joint = {true, {1, 0, 0}, {0, 0, -400}, false, false};
  machine.axes["C"].joint = {true, {0, 0, 1}, {0, 0, -400}, false, false};
  machine.chains.tool = five ? std::vector<std::string>{"X", "Z"} : std::vector<std::string>{"Z"};
  machine.chains.part = five ? std::vector<std::string>{"Y", "A", "C"} : std::vector<std::string>{"Y", "X"};
  return machine;
}

MovingBodies bodies_of_mill(bool five) {
  MovingBodies bodies(MachineLinks(MachineTree(machine(five), {"X", "Y", "Z", "A", "C"})), BodyWorld(*bodies_library()));
  std::size_t count = 0;
  const auto add = [&](const BodyShape& shape, const char* axis, BodyKind kind = BodyKind::machine) {
    bodies.add(*bodies.world().add(shape), bodies.links().moved_by(axis), kind, count++);
  };
  const char* const table = five ? "C" : "X";
  add(cylinder(0, 200, 140), "Z");
  add(box({-150, -150, 200}, {150, 150, 600}), "Z");
  add(box({-300, 600, -900}, {300, 900, 900}), "bed");
  add(box({-800, -800, -1000}, {800, 550, -800}), "bed");
  add(cylinder(-420, -400, 320), table);
  add(box({-250, -200, -560}, {250, 200, -425}), five ? "A" : "Y");
  add(box({-60, -60, -400}, {60, 60, -340}), table, BodyKind::work);
  add(box({-100, -40, -400}, {-62, 40, jaws}), table, BodyKind::work);
  add(box({62, -40, -400}, {100, 40, jaws}), table, BodyKind::work);
  add(cylinder(-65, -40, 10), "Z", BodyKind::tool);
  add(cylinder(-40, 0, 40), "Z", BodyKind::tool);
  return bodies;
}

/// Returns the i-th position: along rows, up and down by 1 mm; with five axes A swings by 5 degrees, C by 20.
Axes place(int i, double clear, bool five) {
  const int row = i / row_length, column = i % row_length;
  Axes axes{};
  axes[0] = row % 2 != 0 ? 50 - 0.5 * column : -50 + 0.5 * column;
  axes[1] = -50 + 100. * row * row_length / motions;
  axes[2] = jaws + clear + 1 + std::sin(axes[0] * 0.1);
  if (five) axes[3] = 5 * std::sin(i * 1e-3), axes[4] = 20 * std::sin(i * 3e-3);
  return axes;
}

void bodies_over_a_surface(benchmark::State& state) {
  const bool five = state.range(0) == 5;
  const double clear = double(state.range(1));
  MovingBodies bodies = bodies_of_mill(five);
  std::vector<BodyMeeting> found;
  for (auto _ : state) {
    Axes at = place(0, clear, five);
    for (int i = 1; i < motions; ++i) {
      const Axes to = place(i, clear, five);
      bodies.move(at, to, found);
      at = to;
    }
    found.clear();
  }
  state.SetItemsProcessed(state.iterations() * motions);
}
BENCHMARK(bodies_over_a_surface)->ArgNames({"axes", "clear"})->Args({3, 30})->Args({3, 3})->Args({5, 30})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kadr
