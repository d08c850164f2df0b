#pragma once
// Contours: drawings ↔ edges. DXF, SVG, or the small text format of docs/commands/mill.md. What the edges enclose: path/area/loops.

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/alarm.h"
#include "base/vec.h"

namespace kadr {

/// A line or an arc of a contour, mm.
struct Edge {
  Vec2 from;
  Vec2 to;
  double bulge = 0;        // tangent of a quarter of the swept angle, counter-clockwise positive; 0: a line; at most 1: half a circle
  bool open = false;       // a side without a wall: the tool may run over it
  std::uint32_t line = 0;  // of the file; 0: not of a file
  friend bool operator==(const Edge&, const Edge&) = default;
};

struct ContourFault {
  Alarm alarm;
  std::uint32_t line = 0;  // of the file, from 1; 0: of the whole
};

using Edges = std::vector<Edge>;
using ContourResult = tl::expected<Edges, ContourFault>;

inline tl::unexpected<ContourFault> contour_fault(std::uint32_t line, const Alarm& alarm) {
  return tl::unexpected<ContourFault>(ContourFault{alarm, line});
}

namespace limits {
inline constexpr std::size_t contour_bytes = 16u << 20;  // of a file
inline constexpr std::size_t contour_edges = 20'000;     // the geometry after takes time with each
inline constexpr double contour_reach = 100'000;         // mm from the origin; no milling machine is larger
}  // namespace limits

/// The edges of a drawing in the order of the file; arcs in pieces of at most half a circle.
///   text     DXF if its first pair is one, SVG if it begins with '<', else the text format
///   alarms   contour_syntax, contour_unit, contour_empty, contour_too_large, value_out_of_range
ContourResult read_contour(std::string_view text);

ContourResult read_contour_dxf(std::string_view text);
ContourResult read_contour_svg(std::string_view text);
ContourResult read_contour_text(std::string_view text);

/// What the readers build edges with; holds the limits.
class EdgeList {
 public:
  void line(Vec2 from, Vec2 to);
  /// The arc with a bulge of any size (DXF).
  void bulged(Vec2 from, Vec2 to, double bulge);
  /// Arc around `centre`, from angle to angle in degrees, counter-clockwise if `to` is the greater.
  void arc(Vec2 centre, double radius, double from_deg, double to_deg);
  /// The same with its ends as they stand in the file, that neighbours meet exactly.
  void arc_between(Vec2 from, Vec2 to, Vec2 centre, bool ccw);
  void at(std::uint32_t line) { line_ = line; }
  void open(bool is) { open_ = is; }
  /// No more edges are taken: there are too many, or one is wrong.
  bool full() const { return failed_; }
  /// The edges, or what keeps them from being a contour.
  ContourResult take();

 private:
  void add(const Edge& edge);

  Edges edges_;
  std::uint32_t line_ = 0;
  bool open_ = false;
  ContourFault fault_;
  bool failed_ = false;
};

}  // namespace kadr
