#pragma once
// CutResult: the outcome of a cut, for the reports. Lengths in mm, volumes in mm³, times in s.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "base/alarm.h"
#include "stock/cut_load.h"

namespace kadr {

/// A collision with the material or between bodies, or a forbidden cut.
struct CutFinding {
  AlarmId id = AlarmId::rapid_in_stock;
  Origin origin;
  std::string program{};                   // the program file, as in BlockLoad
  std::vector<AlarmReport::Call> calls{};  // the subprogram calls that led to the block, outermost first
  std::uint32_t tool = 0;
  Vec3 at;             // the middle of the removed material, in the work system of the blank
  double depth = 0;    // the shortest side of the box around the removed material, mm
  double volume = 0;   // removed volume, mm³
  double at_time = 0;  // s since the start of the program
  /// Only for AlarmId::machine: the names of the two bodies that met.
  std::array<std::string, 2> bodies{};
};

struct ToolRemoval {
  std::uint32_t tool = 0;
  double removed = 0;        // removed volume, mm³
  double seconds = 0;        // time at feed, s
  double greatest_rate = 0;  // greatest removal rate, mm³/s, as a mean over at least two lattice cells of path
};

/// The difference between the cut part and the wanted part, of one sort: material left on, or material gouged.
struct PartDifference {
  double volume = 0;       // mm³
  double deepest = 0;      // greatest distance of the difference from the surface of the wanted part, mm
  Vec3 at;                 // position of the greatest distance, in the work system of the blank
  std::uint32_t line = 0;  // block of the motion that last cut next to `at`; 0 where the blank's own surface remains
  std::string program{};   // the program file, as in BlockLoad
};

struct PartResult {
  PartDifference left_on, gouged;
  double allow = 0;           // permitted depth of a gouge, mm
  double allow_left = 1e300;  // permitted thickness of material left on, mm

  bool is_gouged() const { return gouged.deepest > allow; }
  bool is_left_on() const { return left_on.deepest > allow_left; }
};

/// The result of the second, finer cut inside a window.
struct WindowResult {
  double stock = 0, left = 0, error_bound = 0;  // volumes inside the window, mm³, as in CutResult
  double cell = 0;                              // mm
};

/// The surface that was written to a file, if it was simplified.
struct SimplifiedResult {
  std::size_t exact = 0, triangles = 0;  // number of triangles before and after simplification
  double off = 0;                        // greatest distance between exact and simplified surface, in both directions, mm
};

/// A thread that a turning tool has cut, described by its deepest pass. Radii are measured from the axis of the part.
struct ThreadCut {
  Origin origin;
  std::string program{};  // the program file, as in BlockLoad
  std::uint32_t tool = 0;
  double lead = 0;  // thread lead, mm; 0 if the program does not give it
  bool is_outer = true;
  std::size_t passes = 0;
  double from_radius = 0, to_radius = 0, from_z = 0, to_z = 0;  // path of the insert's point, start and end
  /// Radius of the crest (the remaining material) at the middle of the thread's length; nullopt if no material remains there.
  std::optional<double> crest_radius{};

  double middle_radius() const { return 0.5 * (from_radius + to_radius); }
};

struct CutResult {
  double stock = 0;        // volume of the blank, mm³
  double left = 0;         // volume of the remaining material, mm³
  double error_bound = 0;  // upper bound of the error of `stock` and `left`, mm³
  double cell = 0;         // edge length of a lattice cell, mm
  double seconds = 0;      // duration of the program
  std::uint64_t sweeps = 0;
  std::vector<ToolRemoval> tools;      // in the order of their first use
  std::vector<CutFinding> collisions;  // collisions and forbidden cuts that count as alarms
  std::vector<CutFinding> warnings;
  std::vector<BlockLoad> heaviest;  // blocks with the greatest removal rates, the greatest first
  std::vector<AirCut> emptiest;     // blocks with the longest time in the air, the longest first
  std::optional<PartResult> part;   // if a wanted part was given; only the part inside the window, if there is a window
  std::optional<WindowResult> window;
  std::optional<SimplifiedResult> simplified;
  std::size_t not_listed = 0;                  // number of findings beyond the limit of the lists
  std::vector<std::uint32_t> finer_than_cell;  // numbers of the tools thinner than two lattice cells (cells of the window, if there is one)
  std::vector<ThreadCut> threads;              // in the order of the program
};

}  // namespace kadr
