// Fuzz target for config/setup/setup. The input is the text of a set-up file. If it is accepted, a run is started with it.

#include <cstddef>
#include <cstdint>

#include "config/range.h"
#include "run_program.h"

namespace {

const char* const program = "N1 G90 G0 X1 Y2 Z3\nN2 G31 Z-5 F100\nN3 G1 X5\nN4 M30\n";

void try_out(const kadr::Setup& setup) {
  static kadr::fuzz::Shop shop = kadr::fuzz::Shop::open("mach3");
  shop.setup = [&setup](unsigned) { return setup; };
  shop.plain_frames = false;
  kadr::fuzz::run_text(shop, program, 0);
}

/// Checks that accepted values are within the ranges of config/range.h, so that no motion takes endless time.
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
