// Fuzz target: complete runs of lathe programs (run_program.h), on a lathe with C and Y axis whose turret has four tools with nose radius,
// tip number and wear. The control is Fanuc's; with the bit 128 of the first byte it is that of a Haas lathe.

#include "run_program.h"

namespace {

kadr::ToolOffset insert(double x, double z, double radius, double tip) {
  kadr::ToolOffset offset;
  offset.length_x = x;
  offset.length = z;
  offset.radius = radius;
  offset.tip_position = tip;
  offset.length_x_wear = 0.05;
  offset.length_wear = -0.02;
  return offset;
}

kadr::Setup lathe(unsigned switches) {
  kadr::Setup s = kadr::fuzz::some_setup(switches);
  s.axes = {"X", "Z", "C", "Y"};
  s.start = {{"X", 60}, {"Z", 50}};
  s.offsets = {{1, insert(-20, -50, 0.8, 3)}, {2, insert(-25, -40, 0.4, 2)}, {3, insert(0, 0, 0, 8)}, {4, insert(5, 10, 1.2, 0)}};
  s.work_offsets = {{"G54", {{"Z", -150}}}, {"G55", {{"X", 3}}}};
  s.reference_points = {{1, {{"X", 150}, {"Z", 200}}}, {2, {{"Z", 100}}}};
  s.mirror.clear();
  s.probe_hole.reset();
  return s;
}

kadr::fuzz::Shop shop_of(const char* control) {
  kadr::fuzz::Shop s = kadr::fuzz::Shop::open(control);
  s.setup = lathe;
  return s;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint8_t is_haas = 128;
  static const kadr::fuzz::Shop fanuc = shop_of("fanuc-t"), haas = shop_of("haas-st");
  return kadr::fuzz::run_program(size > 0 && (data[0] & is_haas) != 0 ? haas : fanuc, data, size);
}
