#include "path/contour_watch.h"

#include <algorithm>
#include <utility>

#include "base/tolerance.h"

namespace kadr {

const ContourWatch::Seen& ContourWatch::Ring::add(const ContourElement& element, double radius, const Origin& origin) {
  const std::size_t i = count++ % reach;
  at[i] = {PlanePiece::of(element), radius, origin};
  least_x[i] = at[i].piece.least.x;
  least_y[i] = at[i].piece.least.y;
  most_x[i] = at[i].piece.most.x;
  most_y[i] = at[i].piece.most.y;
  return at[i];
}

template <class Found>
void ContourWatch::Ring::near(const PlanePiece& piece, double distance, const Found& found) const {
  const Vec2 least{piece.least.x - distance, piece.least.y - distance}, most{piece.most.x + distance, piece.most.y + distance};
  for (std::size_t i = 0; i < size(); ++i) {
    const bool apart = (least_x[i] > most.x) | (most_x[i] < least.x) | (least_y[i] > most.y) | (most_y[i] < least.y);
    if (!apart) found(at[i]);
  }
}

void ContourWatch::contour(const ContourElement& element, double radius, const Origin& origin) {
  const Seen& seen = contour_.add(element, radius, origin);
  path_.near(seen.piece, radius, [&](const Seen& path) { compare(seen, path); });
}

void ContourWatch::path(const ContourElement& way, double radius, const Origin& origin) {
  const Seen& seen = path_.add(way, radius, origin);
  contour_.near(seen.piece, radius, [&](const Seen& contour) { compare(contour, seen); });
}

void ContourWatch::compare(const Seen& contour, const Seen& path) {
  const double radius = std::min(contour.radius, path.radius);  // a new D: the allowance changes on the way
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
