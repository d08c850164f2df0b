#pragma once
// Origin: the block of a program that an action comes from.

#include <cstdint>

namespace kadr {

/// Where an action comes from: the innermost block of the user's program.
struct Origin {
  std::uint32_t line = 0;
  std::uint32_t column = 0;  // counted from 1, in characters
  std::uint32_t block = 0;   // N…
  bool has_block = false;
  bool main_block = false;        // ':' instead of N
  std::uint8_t block_digits = 0;  // as written, zeros included
  std::uint8_t depth = 0;         // calls around it
  std::uint16_t file = 0;         // that the line stands in: 0 the program, others: Control::file_name()
  std::uint16_t calls = 0;        // by which it came to be carried out: Control::calls_of(); 0: none, or nobody watches
  std::uint32_t number = 0;       // of the block in the run, in the order of execution: Control::state_of()
};

}  // namespace kadr
