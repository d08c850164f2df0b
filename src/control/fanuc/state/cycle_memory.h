#pragma once
// The data of canned cycles and of measuring that stay valid from block to block (spec/nct/18, 19, 21). All are plain values.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "action/action.h"
#include "base/vec.h"

namespace kadr::fanuc {

/// The words of a drilling cycle, which are modal while the cycle mode is on. When the mode ends, they are deleted: R and the bottom become
/// increments of 0, all other words 0 (18.0).
struct DrillingMemory {
  std::size_t axis = 0;          // the drilling axis
  double initial = 0;            // initial level in programmed coordinates, mm
  double level = 0, bottom = 0;  // R level and bottom of the hole as programmed, mm
  // true: the value is an increment, R from the initial level, the bottom from R; false: the value is absolute
  bool level_added = true, bottom_added = true;
  bool level_known = false, bottom_known = false;
  Vec3 shift;             // I, J, K of G76 and G87: shift of the tool in the plane, mm
  double percent = 0;     // percentage I of the cycles G85, G89, G84.2, G84.3 for the feed of the retract; 0 if I is not programmed
  double peck = 0;        // depth Q of a peck, mm; 0 if it is not programmed
  double clearance = -1;  // word E: distance in mm above the depth reached, where the next peck starts; -1 if E is not programmed
  double dwell = 0;       // dwell P at the bottom of the hole, in seconds, or in G95 in revolutions of the spindle
};

/// The data of the first blocks of Fanuc's cycles G71, G72 and G73 (spec/fanuc-t 9.2, 9.5), mm, depths as radii. Without a value the
/// parameter counts, which on a Fanuc holds the value of the first block too.
struct RepetitiveMemory {
  std::optional<double> depth, back;                  // Δd and e of G71, G72
  std::optional<double> relief_first, relief_second;  // Δk and Δi of G73
  std::optional<std::uint32_t> passes;                // d of G73
};

/// The data of the first blocks of two-block turning cycles, which are valid until programmed again, and the data of the simple turning
/// cycle in force. Lengths are in mm.
struct TurningMemory {
  double depth = 0, back = 0;  // G71.7, G72.7: depth of a roughing pass, and length of the retract at 45° after the pass
  Vec2 relief;                 // G73.7: vector in the plane by which the first pass is offset from the contour
  std::uint32_t passes = 0;
  double groove_back = 0;  // G74.7, G75.7: length of the retract after each peck in a groove
  // thread cycle G76.7: number of finishing passes
  std::uint32_t finishing = 1;
  double chamfer = 0;     // length of the run-out at the end of the thread, in thread leads
  double tool_angle = 0;  // angle of the threading tool, degrees
  double least = 0;       // least increase of depth from one thread pass to the next
  double allowance = 0;   // depth of the thread that is left for the finishing passes
  bool cuts_through = false;  // M24 of a Haas is in force: threads have no run-out (spec/haas-st 5)
  RepetitiveMemory repetitive;
  // simple turning cycles
  std::int32_t code = 0;  // code in tenths of the simple turning cycle in force: 777 (G77.7), 787 or 797; 0 if no such cycle is in force
  std::array<double, 2> target{};
  std::array<bool, 2> known{};
  double taper = 0;
  double start_angle = 0;
};

/// A contour that G70.7 executes block by block: where the contour ends, and the point to which the tool returns afterwards.
struct Finishing {
  // number of open calls while the blocks of the contour are executed; a smaller number means that the program has left the contour
  std::size_t depth = 0;
  std::uint64_t contour_end = 0;  // offset in the program file just after the contour's last block
  Vec2 start;                     // point in the plane to which the tool returns, in programmed coordinates, mm
  Origin origin;                  // location of the block with G70.7
  bool in_side = false;           // G41 or G42 was in force in the block of the cycle
};

/// The purpose of the probe motion in progress. The measurement is complete when the probe's answer has come.
struct Measurement {
  bool length = false;       // true (G37): the measurement corrects a tool length offset; false (G31): no offset changes
  std::size_t axis = 0;      // the measured axis
  double expected = 0;       // G37: work coordinate in mm at which the probe's signal is expected
  double window = 0;         // N3005: greatest permitted distance in mm of the probe's signal from `expected`
  std::uint32_t offset = 0;  // number of the tool length offset that G37 corrects
};

}  // namespace kadr::fanuc
