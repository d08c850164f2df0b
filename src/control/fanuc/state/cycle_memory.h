#pragma once
// What canned cycles and measuring remember from block to block (spec/nct/18, 19, 21). Plain values.

#include <array>
#include <cstddef>
#include <cstdint>

#include "action/action.h"
#include "base/vec.h"

namespace kadr::fanuc {

/// Words of a drilling cycle. They are modal while the cycle mode is on. When the mode ends, the words are deleted: R and the bottom become
/// increments of 0, all other words 0 (18.0).
struct DrillingMemory {
  std::size_t axis = 0;                          // the drilling axis
  double initial = 0;                            // initial level, programmed coordinates, mm
  double level = 0, bottom = 0;                  // R and the bottom as programmed, mm
  bool level_added = true, bottom_added = true;  // true for an increment: R from the initial level, bottom from R
  bool level_known = false, bottom_known = false;
  Vec3 shift;             // I, J, K of G76 and G87, mm
  double percent = 0;     // percentage I of G85, G89, G84.2, G84.3; 0: not given
  double peck = 0;        // depth of a peck by Q, mm; 0: not given
  double clearance = -1;  // clearance E above the depth reached, mm; -1: not given
  double dwell = 0;       // dwell P, seconds or revolutions
};

/// Data of the first blocks of two-block turning cycles, valid until programmed again, and data of the simple turning cycle in force.
/// Lengths are in mm.
struct TurningMemory {
  double depth = 0, back = 0;  // G71.7, G72.7: depth of a pass, retract at 45°
  Vec2 relief;                 // G73.7: offset of the first pass, in the plane
  std::uint32_t passes = 0;
  double groove_back = 0;  // G74.7, G75.7: retract
  // G76.7; `finishing`: number of finishing passes
  std::uint32_t finishing = 1;
  double chamfer = 0;     // length of the run-out, in thread leads
  double tool_angle = 0;  // angle of the threading tool, degrees
  double least = 0;       // least depth of a pass
  double allowance = 0;   // depth left for the finishing passes
  // simple turning cycles
  std::int32_t code = 0;  // code in tenths: 777, 787, 797; 0: no simple cycle in force
  std::array<double, 2> target{};
  std::array<bool, 2> known{};
  double taper = 0;
  double start_angle = 0;
};

/// A contour that G70.7 executes block by block: where the contour ends, and the point to which the tool returns afterwards.
struct Finishing {
  std::size_t depth = 0;     // number of open calls while blocks of the contour are executed
  std::uint64_t behind = 0;  // offset in the file just after the contour's last block
  Vec2 start;                // point to which the tool returns: in the plane, programmed coordinates
  Origin origin;             // location of the block with G70.7
};

/// The purpose of the probe motion in progress; the probe's answer completes it.
struct Measurement {
  bool length = false;       // G37: a length offset is corrected
  std::size_t axis = 0;      // the measured axis
  double expected = 0;       // expected work coordinate of the signal, mm
  double window = 0;         // N3005: permitted distance of the signal from `expected`, mm
  std::uint32_t offset = 0;  // number of the offset to correct
};

}  // namespace kadr::fanuc
