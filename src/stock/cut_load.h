#pragma once
// Part of CutResult: what each block of the program removes, and the blocks in which the tool moves at feed through air. Lengths are in mm,
// volumes in mm³, times in s. docs/stock.md defines each value and when it is reported.

#include <cstdint>
#include <optional>
#include <string>

#include "action/action.h"

namespace kadr {

/// The cutting load of a block: what the feed motions of this block removed.
struct BlockLoad {
  Origin origin;
  std::string program;  // the program file that contains the block; empty if the block is in the main program
  std::uint32_t tool = 0;
  double begins = 0;
  double seconds = 0;  // time at feed, s
  double length = 0;   // length of the path at feed, mm
  double volume = 0;
  // Mean values of the cut, each over a section of the path at least two lattice cells long; nullopt if the value is not reported
  // (docs/stock.md).
  std::optional<double> rate;            // removal rate, mm³/s
  std::optional<double> feed_per_tooth;  // feed per tooth, mm
  std::optional<double> depth, width;    // depth and width of cut, mm
  std::optional<double> angle;           // angle of engagement, degrees
  Vec3 at;                               // position of the tip half way through the block, in the work coordinates of the blank
};

/// A block of the program in which the tool feeds through air.
struct AirCut {
  Origin origin;
  std::string program;
  std::uint32_t tool = 0;  // number of the tool at the first execution of the block
  double seconds = 0;      // time in s in which the block removes nothing, summed over all executions of the block
};

// Greatest number of blocks in each of the two lists, CutResult::heaviest and CutResult::emptiest.
inline constexpr std::size_t max_reported = 10;

}  // namespace kadr
