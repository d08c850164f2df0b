#pragma once
// A complete run of a program as a fuzz target, for controls whose targets differ only in the control. Like run_program.h, without its
// includes.

#include <cstddef>
#include <cstdint>

namespace kadr::fuzz {

/// Executes the program as run_program() does. `control` is the id of the control, the same in every call.
///   returns  0, the return value of LLVMFuzzerTestOneInput()
int run_control(const char* control, const std::uint8_t* data, std::size_t size);

}  // namespace kadr::fuzz
