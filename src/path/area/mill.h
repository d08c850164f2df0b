#pragma once
// Area milling (pockets and slots): computes the path of the tool's centre from a zone, a tool and a scheme, layer by layer.
// spec/correctors 4. INFERRED, as the figures of the source are lost: the meaning of 1 and 2, the shape of each plunge, the sense of each
// direction.

#include <functional>
#include <optional>

#include "base/result.h"
#include "base/stop.h"
#include "path/area/loops.h"

namespace kadr::area {

enum class Scheme : std::uint8_t {
  zigzag,               // ЗИГЗАГ
  zigzag_then_contour,  // 1ЗИГЗАГ: then a pass along the boundary
  contour_then_zigzag,  // 2ЗИГЗАГ: the pass along the boundary first
  spiral_out,           // СПИР: from the middle outwards, equidistant rings
  spiral_in,            // АСПИР: from the boundary inwards
  comb,                 // ШТИП: passes in one direction, return lifted
  comb_then_contour,    // 1ШТИП
  contour_then_comb,    // 2ШТИП
};
enum class Direction : std::uint8_t { ccw, cw };  // of travel round the zone: ПЧС, ЧС; ccw is climb milling along a wall (M3)
enum class Plunge : std::uint8_t {
  hole,        // ЗАСВ: straight down into a predrilled hole
  tangential,  // КАС: down next to the pass, and into it along an arc
  ramp,        // СПУСК: down a ramp, to and fro along the start of the pass
};

enum class Stage : std::uint8_t { passes, path, verification };

/// The caller's control over a long computation: it can stop it (alarm interrupted) and is informed of the progress.
struct Watch {
  StopToken stop;
  std::function<void(Stage, double part)> show;
  void tell(Stage stage, double part) const {
    if (show) show(stage, part);
  }
};

/// The parameters of the task; lengths in mm, levels in mm from the zero of the plane.
struct Job {
  double radius = 5;  // of the tool
  double allowance = 0;
  double step = 5;        // distance between passes
  double top = 0;         // surface level of the material
  double depth = 1;       // below the top
  double layer = 1;       // greatest depth of one layer
  double clearance = 5;   // above the top: level for free movement
  double overrun = 2;     // of the tool's edge over open sides
  double angle = 0;       // of the rows against X, degrees
  double ramp_deg = 3;    // slope of the ramp
  double level_step = 0;  // mm: the least increment of the control's Z word; 0: any level is possible
  Scheme scheme = Scheme::spiral_out;
  Direction direction = Direction::ccw;
  Plunge plunge = Plunge::ramp;
  std::optional<Vec2> hole;
  Watch watch;
};

enum class MoveKind : std::uint8_t { rapid, feed, plunge };  // plunge: at the plunge feed

/// A straight move, or an arc in the plane XY.
struct Move {
  MoveKind kind = MoveKind::rapid;
  Vec3 to;
  double bulge = 0;  // as for an Edge
};

/// How often, and how, the tool goes down into uncut material.
struct Plunges {
  std::size_t ramps = 0;     // to and fro
  std::size_t helices = 0;   // along a helix
  std::size_t straight = 0;  // straight into the material, for Plunge::tangential
  std::size_t drilled = 0;   // into predrilled holes
  std::size_t no_room = 0;   // number of those that replace a ramp
};

struct AreaPath {
  std::vector<Move> moves;  // the first one is at the clearance level
  std::vector<Vec2> holes;  // to be drilled before: for Plunge::hole, and where a ramp has no room
  Plunges plunges;
  std::size_t layers = 0;
  std::size_t lifts = 0;   // within the layers
  std::size_t fields = 0;  // areas within which the tool's centre moves without lifting
  double step = 0;         // mm, as used
};

/// Returns the levels of the layers, from the top down, with equal depths.
std::vector<double> levels_of(const Job& job);

/// Computes the path through all zones.
///   alarms  tool_does_not_fit, mill_hole, mill_too_long, interrupted
Result<AreaPath> area_path(const std::vector<Zone>& zones, const Job& job);

/// Returns the zone of a slot: the area that a disk of that radius sweeps along the lines.
std::vector<Zone> slot_zones(const std::vector<Edges>& lines, double radius);

/// Computes the path along the lines, to and fro, for a slot as wide as the tool.
Result<AreaPath> slot_path(const std::vector<Edges>& lines, const Job& job);

}  // namespace kadr::area
