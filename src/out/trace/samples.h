#pragma once
// SampleWriter: positions at the servo rate as CSV (design.md 5): t,X,Y,Z,… in s and mm (degrees), machine coordinates; with feed holds
// and overrides at given times if wanted. Of a control that moves axes in step with a spindle its angle too, `spindle`: running degrees,
// clockwise.

#include <cstdio>
#include <deque>
#include <string>
#include <vector>

#include "action/axis_roles.h"
#include "action/tool_position.h"
#include "motion/play/playback.h"
#include "out/trace/sample_options.h"

namespace kadr {

/// Why nothing more is written.
enum class SampleEnd : std::uint8_t {
  none,      // it is; or the motion is over
  max_time,  // longer than was allowed
  stopped,   // it was asked to
};

class SampleWriter {
 public:
  /// Writes the heading. The file stays the caller's.
  SampleWriter(std::FILE* file, const std::vector<std::string>& axes, MotionLimits limits, SampleOptions options);

  /// Writes a second file: the tool's tip in work coordinates and its direction at the same instants. Its heading at once.
  void write_tips(std::FILE* file, const AxisRoles& roles);
  /// From this motion on the tool's place is told from here: the work system, rotary axes and length in force.
  void take_place(std::uint64_t motion, const ToolPosition& from);

  void take(const TimedCells& cells);
  /// The last position, and all that is buffered. A feed hold without end is one to the last position that was written.
  void finish();
  /// False: what was to be written could not be. Then nothing more is.
  bool ok() const { return error_ == 0; }
  int error() const { return error_; }  // of the system; 0: none
  /// From then on cells are passed over.
  SampleEnd ended() const { return ended_; }
  /// The tag of the cell of the last one.
  std::uint64_t tag() const { return playback_.tag(); }

  /// The frame of a motion and of those after it.
  struct ToolPlace {
    std::uint64_t motion = 0;
    ToolPosition from;
  };
  /// What it remembers, what is not written into the file yet included.
  struct Memory {
    Playback::Memory playback;
    std::size_t changed = 0;
    std::uint64_t instant = 0;
    std::string text, tips;
    std::deque<ToolPlace> places;
    SampleEnd ended = SampleEnd::none;
  };
  Memory memory() const { return {playback_.memory(), changed_, instant_, text_, tip_text_, places_, ended_}; }
  void remember(const Memory& memory);

 private:
  void write_tip(const double* at);
  bool halted();
  bool play();
  void write(const double* at);
  void flush();

  std::FILE* file_;
  std::size_t axes_;
  double period_;
  int decimals_;  // of positions: so many that differences of the third order still tell the jerk
  Playback playback_;
  SampleOptions options_;
  std::size_t changed_ = 0;  // of them are in force
  std::uint64_t instant_ = 0;
  std::string text_;
  std::FILE* tip_file_ = nullptr;
  std::string tip_text_;
  AxisRoles roles_;
  std::deque<ToolPlace> places_;  // the first is that of the present motion
  int error_ = 0;
  SampleEnd ended_ = SampleEnd::none;
};

}  // namespace kadr
