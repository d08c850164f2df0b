// Merges the bricks of portions in the order of the whole lattice. Used by cli/cut_portion.

#include "stock/portion/joined_surface.h"

#include <algorithm>

namespace kadr {
namespace {

Vec3 vec(const std::array<float, 3>& p) { return {double(p[0]), double(p[1]), double(p[2])}; }

/// Returns the first point of the whole surface: that of the first brick with points.
Vec3 first_point(const std::vector<PortionEnd>& ends) {
  const auto first = std::min_element(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.first_brick < b.first_brick; });
  return first == ends.end() ? Vec3{} : vec(first->first_point);
}

}  // namespace

JoinedSurface join_surfaces(std::vector<PortionReader>& portions, const std::vector<PortionEnd>& ends, StlWriter* write) {
  JoinedSurface all;
  VolumeSum volume(first_point(ends));
  struct Next {
    PortionReader* reader;
    PortionBrick brick;
  };
  const auto later = [](const Next& a, const Next& b) { return a.brick.number > b.brick.number; };
  std::vector<Next> heap;
  for (PortionReader& reader : portions)
    if (Next next{&reader, {}}; reader.next(next.brick)) heap.push_back(std::move(next));
  std::make_heap(heap.begin(), heap.end(), later);
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), later);
    Next& next = heap.back();
    for (const PortionTriangle& stored : next.brick.triangles) {
      const Corners triangle{vec(stored.corners[0]), vec(stored.corners[1]), vec(stored.corners[2])};
      volume.add(triangle);
      const double area = area_of(triangle);
      all.area += area;
      if (stored.is_cut != 0) all.cut_area += area;
      if (write != nullptr) write->add(triangle);
    }
    all.triangles += next.brick.triangles.size();
    if (next.reader->next(next.brick)) std::push_heap(heap.begin(), heap.end(), later);
    else heap.pop_back();
  }
  all.volume = volume.volume();
  for (const PortionReader& reader : portions) all.sound = all.sound && reader.is_sound();
  return all;
}

}  // namespace kadr
