#pragma once
// Plan: the functions that a block calls, as rows of the control's table in the order of execution. Planning reads no state except the
// modal motion code, and changes no state. So blocks that are never executed can be checked in the same way.

#include <array>
#include <cstdint>

#include "base/result.h"
#include "config/control/control_def.h"
#include "control/state/control_state.h"
#include "lang/block/block.h"

namespace kadr {

/// A function that the block calls.
struct PlanItem {
  std::uint8_t rank = 0;  // position of the function in the order of execution
  std::uint8_t word = 0;  // index in Block::words of the word that calls the function; no_word: the motion code in force calls it
  std::int16_t row = -1;  // index of the code in ControlDef::codes; -1: the function belongs to `address`
  char address = 0;       // address that calls a function without a code: F, S, T, …
};
inline constexpr std::uint8_t no_word = 255;
inline constexpr std::int16_t any_motion = -2;  // value of `motion_row` for a block that is only checked: any motion code may be in force

struct Plan {
  std::array<PlanItem, limits::block_words + 2> items;
  std::uint32_t count = 0;
  std::uint64_t taken = 0;        // letters of words that some function of the block uses
  std::uint64_t passed_over = 0;  // letters of words that no function uses; set only on a control that ignores unused words
  bool axes_taken = false;        // a code that is not a modal motion code (G28, G92, …) uses the axis words
  bool moves_only = false;        // true: the block has axis words only: no code, no F, S, T …, no assignment
  bool moves_and_feeds = false;   // true: the block calls only the functions of G0 to G3 and F
  bool calls_only = false;        // true: the block only calls subprograms, or only returns from a subprogram
};

/// Sets of letters by their meaning, one bit per letter. The sets are computed once from the control's table.
struct LetterSets {
  std::uint64_t axes = 0;
  std::uint64_t centers = 0;
  std::uint64_t acting = 0;  // addresses that call a function without a code: F, S, T, …
  std::uint64_t codes = 0;
  std::uint64_t spindles = 0;                        // letters of words that select a spindle (nct)
  std::array<std::int8_t, max_addresses> axis_of{};  // by letter: axis index of an axis letter or centre letter; -1 for other letters
  std::array<char, max_axes> center_letter{};        // by axis: the letter of its arc centre coordinate, such as I for X
  std::array<char, max_axes> axis_letter{};
  explicit LetterSets(const ControlDef& def);
};

/// Plans a block: turns its words into function calls.
///   alarms  code_unknown, group_conflict, not_together, own_block, word_unused, word_missing, no_axis_word, no_motion_mode
Status plan_block(const ControlDef& def, const LetterSets& letters, const Block& block, std::int16_t motion_row, Plan& plan);

}  // namespace kadr
