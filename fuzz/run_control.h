#pragma once
// A whole run of a control's programs as a fuzz target, where nothing differs but the control: run_program.h without its headers.

#include <cstddef>
#include <cstdint>

namespace kadr::fuzz {

/// Carries the program out as run_program() does. `control`: its id, the same in every call.
///   returns  0: what LLVMFuzzerTestOneInput() returns
int run_control(const char* control, const std::uint8_t* data, std::size_t size);

}  // namespace kadr::fuzz
