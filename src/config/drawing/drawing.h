#pragma once
// Reads contours from drawings as lists of edges. A drawing is DXF, SVG, or the small text format of docs/commands/mill.md.
// path/pocketing/closed_loops determines the areas that the edges enclose.

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/alarm.h"
#include "base/vec.h"

namespace kadr {

/// An edge: a line or an arc of a contour; coordinates in mm.
struct Edge {
  Vec2 from;
  Vec2 to;
  // Bulge of the edge: the tangent of a quarter of the angle that the arc sweeps, positive if the arc is counter-clockwise. It is 0 for a
  // straight line and ±1 for a semicircle. Its absolute value is at most 1, because the readers split an arc of more than a semicircle.
  double bulge = 0;
  bool open = false;       // true if the edge has no wall, so that the tool may cross it
  std::uint32_t line = 0;  // line number of the edge in the file; 0: the edge is not from a file
  friend bool operator==(const Edge&, const Edge&) = default;
};

struct DrawingFault {
  Alarm alarm;
  std::uint32_t line = 0;  // line number of the fault in the file, from 1; 0: the fault concerns the whole file
};

using Edges = std::vector<Edge>;
using DrawingResult = tl::expected<Edges, DrawingFault>;

inline tl::unexpected<DrawingFault> drawing_fault(std::uint32_t line, const Alarm& alarm) {
  return tl::unexpected<DrawingFault>(DrawingFault{alarm, line});
}

namespace limits {
inline constexpr std::size_t drawing_bytes = 16u << 20;  // greatest size of a drawing file, bytes
inline constexpr std::size_t drawing_edges = 20'000;  // greatest number of edges, because each edge costs time in the computation of areas
inline constexpr double contour_reach = 100'000;      // greatest distance of a point from the origin, mm; no milling machine is larger
}  // namespace limits

/// Reads the edges of a drawing in the order of the file. An arc of more than a semicircle is split into several edges.
///   text     DXF if it starts with a DXF pair, SVG if it starts with '<', else the text format
///   alarms   contour_syntax, contour_word_missing, contour_unit, contour_radius, contour_reach, contour_empty, contour_too_large
DrawingResult read_drawing(std::string_view text);

DrawingResult read_dxf(std::string_view text);
DrawingResult read_svg(std::string_view text);
DrawingResult read_drawing_text(std::string_view text);

/// Collects the edges that a reader (DXF, SVG, text format) finds, and checks their number and coordinates.
class EdgeList {
 public:
  void line(Vec2 from, Vec2 to);
  /// Adds an arc of a DXF file, whose bulge may be greater than 1.
  void bulged(Vec2 from, Vec2 to, double bulge);
  /// Adds an arc around `centre` between two angles in degrees. The arc is counter-clockwise if `to_deg` is greater than `from_deg`.
  void arc(Vec2 centre, double radius, double from_deg, double to_deg);
  /// Adds an arc whose end points are exactly `from` and `to`, so that neighbouring edges meet exactly.
  void arc_between(Vec2 from, Vec2 to, Vec2 centre, bool ccw);
  void at(std::uint32_t line) { line_ = line; }
  void open(bool is) { open_ = is; }
  /// Returns true if the list accepts no more edges, because there are too many or one was invalid.
  bool full() const { return failed_; }
  /// Returns the edges, or an alarm with the reason why they are no contour.
  DrawingResult take();

 private:
  void add(const Edge& edge);

  Edges edges_;
  std::uint32_t line_ = 0;
  bool open_ = false;
  DrawingFault fault_;
  bool failed_ = false;
};

}  // namespace kadr
