#pragma once
// ViewPiece: a segment of a tool path with some thousand vertices, in the form that the page receives (docs/panel-protocol.md, frames of
// kind 1, 2 and 4).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.h"

namespace kadr {

// Unit of the levels of detail in mm. Level 0 contains all vertices; at level 1 the path may deviate by twice this unit, and the permitted
// deviation doubles from level to level (docs/panel-protocol.md).
inline constexpr double finest_level = 0.001;

enum class PathKind : std::uint8_t { jump, rapid, feed, arc_cw, arc_ccw, probe, home, thread, spline };

/// A vertex of the path. All values describe the motion that ends at the vertex.
struct PathVertex {
  std::array<float, 3> at{};  // position in the coordinates of the picture, mm
  float time = 0;             // time in s, after ViewPiece::begins, at which the tool reaches the vertex
  std::uint32_t line = 0;
  std::uint32_t number = 0;  // number of the block (Origin::number)
  float feed = 0;            // programmed feed, mm/min; 0 for a rapid
  float speed = 0;           // mean speed of the motion, mm/min
  std::uint16_t tool = 0;    // number of the tool in the spindle
  std::uint16_t file = 0;    // number of the file that contains the block (Origin::file)
  PathKind kind = PathKind::jump;
  std::uint8_t level = 0;

  Vec3 place() const { return {double(at[0]), double(at[1]), double(at[2])}; }
};

struct ViewPiece {
  static constexpr std::size_t most = 8192;  // greatest number of vertices in a segment

  double begins = 0;        // time of the first vertex, s
  std::uint32_t first = 0;  // index of the first vertex in the whole path
  // Vertices of the segment; the first vertex repeats the last vertex of the previous segment.
  std::vector<PathVertex> vertices;
  std::vector<std::array<float, 3>> directions;  // direction of the tool at each vertex; empty if the tool is upright everywhere
  std::vector<float> positions;  // positions of the joints that turn the part, vertex by vertex; empty if the machine has no such joints

  std::size_t joints() const { return vertices.empty() ? 0 : positions.size() / vertices.size(); }
};

/// Sets the level of each vertex. A path without the vertices below level L deviates by at most 0.001 · 2^L mm. Vertices at which the tool,
/// the kind of motion, the feed or the file changes remain at every level.
///   law  the first and the last vertex remain at all levels
void set_levels(ViewPiece& piece);

/// Converts a segment to a binary frame of kind 1, which contains the vertices.
///   which  0: path of the program, 1: path of the program that it is compared with; plus 2 for the contour as programmed
std::string path_frame(const ViewPiece& piece, std::uint32_t which, std::uint32_t channel);
/// Converts a segment to a binary frame of kind 2, which contains the tool directions.
std::string directions_frame(const ViewPiece& piece, std::uint32_t which, std::uint32_t channel);
/// Converts a segment to a binary frame of kind 4, which contains the joint positions.
std::string positions_frame(const ViewPiece& piece, std::uint32_t which, std::uint32_t channel);

}  // namespace kadr
