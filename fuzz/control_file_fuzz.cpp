// Fuzz target for config/control/control_file. The input is the text of a control's file. If the loader accepts it, a program is run with
// it and its documentation page is written.

#include <cstddef>
#include <cstdint>

#include "config/control/control_file.h"
#include "config/range.h"
#include "out/text/explain/code_page.h"
#include "run_program.h"

namespace {

const char* const program = "%\nN1 G90 G0 X1 Y2 Z3 F100 S100 M3\nN2 G1 X5 T1 D1 H1 L1\nN3 G2 X1 I1 J1 R1\nN4 M2\n";

/// Checks that all accepted values are within the ranges of config/range.h.
void hold_ranges(const kadr::ControlDef& def) {
  for (const kadr::AddressRow& row : def.addresses) {
    kadr::fuzz::require(kadr::is_within(row.scale, kadr::ranges::scale), "a scale is a number that can be divided by");
    kadr::fuzz::require(row.least <= row.most, "an address has values");
  }
  const kadr::Behaviour& b = def.behaviour;
  for (const double number : {b.arc_radius_difference, b.feed_most, b.reference_feed, b.return_near, b.probe_least_distance})
    kadr::fuzz::require(number >= 0 && number < 1e10, "an accepted number is within its range");
}

void try_out(const kadr::ControlDef& def) {
  hold_ranges(def);
  static const kadr::AlarmTexts texts = kadr::AlarmTexts::load(nullptr).value();
  (void)kadr::control_page(def, texts);
  static kadr::fuzz::Shop shop = kadr::fuzz::Shop::open("gost");
  shop.def = def;
  shop.plain_frames = false;
  shop.file = "/nonexistent/fuzz.nc";  // in a folder that does not exist, so that the program can call no file of this computer
  shop.limits = {200, 2};
  kadr::fuzz::run_text(shop, program, 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto def = kadr::parse_control({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
  if (def) try_out(*def);
  else kadr::fuzz::require(!def.error().empty(), "a refusal says why");
  return 0;
}
