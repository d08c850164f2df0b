// This file computes the area that the tool cuts along its passes; many passes may overlap. Used by the other folders of path.

#include "path/pocketing/sweep.h"

#include <algorithm>
#include <span>

namespace kadr::area {
namespace {

constexpr std::size_t piece_corners = 32;  // greatest number of corners of a line; longer lines are divided into pieces

Polygons in_pieces(const Polygons& lines) {
  Polygons pieces;
  for (const Polygon& line : lines)
    for (std::size_t begin = 0; begin < line.size(); begin += piece_corners - 1) {
      const std::size_t end = std::min(line.size(), begin + piece_corners);
      if (begin > 0 && end - begin < 2) break;
      pieces.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(begin), line.begin() + static_cast<std::ptrdiff_t>(end));
    }
  return pieces;
}

class Sweep {
 public:
  Sweep(double radius, double chord, const Watch& watch, std::size_t count)
      : radius_(radius), chord_(chord), watch_(watch), count_(count) {}

  Polygons of(std::span<const Polygon> pieces) {
    if (pieces.empty() || watch_.stop.requested()) return {};
    std::size_t corners = 0;
    for (const Polygon& piece : pieces) corners += piece.size();
    if (pieces.size() == 1 || corners <= piece_corners) {
      watch_.report_progress(Stage::verification, static_cast<double>(done_ += pieces.size()) / static_cast<double>(count_));
      return swept({pieces.begin(), pieces.end()}, radius_, chord_);
    }
    const std::size_t half = pieces.size() / 2;
    const Polygons first = of(pieces.first(half));
    return joined(first, of(pieces.subspan(half)));
  }

 private:
  double radius_, chord_;
  const Watch& watch_;
  // number of all pieces of the tool's path, and number of the pieces whose area is computed, for the progress report
  std::size_t count_, done_ = 0;
};

}  // namespace

Polygons swept_all(const Polygons& lines, double radius, double chord, const Watch& watch) {
  const Polygons pieces = in_pieces(lines);
  return Sweep(radius, chord, watch, pieces.size()).of(pieces);
}

}  // namespace kadr::area
