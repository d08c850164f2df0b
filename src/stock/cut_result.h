#pragma once
// CutResult: the outcome of a cut, for the reports. Lengths are in mm, volumes in mm³, times in s.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "base/alarm.h"
#include "stock/cut_load.h"

namespace kadr {

/// A collision with the material or between two bodies, or a cut that is forbidden.
struct CutFinding {
  AlarmId id = AlarmId::rapid_in_stock;
  Origin origin;
  std::string program{};                   // the program file that contains the block; empty if the block is in the main program
  std::vector<AlarmReport::Call> calls{};  // the subprogram calls that led to the block, the outermost call first
  std::uint32_t tool = 0;
  Vec3 at;             // the middle of the removed material, in the work coordinates of the blank
  double depth = 0;    // the shortest edge of the box around the removed material, mm
  double volume = 0;   // removed volume, mm³
  double at_time = 0;  // time in s since the start of the program
  /// Names of the two bodies that collided; set only for a collision between bodies (AlarmId::machine).
  std::array<std::string, 2> bodies{};
};

struct ToolRemoval {
  std::uint32_t tool = 0;
  double removed = 0;        // removed volume, mm³
  double seconds = 0;        // time at feed, s
  double greatest_rate = 0;  // greatest removal rate in mm³/s; each rate is a mean over at least two lattice cells of path
};

/// A difference between the cut part and the wanted part: either material that was left on the part, or material that was gouged from it.
struct PartDifference {
  double volume = 0;       // volume of the difference, mm³
  double deepest = 0;      // greatest distance of the difference from the surface of the wanted part, mm
  Vec3 at;                 // position of the greatest distance, in the work coordinates of the blank
  std::uint32_t line = 0;  // line of the block that last cut next to `at`; 0 where the blank's own surface remains
  std::string program{};   // the program file that contains the block; empty if the block is in the main program
};

struct PartResult {
  PartDifference left_on, gouged;
  double allow = 0;           // permitted depth of a gouge, mm
  double allow_left = 1e300;  // permitted thickness of material that is left on, mm

  bool is_gouged() const { return gouged.deepest > allow; }
  bool is_left_on() const { return left_on.deepest > allow_left; }
};

/// The result of the second, finer cut inside a window.
struct WindowResult {
  // Volumes inside the window in mm³: of the blank, of the remaining material, and the upper bound of their error.
  double stock = 0, left = 0, error_bound = 0;
  double cell = 0;  // edge length of a lattice cell in the window, mm
};

/// The numbers of triangles of a surface that was simplified before it was written to a file.
struct SimplifiedResult {
  std::size_t exact = 0, triangles = 0;  // numbers of triangles before and after simplification
  double off = 0;                        // greatest distance between the exact and the simplified surface, measured in both directions, mm
};

/// A thread that a turning tool has cut, described by the deepest pass of the tool. Radii are measured from the axis of the part.
struct ThreadCut {
  Origin origin;
  std::string program{};  // the program file that contains the block; empty if the block is in the main program
  std::uint32_t tool = 0;
  double lead = 0;  // lead of the thread in mm; 0 if the program does not give the lead
  bool is_outer = true;
  std::size_t passes = 0;
  // Start and end of the path of the insert's point: radii and Z positions, mm.
  double from_radius = 0, to_radius = 0, from_z = 0, to_z = 0;
  /// Radius in mm of the crest (the remaining material) at the middle of the thread's length; nullopt if no material remains there.
  std::optional<double> crest_radius{};

  double middle_radius() const { return 0.5 * (from_radius + to_radius); }
};

/// Figures of a part that was cut exactly, as a body of revolution.
struct TurnedResult {
  double surface = 0, machined = 0;  // area of the part's surface, and of what tools have cut of it, mm²
  /// Motions at feed that cut no body of revolution: with C or Y, or of a tool that turns off the axis. They remove nothing.
  struct LeftOut {
    Origin origin;          // the first of them
    std::string program{};  // the program file that contains the block; empty if the block is in the main program
    std::uint32_t tool = 0;
    std::size_t motions = 0;
  };
  std::vector<LeftOut> left_out;
};

struct CutResult {
  double stock = 0;        // volume of the blank, mm³
  double left = 0;         // volume of the remaining material, mm³
  double error_bound = 0;  // upper bound of the error of the volumes `stock` and `left`, mm³
  double cell = 0;         // edge length of a lattice cell, mm; with `turned` the greatest deviation of a chord from an arc
  double seconds = 0;      // duration of the program, s
  std::uint64_t sweeps = 0;
  std::vector<ToolRemoval> tools;      // for each tool, the volume that it has removed and its time at feed; in the order of first use
  std::vector<CutFinding> collisions;  // collisions and forbidden cuts that count as alarms
  std::vector<CutFinding> warnings;
  std::vector<BlockLoad> heaviest;  // blocks with the greatest removal rates, in descending order
  std::vector<AirCut> emptiest;     // blocks with the longest times in the air, in descending order
  // Comparison with the wanted part, if such a part was given; only inside the window, if there is a window.
  std::optional<PartResult> part;
  std::optional<WindowResult> window;
  std::optional<TurnedResult> turned;
  std::optional<SimplifiedResult> simplified;
  std::size_t not_listed = 0;  // number of findings that the lists omit, because each list has a limit
  // Numbers of the tools, except turning tools, whose diameter is less than two lattice cells. If there is a window, the cells of the
  // window count.
  std::vector<std::uint32_t> finer_than_cell;
  std::vector<ThreadCut> threads;  // threads in the order of the program
};

}  // namespace kadr
