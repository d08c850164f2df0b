#pragma once
// What cycles and measuring keep from block to block (spec/nct/18, 19, 21). Values.

#include <array>
#include <cstddef>
#include <cstdint>

#include "action/action.h"
#include "base/vec.h"

namespace kadr::fanuc {

/// Cycle variables, modal while the mode is on. Deleted: R and the bottom are increments of 0, all others 0 (18.0).
struct DrillingMemory {
  std::size_t axis = 0;                          // that drills
  double initial = 0;                            // the initial point, programmed, mm
  double level = 0, bottom = 0;                  // R and the bottom as their words say, mm
  bool level_added = true, bottom_added = true;  // increments: from the initial point, from R
  bool level_known = false, bottom_known = false;
  Vec3 shift;             // I, J, K of G76 and G87, mm
  double percent = 0;     // I of G85, G89, G84.2, G84.3; 0: not given
  double peck = 0;        // Q, mm; 0: not given
  double clearance = -1;  // E, mm; -1: not given
  double dwell = 0;       // P, seconds or revolutions
};

/// First lines of the compound cycles, kept until they are given again, and the data of the simple cycle in force. mm.
struct TurningMemory {
  double depth = 0, back = 0;  // G71.7, G72.7: of a pass, of the retract at 45°
  Vec2 relief;                 // G73.7: of the first pass, in the plane
  std::uint32_t passes = 0;
  double groove_back = 0;  // G74.7, G75.7
  // G76.7
  std::uint32_t finishing = 1;
  double chamfer = 0;     // leads
  double tool_angle = 0;  // degrees
  double least = 0;       // depth of a pass
  double allowance = 0;   // for the finishing passes
  // simple cycles
  std::int32_t code = 0;  // 777, 787, 797; 0: none
  std::array<double, 2> target{};
  std::array<bool, 2> known{};
  double taper = 0;
  double start_angle = 0;
};

/// A contour that G70.7 carries out block by block: where it ends, where the tool goes back to.
struct Finishing {
  std::size_t depth = 0;     // calls open inside it
  std::uint64_t behind = 0;  // offset in the file after its last block
  Vec2 start;                // in the plane, programmed
  Origin origin;             // of G70.7
};

/// What the probe motion under way is for; its answer finishes it.
struct Measurement {
  bool length = false;       // G37: an offset is corrected
  std::size_t axis = 0;      // along which
  double expected = 0;       // mm, work coordinate of the signal
  double window = 0;         // mm, N3005: how far from it the signal may come
  std::uint32_t offset = 0;  // number of the register
};

}  // namespace kadr::fanuc
