#pragma once
// ViewPiece: some thousand vertices of a path in the form for the page (docs/panel-protocol.md, frames of kind 1, 2 and 4).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.h"

namespace kadr {

inline constexpr double finest_level = 0.001;  // mm: level 0 omits nothing, level 1 may be off by twice this (docs/panel-protocol.md)

enum class PathKind : std::uint8_t { jump, rapid, feed, arc_cw, arc_ccw, probe, home, thread, spline };

/// The values describe the segment that ends at the vertex.
struct PathVertex {
  std::array<float, 3> at{};  // mm
  float time = 0;             // s since ViewPiece::begins
  std::uint32_t line = 0;
  std::uint32_t number = 0;  // Origin::number
  float feed = 0;            // as programmed, mm/min; 0 at rapid
  float speed = 0;           // mean over the motion, mm/min
  std::uint16_t tool = 0;    // in the spindle
  std::uint16_t file = 0;    // Origin::file
  PathKind kind = PathKind::jump;
  std::uint8_t level = 0;

  Vec3 place() const { return {double(at[0]), double(at[1]), double(at[2])}; }
};

struct ViewPiece {
  static constexpr std::size_t most = 8192;  // vertices

  double begins = 0;                             // s: time of its first vertex
  std::uint32_t first = 0;                       // index of its first vertex in the path
  std::vector<PathVertex> vertices;              // the first one repeats the last one of the previous piece
  std::vector<std::array<float, 3>> directions;  // of the tool at each vertex; empty: the tool is upright everywhere
  std::vector<float> positions;                  // of the joints that turn the part, vertex by vertex; empty: there are none

  std::size_t joints() const { return vertices.empty() ? 0 : positions.size() / vertices.size(); }
};

/// Sets the level of each vertex: without the vertices below level L the path is off by at most 0.001 · 2^L mm. Vertices where tool,
/// kind, feed or file change remain at every level.
///   law  the first and the last vertex remain at all levels
void set_levels(ViewPiece& piece);

/// A frame of kind 1.
///   which  0: the program, 1: what it is compared with; plus 2: the contour as programmed
std::string path_frame(const ViewPiece& piece, std::uint32_t which, std::uint32_t channel);
/// A frame of kind 2.
std::string directions_frame(const ViewPiece& piece, std::uint32_t which, std::uint32_t channel);
/// A frame of kind 4.
std::string positions_frame(const ViewPiece& piece, std::uint32_t which, std::uint32_t channel);

}  // namespace kadr
