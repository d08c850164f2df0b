#pragma once
// Restart in mid program: computes what must be in force before a block, how the present state differs from that, and the path to the
// block. All results are values, which can be shown, changed, written as blocks (out/program/restart_blocks) or executed line by line
// (Stepping::enter).

#include <optional>
#include <vector>

#include "action/in_force.h"
#include "out/program/restart_blocks.h"
#include "session/stepping.h"

namespace kadr {

/// Where a program is to continue.
struct Restart {
  Origin at;                      // the block that comes next
  std::vector<InForce> in_force;  // before it
  ToolPosition stand;             // required tool position
  std::size_t normal = 2;         // axis normal to the plane, along which the tool approaches
};

/// Interprets silently from the session's present position to the target's line, pass, call or condition. If the block drills with a canned
/// cycle, `hole` selects the position over its n-th drilled hole, counted from 1 (0: before the block).
///   returns  nullopt if the target is not reached; the state of the session says why
std::optional<Restart> restart_at(Session& session, Stepping& stepping, const StopPoint& target, std::uint32_t hole = 0);
/// The session is held: returns what is required to continue from here. Returns nullopt if it is not held.
std::optional<Restart> restart_here(Session& session, const Stepping& stepping);

/// Executes the block that the session is held before, until the tool is over the n-th drilled hole of its canned cycle, counted from 1.
/// Sets in `restart` what is in force there.
///   returns  false if there are fewer holes
bool go_over_hole(Session& session, Stepping& stepping, std::uint32_t hole, Restart& restart);

/// One item that differs from what is required.
struct Difference {
  std::optional<InForce> wanted;  // nullopt: it is set and must not be (a variable)
  std::optional<InForce> now;     // nullopt: it is not set
};
/// `now`: what is in force at the machine. Returns the differences item by item, in the order of `wanted`.
std::vector<Difference> differences(const std::vector<InForce>& wanted, const std::vector<InForce>& now);

/// A straight motion of the path to the block, machine coordinates.
struct WayPoint {
  bool rapid = true;
  AxisMask named = 0;
  Axes machine{};
  double feed = 0;  // mm/min, if not rapid
};
struct WayRules {
  double clearance = 0;  // work coordinate along the normal above which nothing obstructs the tool, mm
  double above = 2;      // height over the target from which on it moves at feed, mm
  double feed = 100;     // mm/min
};
/// The path: up to the clearance, over the target, down to it, the last part at feed. Motions of zero length are left out.
std::vector<WayPoint> way_there(const ToolPosition& from, const Restart& to, const WayRules& rules, std::size_t axes);

/// The same path in the work coordinates in force there, for restart_blocks(). At least one block names the tool's axis.
///   pre  the frame is not rotated (no G68): else no words can express the path
std::vector<BlockWay> in_work_coordinates(const std::vector<WayPoint>& way, const Restart& to, const ControlDef& def);

}  // namespace kadr
