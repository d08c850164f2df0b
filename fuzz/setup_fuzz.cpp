// Fuzz target for config/setup: any text may be a set-up file. What is accepted also begins a run.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "config/control_file.h"
#include "config/machine_profile.h"
#include "config/range.h"
#include "control/control.h"
#include "machine/virtual_machine.h"
#include "motion/time/estimate.h"
#include "require.h"

namespace {

constexpr const char* program = "N1 G90 G0 X1 Y2 Z3\nN2 G31 Z-5 F100\nN3 G1 X5\nN4 M30\n";
constexpr int most_batches = 20;

void try_out(const kadr::Setup& setup) {
  static const kadr::ControlDef def = std::move(*kadr::load_control("mach3"));
  static const kadr::MachineProfile profile = std::move(*kadr::load_machine("generic"));
  kadr::Control control(def, setup, {"fuzz.nc", kadr::text_source(program), std::nullopt}, {});
  const kadr::Ending start = control.ending();
  kadr::VirtualMachine machine(control.axes(), control.rotary(), profile, setup, {start.position, start.machine_position});
  (void)kadr::rates_of(profile, setup, control.axes());
  kadr::ActionBatch batch;
  for (int i = 0; i < most_batches; ++i) {
    const auto state = control.run(batch);
    for (kadr::Action& action : batch) {
      if (auto* const motion = std::get_if<kadr::Motion>(&action.what)) {
        for (const double v : motion->to) kadr::fuzz::require(std::isfinite(v), "a motion ends somewhere");
        if (motion->kind == kadr::MotionKind::probe) control.answer(machine.probe(*motion));
      }
      (void)machine.take(action);
    }
    if (state == kadr::Control::State::ended) return;
    if (control.is_stopped()) control.go_on();
  }
}

/// What is accepted is within the ranges of config/range.h: no motion that never ends.
void hold_ranges(const kadr::Setup& setup) {
  const auto holds = [](const auto& number, const kadr::NumberRange& range) {
    if (number) kadr::fuzz::require(kadr::is_within(*number, range), "an accepted number is within its range");
  };
  holds(setup.feed, kadr::ranges::feed);
  for (const auto& [axis, limits] : setup.machine) {
    holds(limits.rapid, kadr::ranges::rate);
    holds(limits.acceleration, kadr::ranges::acceleration);
    holds(limits.jerk_time, kadr::ranges::seconds);
    if (limits.limits) kadr::fuzz::require(limits.limits->first < limits.limits->second, "an axis has a way to go");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto setup = kadr::parse_setup({reinterpret_cast<const char*>(data), size});
  if (setup) hold_ranges(*setup), try_out(*setup);
  else kadr::fuzz::require(!setup.error().empty(), "a refusal says why");
  return 0;
}
