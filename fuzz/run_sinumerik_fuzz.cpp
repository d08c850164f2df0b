// Fuzz target: complete runs of Sinumerik programs (run_control.h).

#include "run_control.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return kadr::fuzz::run_control("sinumerik", data, size);
}
