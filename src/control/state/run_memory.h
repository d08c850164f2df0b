#pragma once
// RunMemory: the data that the interpreter keeps from block to block in addition to ControlState. A snapshot includes these data; an alarm
// does not restore them.

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

/// The next action of the interpreter. It comes after the block's canned cycle and the functions that wait for the end of the cycle.
enum class RunPhase : std::uint8_t {
  next_block,    // reads the next block
  same_block,    // executes the block that was read earlier: the block waited for an answer of the operator, or for its real time
  end_of_block,  // after an observed block: an interrupt macro or the machine's logic acts next (nct 23.4)
  stopped,       // an alarm has stopped the run
};

struct RunMemory {
  Origin origin;  // location of the block being executed
  // work coordinates before the last motion; set only in inch mode, during cutter compensation, and while axes have feeds of their own
  Axes moved_from{};
  std::string call_text;  // text of the block that called the cycle body being executed
  Span call_where;
  WaitingCodes waiting;
  AlarmReport report;               // the last alarm
  ProgramUse use;                   // which data of the set-up the program has used
  std::optional<Position> resumed;  // position of the block that an interrupt macro has delayed
  std::uint64_t start_block = 0;    // number of the block with '%'; 0 if the program has no such block
  std::uint64_t unsupported = 0;    // modal groups, one bit each, whose code at the start is not supported by Kadr
  bool needs_frames = true;         // the first batch must start with a FrameChange
  bool reads_clock = false;         // a block that may read a clock has been read
  bool pass_varies = false;  // a further pass of the program may differ from this pass, because of a variable, a skipped block, a probe …
  bool start_missing_reported = false;
  bool feed_missing_reported = false;
  bool skipping_section = false;
  bool in_interrupt = false;      // the block belongs to an interrupt macro
  bool damaged = false;           // the block could not be read
  AxisMask unknown_position = 0;  // axes whose position is unknown because a motion was refused
  // ---- switches of the panel
  bool optional_stop_on = false;
  std::array<bool, 10> skip_switches{};
  std::vector<bool> skip_answers;                // the operator's answers about blocks to skip (spec/gost 2); empty: no questions
  std::size_t answers_used = 0;                  // number of answers used; the last answer applies to all further questions
  std::optional<bool> skips_it;                  // the operator's answer for the current block: true to skip the block
  std::array<bool, max_axes> mirror_switches{};  // by axis: mirror switches on the panel of the 2С42 (6.8)
};

}  // namespace kadr
