// Compares the intervals of the material with the intervals of the part, line by line. Used by stock/part/part_compare.

#include "stock/part/brick_difference.h"

#include <algorithm>

namespace kadr {
namespace {

// Least length in mm of a segment; shorter segments are ignored, because both ends are accurate only to a micrometre.
constexpr double least_length = 1e-3;

/// Collects the intervals of material on a lattice line, in ascending order.
void take_material(const BrickLines& lines, std::int32_t line, std::vector<LineSegment>& material) {
  material.clear();
  if (lines.from[line] < lines.to[line])
    material.push_back({line, double(lines.from[line]), double(lines.to[line]), lines.from_by[line], lines.to_by[line]});
  for (const FurtherInterval& f : lines.further)
    if (f.line == line && f.from < f.to) material.push_back({line, double(f.from), double(f.to), f.from_by, f.to_by});
  std::sort(material.begin(), material.end(), [](const LineSegment& a, const LineSegment& b) { return a.from < b.from; });
}

void put(std::vector<LineSegment>& to, const LineSegment& segment) {
  if (segment.to - segment.from > least_length) to.push_back(segment);
}

/// Collects the segments of a lattice line with material outside the wanted part.
void take_left_on(const std::vector<LineSegment>& material, const std::vector<LineRange>& part, std::vector<LineSegment>& left_on) {
  for (const LineSegment& m : material) {
    LineSegment rest = m;
    for (const LineRange& p : part) {
      if (p.to <= rest.from || p.from >= rest.to) continue;
      LineSegment before = rest;
      before.to = p.from, before.to_by = before.from_by;
      put(left_on, before);
      rest.from = p.to, rest.from_by = rest.to_by;
    }
    put(left_on, rest);
  }
}

/// Collects the segments of a lattice line that are inside the wanted part but contain no material. Each end of such a segment gets the
/// number of the sweep that cut the material next to this end.
void take_gouged(const std::vector<LineSegment>& material, const std::vector<LineRange>& part, std::int32_t line,
                 std::vector<LineSegment>& gouged) {
  for (const LineRange& p : part) {
    LineSegment rest{line, p.from, p.to, of_blank, of_blank};
    for (const LineSegment& m : material) {
      if (m.to <= rest.from) {
        rest.from_by = m.to_by;
        continue;
      }
      if (m.from >= rest.to) {
        rest.to_by = m.from_by;
        break;
      }
      LineSegment before = rest;
      before.to = m.from, before.to_by = m.from_by;
      put(gouged, before);
      rest.from = m.to, rest.from_by = m.to_by;
    }
    put(gouged, rest);
  }
}

}  // namespace

void take_difference(const Brick* brick, bool is_full, const PartLines& part, const BrickAt& at, BrickDifference& difference) {
  const double edge = at.cell * brick_edge;
  for (int family = 0; family < 3; ++family) {
    LineDifference& found = difference.family[std::size_t(family)];
    found.left_on.clear(), found.gouged.clear();
    for (std::int32_t line = 0; line < brick_lines; ++line) {
      difference.part.clear();
      for (const LineRange& r : part.of(at.place, family, line)) {
        const LineRange within{std::max(r.from - along(at.corner, family), 0.0), std::min(r.to - along(at.corner, family), edge)};
        if (within.from < within.to) difference.part.push_back(within);
      }
      if (brick != nullptr) take_material(brick->family[std::size_t(family)], line, difference.material);
      else difference.material.assign(is_full ? 1 : 0, {line, 0, edge, of_blank, of_blank});
      take_left_on(difference.material, difference.part, found.left_on);
      take_gouged(difference.material, difference.part, line, found.gouged);
    }
  }
}

}  // namespace kadr
