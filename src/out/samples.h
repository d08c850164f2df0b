#pragma once
// SampleWriter: positions at the servo rate as CSV (design.md 5): t,X,Y,Z,… in s and mm (degrees), machine coordinates; of
// a control that moves axes in step with a spindle its angle too, `spindle`: running degrees, clockwise.

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "motion/sampler.h"

namespace kadr {

enum class SpindleColumn : std::uint8_t { none, last };

class SampleWriter {
 public:
  /// `rate`: Hz. Writes the heading. The file stays the caller's.
  SampleWriter(std::FILE* file, const std::vector<std::string>& axes, double rate, SpindleColumn spindle);

  void take(const TimedCells& cells);
  /// The last position, and all that is buffered.
  void finish();
  bool ok() const { return ok_; }

 private:
  void write(std::uint64_t number, const Axes& at, double spindle);
  void flush();

  std::FILE* file_;
  std::size_t axes_;
  SpindleColumn spindle_;
  double period_;
  int decimals_;  // of positions: so many that differences of the third order still tell the jerk
  Sampler sampler_;
  std::string text_;
  bool ok_ = true;
};

}  // namespace kadr
