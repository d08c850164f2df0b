// Fuzz target for a whole run of LinuxCNC programs (run_program.h).

#include "run_program.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const kadr::fuzz::Shop shop = [] {
    kadr::fuzz::Shop s = kadr::fuzz::Shop::open("linuxcnc");
    s.plain_frames = false;  // work systems are turned (G10 L2 R)
    return s;
  }();
  return kadr::fuzz::run_program(shop, data, size);
}
