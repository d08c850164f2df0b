#pragma once
// Area milling: a zone, a tool, a scheme → the path of the tool's centre, layer by layer. spec/correctors 4.
// INFERRED, the figures of the source being lost: what 1 and 2 mean, how each plunge looks, which way each direction goes.

#include <functional>
#include <optional>

#include "base/result.h"
#include "base/stop.h"
#include "path/area/loops.h"

namespace kadr::area {

enum class Scheme : std::uint8_t {
  zigzag,               // ЗИГЗАГ
  zigzag_then_contour,  // 1ЗИГЗАГ: a pass along the boundary after it
  contour_then_zigzag,  // 2ЗИГЗАГ: before it
  spiral_out,           // СПИР: from the middle outwards, rings at equal distance
  spiral_in,            // АСПИР: from the boundary inwards
  comb,                 // ШТИП: passes in one direction, lifted return
  comb_then_contour,    // 1ШТИП
  contour_then_comb,    // 2ШТИП
};
enum class Direction : std::uint8_t { ccw, cw };  // of going round the zone: ПЧС, ЧС; ccw is climb milling along a wall (M3)
enum class Plunge : std::uint8_t {
  hole,        // ЗАСВ: straight down into a hole drilled before
  tangential,  // КАС: down beside the pass, and into it on an arc
  ramp,        // СПУСК: to and fro along the beginning of the pass, going down
};

enum class Stage : std::uint8_t { passes, path, verification };

/// Whoever waits for a path: may end it (alarm interrupted), and is told how far it is.
struct Watch {
  StopToken stop;
  std::function<void(Stage, double part)> show;
  void tell(Stage stage, double part) const {
    if (show) show(stage, part);
  }
};

/// What is wanted; mm, mm from the plane's zero for levels.
struct Job {
  double radius = 5;  // of the tool
  double allowance = 0;
  double step = 5;        // from pass to pass
  double top = 0;         // level of the material
  double depth = 1;       // below it
  double layer = 1;       // depth of a pass, at most
  double clearance = 5;   // above the top: where the tool moves freely
  double overrun = 2;     // of the tool's edge beyond open sides
  double angle = 0;       // of the rows to X, degrees
  double ramp_deg = 3;    // slope of the ramp
  double level_step = 0;  // mm: the least increment of the control's Z word; 0: any level can be said
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
  double bulge = 0;  // as of an Edge
};

/// How often the tool goes down into material not yet cut, and how.
struct Plunges {
  std::size_t ramps = 0;     // to and fro
  std::size_t helices = 0;   // round and round
  std::size_t straight = 0;  // into the material, of Plunge::tangential
  std::size_t drilled = 0;   // into holes drilled before
  std::size_t no_room = 0;   // of these: where a ramp was wanted
};

struct AreaPath {
  std::vector<Move> moves;  // the first one is at the clearance level
  std::vector<Vec2> holes;  // to be drilled before: Plunge::hole, and where a ramp has no room
  Plunges plunges;
  std::size_t layers = 0;
  std::size_t lifts = 0;   // within the layers
  std::size_t fields = 0;  // areas that the tool's centre can reach without lifting
  double step = 0;         // mm, as taken
};

/// The levels of the layers, from the top down; equal depths.
std::vector<double> levels_of(const Job& job);

/// The path through all zones.
///   alarms  tool_does_not_fit, mill_hole, mill_too_long, interrupted
Result<AreaPath> area_path(const std::vector<Zone>& zones, const Job& job);

/// The zone of a slot: what a disk of that radius sweeps along a line.
std::vector<Zone> slot_zones(const std::vector<Edges>& lines, double radius);

/// The path along a line, to and fro, for a slot as wide as the tool.
Result<AreaPath> slot_path(const std::vector<Edges>& lines, const Job& job);

}  // namespace kadr::area
