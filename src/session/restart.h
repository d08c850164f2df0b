#pragma once
// Restart in mid program: computes what must be in force before a block, how the present state differs from that, and the path to the
// block. All results are values that can be displayed, changed, written as blocks (out/program/restart_blocks) or executed line by line
// (Stepping::enter).

#include <optional>
#include <vector>

#include "action/in_force.h"
#include "out/program/restart_blocks.h"
#include "session/stepping.h"

namespace kadr {

/// The block where a program is to continue, and the state required there.
struct Restart {
  Origin at;                      // the block that is executed next
  std::vector<InForce> in_force;  // modes, tool, offsets and variables in force before that block
  ToolPosition stand;             // required tool position
  std::size_t normal = 2;         // index of the axis normal to the working plane; the tool approaches along it
};

/// Interprets the program without output, from the session's present position to the line, pass, call or condition of `target`. `hole`: if
/// the block drills with a canned cycle, the restart is over its n-th drilled hole, counted from 1; 0: before the block.
///   returns  nullopt if the target is not reached; the state of the session says why
std::optional<Restart> restart_at(Session& session, Stepping& stepping, const StopPoint& target, std::uint32_t hole = 0);
/// Returns what is required to continue from the block where the session is held; nullopt if the session is not held.
std::optional<Restart> restart_here(Session& session, const Stepping& stepping);

/// Executes the block before which the session is held, until the tool is over the n-th drilled hole of its canned cycle, counted from 1.
/// Then `restart` receives the state in force there.
///   returns  false if the cycle has fewer holes
bool move_over_hole(Session& session, Stepping& stepping, std::uint32_t hole, Restart& restart);

/// One item of the state that differs from what is required.
struct Difference {
  std::optional<InForce> wanted;  // required value; nullopt: the item (a variable) must not be set, but is
  std::optional<InForce> now;     // present value; nullopt: the item is not set
};
/// Returns the differences item by item, in the order of `wanted`. `now`: what is in force at the machine.
std::vector<Difference> differences(const std::vector<InForce>& wanted, const std::vector<InForce>& now);

/// A straight motion of the path to the block; its end in machine coordinates.
struct WayPoint {
  bool rapid = true;
  AxisMask named = 0;
  Axes machine{};
  double feed = 0;  // mm/min; used if the motion is not rapid
};
struct WayRules {
  double clearance = 0;  // coordinate along the normal axis above which nothing obstructs the tool; work coordinates, mm
  double above = 2;      // the last part of the descent, from this height over the target, is at feed; mm
  double feed = 100;     // mm/min
};
/// Computes the path to the block: up to the clearance, over the target, down to the target, the last part at feed. Motions of zero
/// length are omitted.
std::vector<WayPoint> way_there(const ToolPosition& from, const Restart& to, const WayRules& rules, std::size_t axes);

/// Converts the path to the work coordinates in force at the block, for restart_blocks(). At least one block names the tool's axis, so that
/// the tool length offset becomes effective.
///   pre  the coordinate system is not rotated (no G68), as no words could express the path then
std::vector<BlockMove> in_work_coordinates(const std::vector<WayPoint>& way, const Restart& to, const ControlDef& def);

}  // namespace kadr
