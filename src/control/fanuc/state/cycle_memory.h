#pragma once
// The data of canned cycles and of measuring that stay valid from block to block (spec/nct/18, 19, 21). All are plain values.

#include <array>
#include <cstddef>
#include <cstdint>

#include "action/action.h"
#include "base/vec.h"

namespace kadr::fanuc {

/// The words of a drilling cycle, which are modal while the cycle mode is on. When the mode ends, they are deleted: R and the bottom become
/// increments of 0, all other words 0 (18.0).
struct DrillingMemory {
  std::size_t axis = 0;                          // the drilling axis
  double initial = 0;                            // initial level in programmed coordinates, mm
  double level = 0, bottom = 0;                  // R and the bottom of the hole as programmed, mm
  bool level_added = true, bottom_added = true;  // true for an increment: R counts from the initial level, the bottom from R
  bool level_known = false, bottom_known = false;
  Vec3 shift;             // I, J, K of G76 and G87, mm
  double percent = 0;     // percentage I of G85, G89, G84.2, G84.3; 0 if it is not programmed
  double peck = 0;        // depth Q of a peck, mm; 0 if it is not programmed
  double clearance = -1;  // distance E above the depth reached, mm; -1 if it is not programmed
  double dwell = 0;       // dwell P in seconds or revolutions
};

/// The data of the first blocks of two-block turning cycles, which are valid until programmed again, and the data of the simple turning
/// cycle in force. Lengths are in mm.
struct TurningMemory {
  double depth = 0, back = 0;  // G71.7, G72.7: depth of a pass, and length of the retract at 45°
  Vec2 relief;                 // G73.7: offset of the first pass in the plane
  std::uint32_t passes = 0;
  double groove_back = 0;  // G74.7, G75.7: length of the retract
  // G76.7; `finishing`: number of finishing passes
  std::uint32_t finishing = 1;
  double chamfer = 0;     // length of the run-out, in thread leads
  double tool_angle = 0;  // angle of the threading tool, degrees
  double least = 0;       // least depth of a thread pass
  double allowance = 0;   // depth that is left for the finishing passes
  // simple turning cycles
  std::int32_t code = 0;  // code in tenths of the simple cycle in force: 777, 787 or 797; 0 if there is none
  std::array<double, 2> target{};
  std::array<bool, 2> known{};
  double taper = 0;
  double start_angle = 0;
};

/// A contour that G70.7 executes block by block: where the contour ends, and the point to which the tool returns afterwards.
struct Finishing {
  std::size_t depth = 0;          // number of open calls during the blocks of the contour
  std::uint64_t contour_end = 0;  // offset in the file just after the contour's last block
  Vec2 start;                     // point in the plane to which the tool returns, in programmed coordinates, mm
  Origin origin;                  // location of the block with G70.7
};

/// The purpose of the probe motion in progress. The measurement is complete when the probe's answer has come.
struct Measurement {
  bool length = false;       // G37: the measurement corrects a length offset; false: G31
  std::size_t axis = 0;      // the measured axis
  double expected = 0;       // work coordinate in mm at which the signal is expected
  double window = 0;         // N3005: greatest permitted distance of the signal from `expected`, mm
  std::uint32_t offset = 0;  // number of the offset to be corrected
};

}  // namespace kadr::fanuc
