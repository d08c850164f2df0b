#include "path/contour_watch.h"

#include <algorithm>
#include <utility>

#include "base/tolerance.h"

namespace kadr {
namespace {

bool boxes_near(const Box2& a, const Box2& b, double distance) {
  const double x = std::max({a.least.x - b.most.x, b.least.x - a.most.x, 0.0});
  if (x >= distance) return false;
  const double y = std::max({a.least.y - b.most.y, b.least.y - a.most.y, 0.0});
  return x * x + y * y < distance * distance;
}

}  // namespace

const ContourWatch::Seen& ContourWatch::Ring::add(const ContourElement& element, double radius, const Origin& origin) {
  const std::size_t i = count % at.size(), group = i / group_size;
  at[i] = {PlanePiece::of(element), radius, origin, count++};
  if (i % group_size == 0) boxes[group] = at[i].piece.box;
  else boxes[group].take(at[i].piece.box.least), boxes[group].take(at[i].piece.box.most);
  return at[i];
}

template <class Found>
void ContourWatch::Ring::near(const PlanePiece& piece, double distance, const Found& found) const {
  const std::uint64_t filled = std::min<std::uint64_t>(count, at.size());
  for (std::size_t group = 0; group * group_size < filled; ++group) {
    if (!boxes_near(boxes[group], piece.box, distance)) continue;
    const std::uint64_t end = std::min<std::uint64_t>(filled, (group + 1) * group_size);
    for (std::size_t i = group * group_size; i < end; ++i)
      if (boxes_near(at[i].piece.box, piece.box, distance)) found(at[i]);
  }
}

std::uint64_t ContourWatch::contour(const ContourElement& element, double radius, const Origin& origin) {
  const Seen& seen = contour_.add(element, radius, origin);
  path_.near(seen.piece, radius, [&](const Seen& path) { compare(seen, path); });
  return seen.number;
}

void ContourWatch::path(const ContourElement& way, double radius, const Origin& origin, ContourSpan known) {
  const Seen& seen = path_.add(way, radius, origin);
  contour_.near(seen.piece, radius, [&](const Seen& contour) {
    if (contour.number < known.first || contour.number > known.last) compare(contour, seen);
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
