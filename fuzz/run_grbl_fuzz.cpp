// Fuzz target: complete runs of Grbl programs (run_control.h).

#include "run_control.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { return kadr::fuzz::run_control("grbl", data, size); }
