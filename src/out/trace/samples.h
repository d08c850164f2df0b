#pragma once
// SampleWriter: writes axis positions at the rate of the servo clock as CSV (docs/commands/run.md). The columns are t,X,Y,Z,…: the time in
// s and machine coordinates in mm or degrees. On request, feed holds and overrides are applied at given times. If the control moves axes
// synchronously with a spindle, the column `spindle` contains the spindle angle in degrees, clockwise, without a reset at 360.

#include <cstdio>
#include <deque>
#include <string>
#include <vector>

#include "action/axis_roles.h"
#include "action/tool_position.h"
#include "motion/play/playback.h"
#include "out/trace/sample_options.h"

namespace kadr {

/// The reason why no more samples are written.
enum class SampleEnd : std::uint8_t {
  none,      // no end has been requested: samples are still being written, or the motions of the program have ended
  max_time,  // the time limit was exceeded
  stopped,   // a stop was requested
};

class SampleWriter {
 public:
  /// Writes the heading of the file. The caller must close the file later.
  SampleWriter(std::FILE* file, const std::vector<std::string>& axes, MotionLimits limits, SampleOptions options);

  /// Starts a second file and writes its heading. For the same instants the second file contains the tool tip in work coordinates and the
  /// direction of the tool axis.
  void write_tips(std::FILE* file, const AxisRoles& roles);
  /// Sets the data with which tip positions are computed from the motion with the number `motion` on. `from`: the tool position whose work
  /// coordinates, rotary axes and tool length are used.
  void take_place(std::uint64_t motion, const ToolPosition& from);

  void take(const TimedCells& cells);
  /// Writes the samples up to the last position, and writes the buffer to the file. If a feed hold never ends, the last sample is the
  /// position of the hold.
  void finish();
  /// Returns false after a write error. Then no more samples are written.
  bool ok() const { return error_ == 0; }
  int error() const { return error_; }  // errno of the first write error; 0: none
  /// Returns why no more samples are written. Cells that arrive later are ignored.
  SampleEnd ended() const { return ended_; }
  /// Returns the tag (64-bit number that identifies the program line) of the cell that contains the last sample. A cell is a short timed
  /// segment.
  std::uint64_t tag() const { return playback_.tag(); }

  /// The data for computing tool tips (work coordinates, rotary axes, tool length), valid from a certain motion on.
  struct ToolPlace {
    std::uint64_t motion = 0;
    ToolPosition from;
  };
  /// The complete state of the writer, including text that has not been written to the file yet.
  struct Memory {
    Playback::Memory playback;
    std::size_t changed = 0;
    std::uint64_t instant = 0;
    std::string text, tips;
    std::deque<ToolPlace> places;
    SampleEnd ended = SampleEnd::none;
  };
  Memory memory() const { return {playback_.memory(), changed_, instant_, text_, tip_text_, places_, ended_}; }
  void resume_from(const Memory& memory);

 private:
  void write_tip(const double* at);
  bool halted();
  bool play();
  void write(const double* at);
  void flush();

  std::FILE* file_;
  std::size_t axes_;
  double period_;
  int decimals_;  // number of decimals of positions; it is sufficient for computing the jerk from third differences
  Playback playback_;
  SampleOptions options_;
  std::size_t changed_ = 0;  // number of override changes that have been applied
  std::uint64_t instant_ = 0;
  std::string text_;
  std::FILE* tip_file_ = nullptr;
  std::string tip_text_;
  AxisRoles roles_;
  // the data for computing tool tips, in the order of the motions; the first element applies to the present motion
  std::deque<ToolPlace> places_;
  int error_ = 0;
  SampleEnd ended_ = SampleEnd::none;
};

}  // namespace kadr
