#pragma once
// What the interpreter remembers from block to block beside its state: a snapshot holds it, an alarm does not bring it back.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "base/vec.h"
#include "control/state/usage.h"
#include "control/state/waiting.h"
#include "lang/block/block.h"

namespace kadr {

/// What the interpreter does when the cycle of its block is over, and what waits for the cycle's end.
enum class RunPhase : std::uint8_t {
  next_block,    // reads the next block
  same_block,    // executes the block that was read: a question was asked first, or the time had to be that of the moment
  end_of_block,  // a watched block has been executed: an interrupt macro and the machine's logic look at its end (nct 23.4)
  stopped,       // an alarm
};

struct RunMemory {
  Origin origin;          // of the block being carried out
  Axes moved_from{};      // work coordinates before the last motion, in inches mode and with radius compensation
  std::string call_text;  // block that called the cycle body being carried out, and its L word
  Span call_where;
  WaitingCodes waiting;
  AlarmReport report;               // the last alarm
  ProgramUse use;                   // of what a set-up states
  std::optional<Position> resumed;  // the block that was to begin when an interrupt macro came
  std::uint64_t start_block = 0;    // number of the block with '%'; 0: none
  std::uint64_t unserved = 0;       // groups that a code which does not work was in at the start
  bool needs_frames = true;         // the first batch begins with them
  bool reads_clock = false;         // a block that may read a clock has come
  bool pass_varies = false;         // this pass of the main program met what may be otherwise in the next: a variable, a skip, a probe …
  bool start_missing_reported = false;
  bool feed_missing_told = false;
  bool skipping_section = false;
  bool in_interrupt = false;  // the block belongs to an interrupt macro
  bool damaged = false;       // the block could not be read
  AxisMask unplaced = 0;      // axes of which a refused motion has left unknown where they are
  // switches of the panel
  bool optional_stop_on = false;
  std::array<bool, 10> skip_switches{};
  std::vector<bool> skip_answers;                // of the operator, who is asked before a block is skipped (spec/gost 2); empty: nobody is
  std::size_t skips_asked = 0;                   // so many of them are used up; the last one counts on
  std::optional<bool> skips_it;                  // to the question about the current block
  std::array<bool, max_axes> mirror_switches{};  // of the 2С42 (6.8)
};

}  // namespace kadr
