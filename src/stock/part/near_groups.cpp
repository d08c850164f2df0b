// Sorts triangles into groups by halving the list repeatedly. Used by stock/part/nearest_triangle.

#include "stock/part/near_groups.h"

#include <algorithm>
#include <limits>

#include "base/thread.h"
#include "stock/stock.h"

namespace kadr {
namespace {

constexpr std::ptrdiff_t worth_a_thread = 1 << 12;  // number of triangles; a shorter list is sorted without another thread

struct Middle {
  float at[3];  // sum of the three corners of a triangle, that is, three times its centre, mm
  std::uint32_t triangle;
};

int longest_axis(const Middle* first, const Middle* last) {
  constexpr float far = std::numeric_limits<float>::max();
  float least[3] = {far, far, far}, most[3] = {-far, -far, -far};
  for (const Middle* p = first; p != last; ++p)
    for (int d = 0; d < 3; ++d) least[d] = std::min(least[d], p->at[d]), most[d] = std::max(most[d], p->at[d]);
  int axis = 0;
  for (int d = 1; d < 3; ++d)
    if (most[d] - least[d] > most[axis] - least[axis]) axis = d;
  return axis;
}

/// Sorts the triangles so that each group of `group` consecutive triangles, and each smaller group inside this group, is compact.
void arrange(Middle* first, Middle* last, std::size_t group, GroupSizes sizes, int threads) {
  const auto count = std::size_t(last - first);
  while (group >= count && group > sizes.smallest) group /= sizes.times;
  if (count <= group) return;
  const std::size_t groups = (count + group - 1) / group;
  Middle* const middle = first + groups / 2 * group;
  const auto before = [](int axis) { return [axis](const Middle& a, const Middle& b) { return a.at[axis] < b.at[axis]; }; };
  std::nth_element(first, middle, last, before(longest_axis(first, last)));
  if (threads < 2 || last - first < worth_a_thread) {
    arrange(first, middle, group, sizes, 1), arrange(middle, last, group, sizes, 1);
    return;
  }
  run_parallel(2, [&](int half) {
    half == 0 ? arrange(first, middle, group, sizes, (threads + 1) / 2) : arrange(middle, last, group, sizes, threads / 2);
  });
}

}  // namespace

std::vector<std::uint32_t> near_groups(const Mesh& mesh, GroupSizes sizes, int threads) {
  std::vector<Middle> all(mesh.triangle_count());
  for (std::size_t t = 0; t < all.size(); ++t) {
    all[t].triangle = std::uint32_t(t);
    for (std::size_t d = 0; d < 3; ++d) {
      float sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += mesh.points[3 * std::size_t(mesh.triangles[3 * t + k]) + d];
      all[t].at[d] = sum;
    }
  }
  std::size_t group = sizes.smallest;
  while (group < all.size()) group *= sizes.times;
  arrange(all.data(), all.data() + all.size(), group, sizes, threads);
  std::vector<std::uint32_t> order(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) order[i] = all[i].triangle;
  return order;
}

}  // namespace kadr
