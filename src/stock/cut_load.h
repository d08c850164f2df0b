#pragma once
// Part of CutResult: what each block removes, and where the tool feeds through air. Lengths in mm, volumes in mm³, times in s.
// docs/stock.md defines each figure and when it is reported.

#include <cstdint>
#include <optional>
#include <string>

#include "action/action.h"

namespace kadr {

/// A block that moves at feed, and what its feed motions removed.
struct BlockLoad {
  Origin origin;
  std::string program;  // the file that contains the line, if it is not the main program
  std::uint32_t tool = 0;
  double begins = 0;
  double seconds = 0;  // at feed
  double length = 0;   // of path
  double volume = 0;
  // Means over at least two cells of path; nullopt if the figure is not reported.
  std::optional<double> rate;            // mm³/s
  std::optional<double> feed_per_tooth;  // mm
  std::optional<double> depth, width;    // of cut
  std::optional<double> angle;           // of engagement, degrees
  Vec3 at;                               // the tip in the middle of the block, in the work system of the blank
};

/// A line that feeds through air.
struct AirCut {
  Origin origin;
  std::string program;
  std::uint32_t tool = 0;  // when the line first runs
  double seconds = 0;      // in which nothing is removed, summed over all executions of the line
};

inline constexpr std::size_t most_told = 10;  // lines in each of the two lists: heaviest and emptiest

}  // namespace kadr
