#pragma once
// LineUses: what each line of a program is used for when the program runs. The text alone does not tell which tool is in the spindle when
// a subprogram is executed, or whether an F word is the lead of a thread.

#include <cstdint>
#include <memory>
#include <vector>

#include "session/session.h"

namespace kadr {

/// What the executions of one line have in common.
struct LineUse {
  bool executed = false;
  bool threads = false;              // a motion of the line cuts a thread with the F word as its lead
  bool taps = false;                 // a motion of the line taps
  bool drills = false;               // the motions of the line belong to a canned cycle
  std::vector<std::uint32_t> tools;  // the tools in the spindle, each once; after the block's tool change if it has one
};

class LineUses {
 public:
  /// Runs the program of the session to its end, or to an alarm, and notes the lines of the program's own file.
  static LineUses of(std::unique_ptr<Session> session, const StopToken& stop);

  const LineUse& line(std::uint32_t number) const { return number < lines_.size() ? lines_[number] : not_executed_; }
  /// Returns the tool in the spindle at the start.
  std::uint32_t first_tool() const { return first_tool_; }
  /// Returns the axes for which some word of the program states a diameter.
  AxisMask diameters() const { return diameters_; }

 private:
  LineUse& at(std::uint32_t line);

  std::vector<LineUse> lines_;
  LineUse not_executed_;
  std::uint32_t first_tool_ = 0;
  AxisMask diameters_ = 0;
};

}  // namespace kadr
