#pragma once
// What blocks take away, and where the tool goes through air: part of CutResult. Lengths mm, volumes mm³, times s; docs/stock.md says what
// each figure is and when it is told.

#include <cstdint>
#include <optional>
#include <string>

#include "action/action.h"

namespace kadr {

/// A block that moves at feed: what its motions at feed took away.
struct BlockLoad {
  Origin origin;
  std::string program;  // file that the line stands in, if that is not the program itself
  std::uint32_t tool = 0;
  double begins = 0;
  double seconds = 0;  // at feed
  double length = 0;   // of path
  double volume = 0;
  // The rest as a mean over at least two cells of path; nothing: it is not told.
  std::optional<double> rate;            // mm³/s
  std::optional<double> feed_per_tooth;  // mm
  std::optional<double> depth, width;    // of cut
  std::optional<double> angle;           // of engagement, degrees
  Vec3 at;                               // the tip in the middle of it, in the work system of the blank
};

/// A line at feed in the air.
struct AirCut {
  Origin origin;
  std::string program;
  std::uint32_t tool = 0;  // of the first time
  double seconds = 0;      // in which nothing is removed, of all times that it is carried out
};

inline constexpr std::size_t most_told = 10;  // heaviest and emptiest lines

}  // namespace kadr
