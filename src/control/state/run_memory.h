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

/// What the interpreter does next, after the canned cycle of the block and the functions that wait for the end of this cycle.
enum class RunPhase : std::uint8_t {
  next_block,    // reads the next block
  same_block,    // executes the block that was read earlier and has waited: for an answer of the operator, or for its real time
  end_of_block,  // the last block was observed: the machine's logic or an interrupt macro acts next (nct 23.4)
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
  ProgramUse use;                   // record of the set-up data that the program has used
  std::optional<Position> resumed;  // position in the program of the block before which an interrupt macro has been called
  std::uint64_t start_block = 0;    // number of the block with '%'; 0 if the program has no such block
  std::uint64_t unsupported = 0;    // modal groups, one bit each, whose initial code Kadr does not support
  bool needs_frames = true;         // the first batch of actions must start with the action FrameChange
  bool reads_clock = false;         // a block that may read a clock variable has been read
  // another pass of a repeated program may differ from this pass, because of a variable, a skipped block, a probe …
  bool pass_varies = false;
  bool start_missing_reported = false;
  bool feed_missing_reported = false;
  bool skipping_section = false;
  bool in_interrupt = false;      // the current block belongs to an interrupt macro
  bool damaged = false;           // the current block could not be read
  AxisMask unknown_position = 0;  // axes whose position is unknown because a motion was refused
  // ---- switches of the panel
  bool optional_stop_on = false;
  std::array<bool, 10> skip_switches{};
  // answers that the set-up gives to the question whether to skip a block (spec/gost 2); empty: no block is asked about
  std::vector<bool> skip_answers;
  std::size_t answers_used = 0;                  // number of answers used so far; the last answer applies to all further questions
  std::optional<bool> skips_it;                  // answer for the current block: true to skip the block; nullopt: no answer yet
  std::array<bool, max_axes> mirror_switches{};  // by axis: true if the mirror switch of the axis is on, on the panel of the 2С42 (6.8)
};

}  // namespace kadr
