#pragma once
// SampleWriter: positions at the servo rate as CSV (design.md 5): t,X,Y,Z,… in s and mm (degrees), machine coordinates; with feed holds
// and overrides at given times if wanted. Of a control that moves axes in step with a spindle its angle too, `spindle`: running degrees,
// clockwise.

#include <cstdio>
#include <string>
#include <vector>

#include "motion/override_change.h"
#include "motion/playback.h"

namespace kadr {

struct SampleOptions {
  double rate = 1000;                   // Hz
  std::vector<OverrideChange> changes;  // in the order of their times
  bool spindle = false;                 // a column more
};

class SampleWriter {
 public:
  /// Writes the heading. The file stays the caller's.
  SampleWriter(std::FILE* file, const std::vector<std::string>& axes, MotionLimits limits, SampleOptions options);

  void take(const TimedCells& cells);
  /// The last position, and all that is buffered. A feed hold without end is one to the last position that was written.
  void finish();
  bool ok() const { return error_ == 0; }
  int error() const { return error_; }  // of the system; 0: none

 private:
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
  int error_ = 0;
};

}  // namespace kadr
