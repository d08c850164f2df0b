#pragma once
// CutResult: what a cut came to, for whoever tells it. Lengths mm, volumes mm³, times s.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "base/alarm.h"
#include "stock/cut_load.h"

namespace kadr {

/// Something hit the material, or was cut as it must not be.
struct CutFinding {
  AlarmId id = AlarmId::rapid_in_stock;
  Origin origin;
  std::string program{};                   // as of BlockLoad
  std::vector<AlarmReport::Call> calls{};  // by which its line came to be carried out, outermost first
  std::uint32_t tool = 0;
  Vec3 at;             // the middle of what was taken away, in the work system of the blank
  double depth = 0;    // least side of the box around it
  double volume = 0;   // of it
  double at_time = 0;  // s since the start
  /// Of AlarmId::machine: the names of those that met.
  std::array<std::string, 2> bodies{};
};

struct ToolRemoval {
  std::uint32_t tool = 0;
  double removed = 0;        // mm³
  double seconds = 0;        // at feed
  double greatest_rate = 0;  // mm³/s, over at least two cells of path
};

/// What differs from the part that was wanted, one way.
struct PartDifference {
  double volume = 0;       // mm³
  double deepest = 0;      // mm from the part's surface
  Vec3 at;                 // there, in the work system of the blank
  std::uint32_t line = 0;  // of the motion that cut last next to it; 0: the blank's own surface
  std::string program{};   // as of BlockLoad
};

struct PartResult {
  PartDifference left_on, gouged;
  double allow = 0;           // mm that a gouge may be deep
  double allow_left = 1e300;  // mm that may be left on

  bool is_gouged() const { return gouged.deepest > allow; }
  bool is_left_on() const { return left_on.deepest > allow_left; }
};

/// What was cut anew in a window, finer.
struct WindowResult {
  double stock = 0, left = 0, error_bound = 0;  // mm³ in the window
  double cell = 0;                              // mm
};

/// The surface that is written, where it was made simpler.
struct SimplifiedResult {
  std::size_t exact = 0, triangles = 0;  // before and after
  double off = 0;                        // mm, the farthest of either from the other
};

/// A thread that a turning tool has cut. Of its deepest pass; radii from the axis of the part.
struct ThreadCut {
  Origin origin;
  std::string program{};  // as of BlockLoad
  std::uint32_t tool = 0;
  double lead = 0;  // mm; 0: the program does not say
  bool is_outer = true;
  std::size_t passes = 0;
  double from_radius = 0, to_radius = 0, from_z = 0, to_z = 0;  // of the insert's point
  /// Of what is left of the material in the middle of it; nothing: none is there.
  std::optional<double> crest_radius{};

  double middle_radius() const { return 0.5 * (from_radius + to_radius); }
};

struct CutResult {
  double stock = 0;        // mm³ of the blank
  double left = 0;         // of what is left
  double error_bound = 0;  // of these
  double cell = 0;         // mm
  double seconds = 0;      // of the program
  std::uint64_t sweeps = 0;
  std::vector<ToolRemoval> tools;      // in the order of their first use
  std::vector<CutFinding> collisions;  // alarms
  std::vector<CutFinding> warnings;
  std::vector<BlockLoad> heaviest;  // lines by removal rate, the greatest first
  std::vector<AirCut> emptiest;     // lines by seconds in the air, the most first
  std::optional<PartResult> part;   // if one was wanted; of a window what lies in it
  std::optional<WindowResult> window;
  std::optional<SimplifiedResult> simplified;
  std::size_t not_told = 0;                    // findings beyond those that are kept
  std::vector<std::uint32_t> finer_than_cell;  // numbers of tools thinner than two cells, of the window if there is one
  std::vector<ThreadCut> threads;              // in the order of the program
};

}  // namespace kadr
