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
  std::string program{};                   // as in BlockLoad
  std::vector<AlarmReport::Call> calls{};  // the calls that led to the line, outermost first
  std::uint32_t tool = 0;
  Vec3 at;             // the middle of the removed material, in the work system of the blank
  double depth = 0;    // the shortest side of the box around the removed material
  double volume = 0;   // of the removed material
  double at_time = 0;  // s since the start
  /// For AlarmId::machine: the names of the two bodies that met.
  std::array<std::string, 2> bodies{};
};

struct ToolRemoval {
  std::uint32_t tool = 0;
  double removed = 0;        // mm³
  double seconds = 0;        // at feed
  double greatest_rate = 0;  // mm³/s, over at least two cells of path
};

/// The difference from the wanted part in one direction: material left on, or gouged.
struct PartDifference {
  double volume = 0;       // mm³
  double deepest = 0;      // mm from the part's surface
  Vec3 at;                 // the position of the deepest difference, in the work system of the blank
  std::uint32_t line = 0;  // of the motion that last cut next to it; 0 for the blank's own surface
  std::string program{};   // as in BlockLoad
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
  double stock = 0, left = 0, error_bound = 0;  // mm³ in the window
  double cell = 0;                              // mm
};

/// The written surface, if it was simplified.
struct SimplifiedResult {
  std::size_t exact = 0, triangles = 0;  // number of triangles before and after
  double off = 0;                        // the greatest distance of either surface from the other, mm
};

/// A thread that a turning tool has cut, described by its deepest pass. Radii are measured from the axis of the part.
struct ThreadCut {
  Origin origin;
  std::string program{};  // as in BlockLoad
  std::uint32_t tool = 0;
  double lead = 0;  // mm; 0 if the program does not give it
  bool is_outer = true;
  std::size_t passes = 0;
  double from_radius = 0, to_radius = 0, from_z = 0, to_z = 0;  // of the insert's point
  /// Of the remaining material at the middle of the thread; nullopt if there is none.
  std::optional<double> crest_radius{};

  double middle_radius() const { return 0.5 * (from_radius + to_radius); }
};

struct CutResult {
  double stock = 0;        // mm³ of the blank
  double left = 0;         // mm³ of the remaining material
  double error_bound = 0;  // of both volumes
  double cell = 0;         // mm
  double seconds = 0;      // of the program
  std::uint64_t sweeps = 0;
  std::vector<ToolRemoval> tools;      // in the order of their first use
  std::vector<CutFinding> collisions;  // alarms
  std::vector<CutFinding> warnings;
  std::vector<BlockLoad> heaviest;  // lines by removal rate, the greatest first
  std::vector<AirCut> emptiest;     // lines by seconds in the air, the most first
  std::optional<PartResult> part;   // if a wanted part was given; inside the window only, if there is one
  std::optional<WindowResult> window;
  std::optional<SimplifiedResult> simplified;
  std::size_t not_told = 0;                    // findings beyond the number that is kept
  std::vector<std::uint32_t> finer_than_cell;  // numbers of the tools thinner than two cells (cells of the window if there is one)
  std::vector<ThreadCut> threads;              // in the order of the program
};

}  // namespace kadr
