// Selects the area of the workpiece that a close-up picture of a difference between two programs shows, and the direction of view. Used by
// compare/difference_plot; tested by tests/compare/difference_window_test.cpp.

#include "compare/difference_window.h"

#include <algorithm>
#include <array>

namespace kadr {
namespace {

// Greatest size of the area that a close-up shows, as a multiple of the distance between the two paths. In a larger area, the distance is
// hardly visible.
constexpr double max_times = 12;
// Size of the area in a close-up that shows the distance between the two paths well, as a multiple of this distance
constexpr double good_times = 6;
// Greatest size of the area that a close-up shows, as a fraction of the size of the whole part. A larger area shows no more detail than
// the picture of the whole part.
constexpr double little_part = 0.6;
constexpr double margin_part = 0.15;   // margin around what a close-up must show, as a fraction of the size of this area
constexpr double place_part = 0.06;    // size of the area around a single position in a close-up, as a fraction of the part's size
constexpr double least_window = 0.02;  // least size of the area that a close-up shows, mm
constexpr double page_size = 500;      // approximate size of a drawn view of the part, in units of the page

double greatest_of(Vec3 v) { return std::max({v.x, v.y, v.z}); }

/// Returns the direction of view that shows the distance between the two paths best. The visible size of the paths themselves counts half
/// as much.
View best_view(Vec3 apart, Vec3 size) {
  const double all = size.x + size.y + size.z, far = length(apart);
  View best = View::xy;
  double most = -1;
  for (const View view : {View::xy, View::xz, View::yz}) {
    const Vec2 sides = projected(view, size);
    const double value = (far > 0 ? length(projected(view, apart)) / far : 0) + (all > 0 ? 0.5 * (sides.x + sides.y) / all : 0);
    if (value > most + 1e-6) most = value, best = view;
  }
  return best;
}

}  // namespace

DifferenceWindow window_of(const Box& differing, Vec3 apart, Vec3 at, const Box& part) {
  DifferenceWindow window;
  window.box = differing;
  const Vec3 size = differing.most - differing.least;
  const double far = length(apart);
  window.view = best_view(apart, size);
  if (far > 0 && greatest_of(size) > max_times * far) {
    const double half = std::max(good_times * far, least_window) / 2;
    const Vec3 middle = at - 0.5 * apart;
    window.box = {middle - half * Vec3{1, 1, 1}, middle + half * Vec3{1, 1, 1}, false};
  }
  const double most = greatest_of(window.box.most - window.box.least);
  const double around = most > least_window ? margin_part * most : std::max(place_part * greatest_of(part.most - part.least), least_window);
  window.box = {window.box.least - around * Vec3{1, 1, 1}, window.box.most + around * Vec3{1, 1, 1}, false};
  window.closer = greatest_of(window.box.most - window.box.least) < little_part * greatest_of(part.most - part.least);
  window.finest = 0.5 * greatest_of(window.box.most - window.box.least) / page_size;
  return window;
}

}  // namespace kadr
