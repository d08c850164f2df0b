#pragma once
// This file computes the path of the tool's centre for area milling (pockets and slots), layer by layer, from a zone, a tool and a scheme:
// spec/correctors 4. INFERRED, because the drawings of the source are lost: the meaning of the prefixes 1 and 2 in the names, the shape of
// each plunge, and the sense of rotation of each direction.

#include <functional>
#include <optional>

#include "base/result.h"
#include "base/stop_token.h"
#include "path/pocketing/closed_loops.h"

namespace kadr::area {

enum class Scheme : std::uint8_t {
  zigzag,               // scheme ЗИГЗАГ: rows that are cut back and forth
  zigzag_then_contour,  // scheme 1ЗИГЗАГ: zigzag rows, then a pass along the boundary
  contour_then_zigzag,  // scheme 2ЗИГЗАГ: a pass along the boundary, then zigzag rows
  spiral_out,           // scheme СПИР: equidistant rings from the middle outwards
  spiral_in,            // scheme АСПИР: equidistant rings from the boundary inwards
  comb,                 // scheme ШТИП: rows that are all cut in the same direction; the tool returns above the material
  comb_then_contour,    // scheme 1ШТИП: comb rows, then a pass along the boundary
  contour_then_comb,    // scheme 2ШТИП: a pass along the boundary, then comb rows
};
// The direction of travel around the zone: counter-clockwise (ПЧС) or clockwise (ЧС). With M3 (spindle clockwise), `ccw` is climb milling
// along a wall.
enum class Direction : std::uint8_t { ccw, cw };
enum class Plunge : std::uint8_t {
  hole,        // plunge ЗАСВ: the tool moves straight down into a predrilled hole
  tangential,  // plunge КАС: the tool moves down next to the pass, and then into the pass along an arc
  ramp,        // plunge СПУСК: the tool moves down a ramp, back and forth along the start of the pass
};

enum class Stage : std::uint8_t { passes, path, verification };

/// The link between a long computation and its caller. The caller can stop the computation (alarm interrupted) and receives its progress.
struct Watch {
  StopToken stop;
  std::function<void(Stage, double part)> show;
  void report_progress(Stage stage, double part) const {
    if (show) show(stage, part);
  }
};

/// The parameters of the milling task. Lengths are in mm; levels are Z values in mm.
struct Job {
  double radius = 5;      // tool radius
  double allowance = 0;   // thickness of the material that is left on the walls
  double step = 5;        // distance between passes
  double top = 0;         // Z level of the material's surface
  double depth = 1;       // depth of the pocket below the level `top`
  double layer = 1;       // greatest depth of one layer, mm
  double clearance = 5;   // height of the level for rapid motion above the level `top`
  double overrun = 2;     // how far the circumference of the tool moves beyond open sides
  double angle = 0;       // angle between the zigzag or comb rows and the X axis, degrees
  double ramp_deg = 3;    // slope of the plunge ramp, degrees
  double level_step = 0;  // the least increment of the control's Z word, mm; 0: the control can express any level
  Scheme scheme = Scheme::spiral_out;
  Direction direction = Direction::ccw;
  Plunge plunge = Plunge::ramp;
  std::optional<Vec2> hole;
  Watch watch;
};

// The kind of a move of the tool; `plunge` is a downward move at the plunge feed.
enum class MoveKind : std::uint8_t { rapid, feed, plunge };

/// A straight move, or an arc in the XY plane, that starts at the end of the previous move.
struct Move {
  MoveKind kind = MoveKind::rapid;
  Vec3 to;
  double bulge = 0;  // the shape of an arc as Edge defines it (bulge); 0 for a straight move
};

/// The number of plunges into uncut material, by the type of the plunge.
struct Plunges {
  std::size_t ramps = 0;     // number of plunges back and forth along a ramp
  std::size_t helices = 0;   // plunges along a helix
  std::size_t straight = 0;  // number of vertical plunges into the material, for Plunge::tangential
  std::size_t drilled = 0;   // plunges into predrilled holes
  std::size_t no_room = 0;   // plunges into predrilled holes at positions where a ramp has no clearance
};

struct AreaPath {
  std::vector<Move> moves;  // the moves in their order; the first move is at the clearance level
  std::vector<Vec2> holes;  // Holes to drill before milling: for Plunge::hole, and at positions where a ramp has no clearance.
  Plunges plunges;
  std::size_t layers = 0;
  std::size_t lifts = 0;   // number of times the tool is lifted within a layer
  std::size_t fields = 0;  // number of areas (Field) within which the tool's centre can move without a lift
  double step = 0;         // distance between neighbouring passes that the computation used, mm
};

/// Returns the Z levels of the layers from the top down. All layers have the same depth.
std::vector<double> levels_of(const Job& job);

/// Computes the path through all zones.
///   alarms  tool_does_not_fit, mill_hole, mill_too_long, interrupted
Result<AreaPath> area_path(const std::vector<Zone>& zones, const Job& job);

/// Returns the zones of a slot: the area that a disk with the radius `radius`, mm, sweeps along the centre lines.
std::vector<Zone> slot_zones(const std::vector<Edges>& lines, double radius);

/// Computes the path back and forth along the centre lines, for a slot whose width is the tool's diameter.
Result<AreaPath> slot_path(const std::vector<Edges>& lines, const Job& job);

}  // namespace kadr::area
