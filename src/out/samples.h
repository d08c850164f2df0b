#pragma once
// SampleWriter: positions at the servo rate as CSV (design.md 5): t,X,Y,Z,… in s and mm (degrees), machine coordinates; with feed holds
// and overrides at given times if wanted.

#include <cstdio>
#include <string>
#include <vector>

#include "motion/override_change.h"
#include "motion/playback.h"

namespace kadr {

class SampleWriter {
 public:
  /// `rate`: Hz. `changes` in the order of their times. Writes the heading. The file stays the caller's.
  SampleWriter(std::FILE* file, const std::vector<std::string>& axes, MotionLimits limits, double rate,
               std::vector<OverrideChange> changes);

  void take(const TimedCells& cells);
  /// The last position, and all that is buffered. A feed hold without end is one to the last position that was written.
  void finish();
  bool ok() const { return ok_; }

 private:
  bool play();
  void write(const double* at);
  void flush();

  std::FILE* file_;
  std::size_t axes_;
  double period_;
  int decimals_;  // of positions: so many that differences of the third order still tell the jerk
  Playback playback_;
  std::vector<OverrideChange> changes_;
  std::size_t changed_ = 0;  // of them are in force
  std::uint64_t instant_ = 0;
  std::string text_;
  bool ok_ = true;
};

}  // namespace kadr
