#include "path/contour_watch.h"

#include <algorithm>
#include <utility>

#include "base/tolerance.h"

namespace kadr {
namespace {

bool overlap(const Box2& a, const Box2& b) {
  return a.least.x < b.most.x && b.least.x < a.most.x && a.least.y < b.most.y && b.least.y < a.most.y;
}

}  // namespace

template <class Found>
void ContourWatch::Ring::near(const PlanePiece& piece, double distance, const Found& found) const {
  const std::uint64_t filled = std::min<std::uint64_t>(count, at.size());
  const Vec2 margin{distance, distance};
  const Box2 around{piece.box.least - margin, piece.box.most + margin};
  for (std::size_t group = 0; group * group_size < filled; ++group) {
    if (!overlap(boxes[group], around)) continue;
    const std::uint64_t end = std::min<std::uint64_t>(filled, (group + 1) * group_size);
    for (std::size_t i = group * group_size; i < end; ++i)
      if (overlap(at[i].piece.box, around)) found(at[i]);
  }
}

std::uint64_t ContourWatch::contour(const ContourElement& element, double radius, const Origin& origin) {
  const Seen& seen = contour_.add([&] { return PlanePiece::of(element); }, radius, origin);
  path_.near(seen.piece, radius, [&](const Seen& path) { compare(seen, path); });
  return seen.number;
}

void ContourWatch::compare_path(const Seen& path, ContourSpan known) {
  contour_.near(path.piece, path.radius, [&](const Seen& contour) {
    if (contour.number < known.first || contour.number > known.last) compare(contour, path);
  });
}

void ContourWatch::compare(const Seen& contour, const Seen& path) {
  const double radius = std::min(contour.radius, path.radius);
  const double allowed = radius - tol::same_point - worst_.depth - contour.piece.slack - path.piece.slack;
  if (allowed <= 0) return;
  const double away = distance(contour.piece, path.piece);
  if (away < allowed) worst_ = {worst_.depth + allowed - away, path.origin, contour.origin.line};
}

std::optional<ContourCut> ContourWatch::end() {
  contour_.count = path_.count = 0;
  const ContourCut worst = std::exchange(worst_, {});
  if (worst.depth == 0) return std::nullopt;
  return worst;
}

}  // namespace kadr
