#pragma once
// RunMemory: what the interpreter remembers from block to block besides its state. A snapshot includes it; an alarm does not restore it.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "base/vec.h"
#include "control/state/usage.h"
#include "control/state/waiting_codes.h"
#include "lang/block/block.h"

namespace kadr {

/// What the interpreter does next, once the canned cycle of the block is finished, and with it the functions that wait for the cycle's
/// end.
enum class RunPhase : std::uint8_t {
  next_block,    // reads the next block
  same_block,    // executes the block that was read earlier: postponed for a question to the operator, or until its real time
  end_of_block,  // a watched block (one observed by an interrupt macro or the machine's logic) was executed: these two act next (nct 23.4)
  stopped,       // an alarm has stopped the run
};

struct RunMemory {
  Origin origin;          // location of the block being executed
  Axes moved_from{};      // work coordinates before the last motion; set in inch mode, during cutter compensation, and with feeds of axes
  std::string call_text;  // text of the block that called the cycle body being executed, and place of its L word
  Span call_where;
  WaitingCodes waiting;
  AlarmReport report;               // the last alarm
  ProgramUse use;                   // which data of the set-up the program has used
  std::optional<Position> resumed;  // the block that was about to start when an interrupt macro came
  std::uint64_t start_block = 0;    // number of the block with '%'; 0 if there is none
  std::uint64_t unsupported = 0;    // bit per modal group: a code that this version does not support was in force at the start
  bool needs_frames = true;         // the first batch starts with a FrameChange
  bool reads_clock = false;         // a block that may read a clock has been read
  bool pass_varies = false;         // this pass used something that may differ in the next pass: a variable, a skip, a probe …
  bool start_missing_reported = false;
  bool feed_missing_reported = false;
  bool skipping_section = false;
  bool in_interrupt = false;      // the block belongs to an interrupt macro
  bool damaged = false;           // the block could not be read without a fault
  AxisMask unknown_position = 0;  // axes whose position is unknown because a motion was refused
  // ---- switches of the panel
  bool optional_stop_on = false;
  std::array<bool, 10> skip_switches{};
  std::vector<bool> skip_answers;                // the operator's answers before a block is skipped (spec/gost 2); empty: nobody is asked
  std::size_t skips_asked = 0;                   // number of answers used; the last answer is repeated
  std::optional<bool> skips_it;                  // the operator's answer for the current block: true to skip it
  std::array<bool, max_axes> mirror_switches{};  // mirror switches of the panel of the 2С42 (6.8), by axis
};

}  // namespace kadr
