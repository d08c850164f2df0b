// Fuzz target: complete runs of LinuxCNC programs (run_program.h).

#include "run_program.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kadr;
  using namespace kadr::fuzz;
  static const Shop shop = [] {
    Shop s = Shop::open("linuxcnc");
    s.plain_frames = false;  // work systems may be rotated (G10 L2 R)
    s.setup = [](unsigned switches) {
      Setup setup = some_setup(switches);
      if ((switches & machine_logic) != 0) setup.axes = {"X", "Y", "Z", "A", "B", "C", "U", "V", "W"};
      return setup;
    };
    return s;
  }();
  return run_program(shop, data, size);
}
