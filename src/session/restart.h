#pragma once
// Restart in mid program: what must be in force before a block, what of it is otherwise now, and the way there. All values: to be shown,
// changed, written as blocks (out/program/restart_blocks) or carried out line by line (Stepping::enter).

#include <optional>
#include <vector>

#include "action/in_force.h"
#include "out/program/restart_blocks.h"
#include "session/stepping.h"

namespace kadr {

/// Where a program is to go on.
struct Restart {
  Origin at;                      // the block that comes next
  std::vector<InForce> in_force;  // before it
  ToolPosition stand;             // where the tool must be
  std::size_t normal = 2;         // axis of the plane's normal: along which the tool comes down
};

/// By silent interpretation from where the session stands to the target's line, pass, call, condition; `hole` of a cycle that the block
/// drills: over that one, counted from 1 (0: before the block).
///   returns  nothing: it is not reached; the session tells what came instead
std::optional<Restart> restart_at(Session& session, Stepping& stepping, const StopPoint& target, std::uint32_t hole = 0);
/// The session is held: what goes on from here.
std::optional<Restart> restart_here(Session& session, const Stepping& stepping);

/// Carries the block that it is held before out, until the tool is over the n-th hole of its cycle, counted from 1; `restart` gets what is
/// in force there.
///   returns  false: it has not so many
bool go_over_hole(Session& session, Stepping& stepping, std::uint32_t hole, Restart& restart);

/// Something that is not as it must be.
struct Difference {
  std::optional<InForce> wanted;  // nothing: it is set and must not be (a variable)
  std::optional<InForce> now;     // nothing: it is not set
};
/// `now`: what is in force where the machine stands. Thing by thing, in the order of `wanted`.
std::vector<Difference> differences(const std::vector<InForce>& wanted, const std::vector<InForce>& now);

/// A straight motion of the way there, machine coordinates.
struct WayPoint {
  bool rapid = true;
  AxisMask named = 0;
  Axes machine{};
  double feed = 0;  // mm/min, of those at feed
};
struct WayRules {
  double clearance = 0;  // work coordinate along the normal above which nothing is in the way, mm
  double above = 2;      // mm over the place from which on it goes at feed
  double feed = 100;     // mm/min
};
/// Up to the clearance, over the place, down to it: the last way at feed. Motions of no length are left out.
std::vector<WayPoint> way_there(const ToolPosition& from, const Restart& to, const WayRules& rules, std::size_t axes);

/// The same in the work coordinates that are in force there, for restart_blocks(); one block at least names the axis of the tool.
///   pre  the frame is not turned (no G68): else no words say them
std::vector<BlockWay> in_work_coordinates(const std::vector<WayPoint>& way, const Restart& to, const ControlDef& def);

}  // namespace kadr
