#pragma once
// Restart in mid-program: computes what must be in force before a block, how the present state differs from that, and the path to the
// block. All results are values. They can be displayed, changed, converted to blocks (out/program/restart_blocks) or executed line by line
// (Stepping::enter).

#include <optional>
#include <vector>

#include "action/in_force.h"
#include "out/program/restart_blocks.h"
#include "session/stepping.h"

namespace kadr {

/// The block from which a program is to continue, and the state that the block requires.
struct Restart {
  Origin at;                      // location of the block that is executed first after the restart
  std::vector<InForce> in_force;  // modes, tool, offsets and variables in force before the block `at`
  ToolPosition stand;             // tool position that the restart requires
  std::size_t normal = 2;         // index of the axis that is normal to the working plane; the tool approaches along this axis
};

/// Executes the program without output, from the session's present position to the line, pass, call or condition that `target` states.
/// `hole`: if the block drills with a canned cycle, the restart is over the n-th drilled hole of the cycle, counted from 1; 0: the restart
/// is before the block.
///   returns  nullopt if the program does not reach the target; Session::state() tells how the session ended
std::optional<Restart> restart_at(Session& session, Stepping& stepping, const StopPoint& target, std::uint32_t hole = 0);
/// Returns the state that a restart before the next block requires; nullopt if the session is not held before a block.
std::optional<Restart> restart_here(Session& session, const Stepping& stepping);

/// Executes the next block (before which the session is held) until the tool is over the n-th drilled hole of the block's canned cycle,
/// counted from 1. Then stores in `restart` the modes and the position that are in force.
///   returns  false if the cycle has fewer holes
bool move_over_hole(Session& session, Stepping& stepping, std::uint32_t hole, Restart& restart);

/// A mode, tool, offset or variable whose present value differs from the value that the restart requires.
struct Difference {
  std::optional<InForce> required;  // required value; nullopt: the variable must not have a value, but has one
  std::optional<InForce> now;       // present value; nullopt: the variable has no value
};
/// Returns all differences between `required` and `now`, first those of the items in `required`, in the same order. `now`: what is in force
/// at the machine.
std::vector<Difference> differences(const std::vector<InForce>& required, const std::vector<InForce>& now);

/// A straight motion of the path to the block. Its end is in machine coordinates, mm or degrees.
struct WayPoint {
  bool rapid = true;
  AxisMask named = 0;
  Axes machine{};
  double feed = 0;  // feed, mm/min; 0 for a rapid
};
struct WayRules {
  double clearance = 0;  // safe height along the tool axis above which nothing obstructs the tool, work coordinates, mm
  double above = 2;      // height above the position of the restart, mm; from this height on the tool descends at feed
  double feed = 100;     // feed of the last part of the descent, mm/min
};
/// Computes the path to the block, in three parts: up to the clearance (safe height), sideways over the target, and down to the target. The
/// last part of the descent is at feed. Motions of zero length are omitted.
std::vector<WayPoint> path_there(const ToolPosition& from, const Restart& to, const WayRules& rules, std::size_t axes);

/// Converts the path to the work coordinates in force at the block, as restart_blocks() needs it. At least one of the blocks names the
/// tool's axis, so that the tool length offset becomes effective.
///   pre  the coordinate system is not rotated (no G68), since words along the axes could not express the path in rotated coordinates
std::vector<BlockMove> in_work_coordinates(const std::vector<WayPoint>& path, const Restart& to, const ControlDef& def);

}  // namespace kadr
