// Fuzz target: complete runs of Heidenhain programs (run_control.h).

#include "run_control.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return kadr::fuzz::run_control("heidenhain", data, size);
}
