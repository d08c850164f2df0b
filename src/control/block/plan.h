#pragma once
// Plan: the functions that a block calls, as rows of the control's table in the order of execution.
// Planning reads no state except the modal motion code, and changes none, so the same check serves blocks that are never executed.

#include <array>
#include <cstdint>

#include "base/result.h"
#include "config/control/control_def.h"
#include "control/state/control_state.h"
#include "lang/block/block.h"

namespace kadr {

/// One function to call.
struct PlanItem {
  std::uint8_t rank = 0;  // position in the order of execution
  std::uint8_t word = 0;  // index in Block::words; no_word: the modal motion code
  std::int16_t row = -1;  // in ControlDef::codes; -1: see address
  char address = 0;       // an address that acts by itself
};
inline constexpr std::uint8_t no_word = 255;
inline constexpr std::int16_t any_motion = -2;  // motion row for blocks that are only checked: some motion code is assumed to be in force

struct Plan {
  std::array<PlanItem, limits::block_words + 2> items;
  std::uint32_t count = 0;
  std::uint64_t taken = 0;        // letters that some code uses
  std::uint64_t passed_over = 0;  // letters that no code uses, if the control accepts this silently
  bool axes_taken = false;        // a code that is not a modal motion uses the axis words (G28, G92, …)
  bool moves_only = false;        // axis words alone: no code, no F, S, T …, no assignment
  bool moves_and_feeds = false;   // only G0 to G3 and F
  bool calls_only = false;        // only calls and returns
};

/// Sets of letters by meaning, computed once from the control's table.
struct LetterSets {
  std::uint64_t axes = 0;
  std::uint64_t centers = 0;
  std::uint64_t acting = 0;  // addresses that act by themselves: F, S, T, …
  std::uint64_t codes = 0;
  std::uint64_t spindles = 0;                        // words that select a spindle (nct)
  std::array<std::int8_t, max_addresses> axis_of{};  // axis index of an axis or centre letter; -1 for other letters
  std::array<char, max_axes> center_letter{};        // by axis
  std::array<char, max_axes> axis_letter{};
  explicit LetterSets(const ControlDef& def);
};

/// Plans a block: turns its words into function calls.
///   alarms  code_unknown, group_conflict, not_together, own_block, word_unused, word_missing, no_axis_word, no_motion_mode
Status plan_block(const ControlDef& def, const LetterSets& letters, const Block& block, std::int16_t motion_row, Plan& plan);

}  // namespace kadr
