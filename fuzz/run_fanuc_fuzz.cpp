// Fuzz target for a whole run of Fanuc programs (run_program.h).

#include "run_program.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const kadr::fuzz::Shop shop = kadr::fuzz::Shop::open("fanuc");
  return kadr::fuzz::run_program(shop, data, size);
}
