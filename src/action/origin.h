#pragma once
// Origin: the block of a program that caused an action.

#include <cstdint>

namespace kadr {

/// The origin of an action: the innermost block, of the program or a subprogram of the user, that caused it.
struct Origin {
  std::uint32_t line = 0;
  std::uint32_t column = 0;  // column of the block in its line, counted from 1 in characters
  std::uint32_t block = 0;   // block number, after N
  bool has_block = false;
  bool main_block = false;        // true if the block number follows ':' instead of N
  std::uint8_t block_digits = 0;  // number of digits of the block number in the program, including leading zeros
  std::uint8_t depth = 0;         // nesting depth: number of subprogram calls that led to the block
  // Number of the file that contains the line: 0 is the program; Control::file_name() returns the name of any other
  std::uint16_t file = 0;
  std::uint16_t calls = 0;   // id of the chain of calls that led to the block, for Control::calls_of(); 0: no call, or not recorded
  std::uint32_t number = 0;  // number of the block in the order of execution, for Control::state_of()
};

}  // namespace kadr
