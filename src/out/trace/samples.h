#pragma once
// SampleWriter: writes axis positions at the servo rate as CSV (docs/commands/run.md): t,X,Y,Z,… in s and mm (degrees), machine
// coordinates; on request with feed holds and overrides at given times. If the control moves axes synchronously with a spindle, the
// column `spindle` contains the spindle angle in degrees, clockwise, not reset at 360.

#include <cstdio>
#include <deque>
#include <string>
#include <vector>

#include "action/axis_roles.h"
#include "action/tool_position.h"
#include "motion/play/playback.h"
#include "out/trace/sample_options.h"

namespace kadr {

/// Why no more samples are written.
enum class SampleEnd : std::uint8_t {
  none,      // samples are still being written, or the motions have ended
  max_time,  // the time limit was exceeded
  stopped,   // a stop was requested
};

class SampleWriter {
 public:
  /// Writes the heading. The caller closes the file.
  SampleWriter(std::FILE* file, const std::vector<std::string>& axes, MotionLimits limits, SampleOptions options);

  /// Also writes a second file: at the same instants the tool tip in work coordinates and the direction of the tool axis. Writes its
  /// heading at once.
  void write_tips(std::FILE* file, const AxisRoles& roles);
  /// From this motion on, tip positions are computed with the work system, rotary axes and tool length of `from`.
  void take_place(std::uint64_t motion, const ToolPosition& from);

  void take(const TimedCells& cells);
  /// Writes the samples up to the last position and flushes the buffer. If a feed hold never ends, the samples end at the position where
  /// it holds.
  void finish();
  /// Returns false after a write error; nothing more is written then.
  bool ok() const { return error_ == 0; }
  int error() const { return error_; }  // errno of the first write error; 0: none
  /// Why writing has ended. Cells that come later are ignored.
  SampleEnd ended() const { return ended_; }
  /// The tag of the cell (timed segment) that contains the last sample.
  std::uint64_t tag() const { return playback_.tag(); }

  /// The frame for tool tips (work system, rotary axes, tool length), valid from one motion on.
  struct ToolPlace {
    std::uint64_t motion = 0;
    ToolPosition from;
  };
  /// The complete state of the writer, including data that is not written to the file yet.
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
  int decimals_;  // decimals of positions: enough for third differences to show the jerk
  Playback playback_;
  SampleOptions options_;
  std::size_t changed_ = 0;  // number of override changes already applied
  std::uint64_t instant_ = 0;
  std::string text_;
  std::FILE* tip_file_ = nullptr;
  std::string tip_text_;
  AxisRoles roles_;
  std::deque<ToolPlace> places_;  // the first one belongs to the present motion
  int error_ = 0;
  SampleEnd ended_ = SampleEnd::none;
};

}  // namespace kadr
