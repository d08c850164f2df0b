// The interference check finds contour blocks whose compensated path is opposite to the programmed direction. Used by
// path/compensation/radius_compensation.

#include "path/compensation/interference.h"

#include <algorithm>

#include "base/tolerance.h"

namespace kadr {
namespace {

using Window = std::span<const CompensatedBlock>;

/// Returns true if the direction `compensated` has a component opposite to the direction `programmed` that exceeds rounding errors.
bool opposed(Vec2 programmed, Vec2 compensated) {
  return dot(programmed, compensated) < -tol::same_point * std::max(length(programmed), tol::same_point);
}

/// Returns true if the tool is too large for an arc, or if the tool's path along the arc has the opposite sense of rotation. INFERRED: for
/// arcs above half a circle the chords are not compared.
bool arc_turns_round(const ContourElement& arc, const CompensatedBlock& block, Vec2 end_vector) {
  const double inside = block.side * arc.sense() * block.radius;
  if (std::min(arc.start_radius, arc.end_radius) < inside - tol::same_point) return true;
  return compensated_turns(arc, block.start_vector, end_vector) * arc.sense() < -tol::same_angle;
}

/// Returns true if the path from the first junction to the junction after block `j` is opposite to the programmed direction.
bool interferes(Window window, std::size_t j) {
  const JunctionVectors &a = *window[0].end, &b = *window[j].end;
  if (a.count == 0 || b.count == 0) return j == 1;
  if (j == 1) {
    const CompensatedBlock& block = window[1];
    if (block.element->is_arc) return arc_turns_round(*block.element, block, b.first());
  }
  const Vec2 delta = window[j].element->to - window[0].element->to;
  return opposed(delta, delta + b.first() - a.last());
}

/// Returns the intersection of the lines a0–a1 and b0–b1; nullopt if they do not meet. End points belong to the lines.
std::optional<Vec2> crossing(Vec2 a0, Vec2 a1, Vec2 b0, Vec2 b1) {
  const Vec2 a = a1 - a0, b = b1 - b0;
  const double c = cross(a, b);
  if (c == 0) return std::nullopt;
  const double s = cross(b0 - a0, b) / c, t = cross(b0 - a0, a) / c;
  const auto within = [](double part, double whole) { return part * whole >= -tol::same_point && (part - 1) * whole <= tol::same_point; };
  if (!within(s, length(a)) || !within(t, length(b))) return std::nullopt;
  return a0 + s * a;
}

/// Executes steps 1 to 3 of NCT 15.5.7: joins the blocks at the point at which the paths around the two corners cross.
std::optional<ContourJoin> join_at_corners(Window window, std::size_t j) {
  const JunctionVectors &a = *window[0].end, &b = *window[j].end;
  const Vec2 p1 = window[0].element->to, p2 = window[j].element->to, delta = p2 - p1;
  for (std::size_t q = 1; q < a.count && q < b.count; ++q) {
    const std::size_t i = a.count - 1U - q;
    if (opposed(delta, delta + b.at[q] - a.at[i])) continue;
    const auto x = crossing(p1 + a.at[i], p1 + a.at[i + 1], p2 + b.at[q - 1], p2 + b.at[q]);
    if (!x) continue;  // INFERRED: without an intersection the interference is not resolved.
    ContourJoin join{j + 1, {}, b.last()};
    for (std::size_t k = 0; k <= i; ++k) join.vectors.add(a.at[k]);
    join.vectors.add(*x - p1);
    for (std::size_t k = q; k < b.count; ++k) join.vectors.add(p2 + b.at[k] - p1);
    return join;
  }
  return std::nullopt;
}

/// Executes step 4 of NCT 15.5.7: joins the blocks at the point at which the offset of the first block meets the offset of the block after
/// `j`.
std::optional<ContourJoin> join_by_offsets(Window window, std::size_t j) {
  const CompensatedBlock &first = window[0], &next = window[j + 1];
  if (!first.plain || !next.plain || first.side != next.side) return std::nullopt;
  const Vec2 point = first.element->to;
  OffsetElement beyond = offset_at_start(*next.element, first.radius, next.side);
  // The offset line is given relative to `point`, so its distance is corrected for an element that does not start there.
  beyond.distance += dot(beyond.normal, next.element->from - point);
  const auto meet = intersection(offset_at_end(*first.element, first.radius, first.side), beyond, point);
  if (!meet) return std::nullopt;
  return ContourJoin{j + 1, single(*meet), point + *meet - next.element->from};
}

/// Returns true if the block after the join would go backwards. Returns false if the end of this block is unknown, or if the block ends
/// compensation.
bool turns_next(Window window, const ContourJoin& join) {
  CompensatedBlock next = window[join.next];
  if (!next.plain || next.end == nullptr || next.end->count == 0) return false;
  next.start_vector = join.start_vector;
  return moves_backwards(next);
}

}  // namespace

bool moves_backwards(const CompensatedBlock& block) {
  const ContourElement& e = *block.element;
  const Vec2 end = block.end->first();
  if (e.is_arc) return arc_turns_round(e, block, end);
  const Vec2 delta = e.to - e.from;
  return opposed(delta, delta + end - block.start_vector);
}

std::optional<ContourJoin> check_interference(Window window, std::size_t further, bool always_alarm) {
  if (window.size() < 3) return ContourJoin{};
  const std::size_t last = std::min(further + 1, window.size() - 2);
  std::size_t farthest = 0;
  for (std::size_t j = 1; j <= last; ++j)
    if (interferes(window, j)) farthest = j;
  if (farthest == 0) return ContourJoin{};
  if (always_alarm) return std::nullopt;
  for (std::size_t j = farthest; j <= last; ++j) {
    std::optional<ContourJoin> join;
    if (j == farthest && window[0].end->count != 0 && window[j].end->count != 0) join = join_at_corners(window, j);
    if (!join) join = join_by_offsets(window, j);
    if (join && !turns_next(window, *join)) return join;
  }
  return std::nullopt;
}

}  // namespace kadr
