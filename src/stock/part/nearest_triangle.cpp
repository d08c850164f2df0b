// Builds and searches a tree of three types of elements: blocks of four triangles, nodes with the boxes of eight blocks, and nodes with the
// boxes of eight nodes. Used by stock/part/part_compare.

#include "stock/part/nearest_triangle.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "base/thread.h"
#include "stock/cut/float_lanes.h"
#include "stock/part/four_triangles.h"
#include "stock/part/near_groups.h"
#include "stock/stock.h"

namespace kadr {
namespace {

constexpr std::uint32_t of_blocks = std::uint32_t{1} << 31;
constexpr float nowhere = 1e30f;
// Numerical error of the point, of the box and of their difference, as a fraction of the greatest coordinate.
constexpr float rounding_of_places = 0x1p-21f;
constexpr double more_than_rounding = 1 + 4e-6;  // factor for the error of a squared distance in single precision
constexpr double hair_squared = 1e-18;           // mm² added to a squared distance, so that a distance of 0 has a margin too
constexpr std::size_t nodes_at_once = 1024;

/// Returns a limit for squared distances of boxes, which have the error of single precision. A box beyond this limit contains no triangle
/// nearer than the squared distance `square`, so the search may skip the box.
double limit_of(double square) { return square * more_than_rounding + hair_squared; }

}  // namespace

/// Fills a node of the lowest level, and the blocks of triangles of this node.
void NearestTriangle::put_blocks(const Mesh& mesh, const std::vector<std::uint32_t>& order, std::size_t number) {
  Node& node = nodes_[number];
  node.first_child = of_blocks | std::uint32_t(number * width);
  for (std::size_t c = 0; c < width; ++c) {
    const std::size_t b = number * width + c;
    float least[3] = {nowhere, nowhere, nowhere}, most[3] = {-nowhere, -nowhere, -nowhere};
    for (std::size_t lane = 0; b < blocks_.size() && lane < in_block; ++lane) {
      const std::size_t t = order[std::min(b * in_block + lane, order.size() - 1)];
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t d = 0; d < 3; ++d) {
          const float place = mesh.points[3 * std::size_t(mesh.triangles[3 * t + k]) + d];
          blocks_[b].corner[k][d][lane] = place;
          least[d] = std::min(least[d], place - pad_), most[d] = std::max(most[d], place + pad_);
        }
    }
    for (std::size_t d = 0; d < 3; ++d) node.least[d][c] = least[d], node.most[d][c] = most[d];
  }
}

/// Fills a node of a higher level, whose children are nodes.
void NearestTriangle::put_boxes(std::size_t number, std::size_t first_child, std::size_t last_child) {
  Node& node = nodes_[number];
  node.first_child = std::uint32_t(first_child);
  for (std::size_t c = 0; c < width; ++c)
    for (std::size_t d = 0; d < 3; ++d) {
      const Node* const below = first_child + c < last_child ? &nodes_[first_child + c] : nullptr;
      node.least[d][c] = below == nullptr ? nowhere : *std::min_element(below->least[d], below->least[d] + width);
      node.most[d][c] = below == nullptr ? -nowhere : *std::max_element(below->most[d], below->most[d] + width);
    }
}

NearestTriangle::NearestTriangle(const Mesh& mesh, int threads) {
  float farthest = 0;
  for (const float place : mesh.points) farthest = std::max(farthest, std::fabs(place));
  pad_ = farthest * rounding_of_places;
  const std::vector<std::uint32_t> order = near_groups(mesh, {in_block, width}, threads);
  const auto groups = [](std::size_t count) { return (count + width - 1) / width; };
  blocks_.resize((order.size() + in_block - 1) / in_block);
  std::size_t level = groups(blocks_.size()), all = level;
  for (std::size_t above = level; above > 1;) all += above = groups(above);
  nodes_.resize(all);
  std::atomic<std::size_t> next{0};
  run_parallel(threads, [&](int) {
    for (std::size_t first; (first = nodes_at_once * next++) < level;)
      for (std::size_t i = first; i < std::min(first + nodes_at_once, level); ++i) put_blocks(mesh, order, i);
  });
  for (std::size_t first = 0; level > 1;) {
    const std::size_t last = first + level;
    level = groups(level);
    for (std::size_t i = 0; i < level; ++i) put_boxes(last + i, first + i * width, last);
    first = last;
  }
}

/// A search for the triangle nearest to one point. Triangles are tested four at a time; up to three triangles wait until there are four.
class NearestTriangle::Search {
 public:
  Search(const NearestTriangle& tree, const Vec3& point, std::uint32_t hint) : tree_(tree), point_(point), nearest_(hint) {
    for (int d = 0; d < 3; ++d) place_[d] = Quad{} + float(along(point, d));
    const std::uint32_t block = hint / in_block;
    double square[4];
    squares_to_all(tree_.blocks_[block], point_, square);
    for (std::uint32_t i = 0; i < in_block; ++i) take(block * in_block + i, square[i]);
    limit_ = float(limit_of(square_));
    began_ = of_blocks | block;
  }
  void all();
  double square() const { return square_; }
  std::uint32_t nearest() const { return nearest_; }

 private:
  using Quad = lanes::Quad;
  struct Waiting {
    float square;
    std::uint32_t child;
  };
  Quad squares_to(const Quad (&least)[3], const Quad (&most)[3]) const;
  void fetch(std::uint32_t child) const;
  void open(const Node& node);
  void look_at(std::uint32_t block);
  template <std::size_t count>
  void ask(const std::uint32_t (&triangle)[count]);
  void take(std::uint32_t triangle, double square) {
    if (square < square_) square_ = square, nearest_ = triangle;
  }

  const NearestTriangle& tree_;
  Vec3 point_;
  Quad place_[3];
  double square_ = 1e300;
  float limit_ = 0;
  std::uint32_t nearest_, began_ = 0;
  std::uint32_t asked_for_[3 + in_block];
  int count_ = 0;  // number of triangles that wait in asked_for_
  int waiting_ = 0;
  // Nodes that wait for the search. The tree has at most 11 levels, because 2³¹ triangles are divided by eight at each level, and at most
  // seven nodes wait at each level.
  Waiting stack_[128];
};

/// Returns the squared distances in mm² of the point from four boxes.
inline lanes::Quad NearestTriangle::Search::squares_to(const Quad (&least)[3], const Quad (&most)[3]) const {
  const Quad none{};
  Quad sum{};
  for (int d = 0; d < 3; ++d) {
    const Quad below = least[d] - place_[d], above = place_[d] - most[d];
    Quad off = below > above ? below : above;
    off = off > none ? off : none;
    sum += off * off;
  }
  return sum;
}

/// Tests two or four triangles, which are given by their numbers in blocks_.
template <std::size_t count>
inline void NearestTriangle::Search::ask(const std::uint32_t (&triangle)[count]) {
  OneOfFour all[count];
  for (std::size_t i = 0; i < count; ++i) all[i] = {&tree_.blocks_[triangle[i] / in_block], triangle[i] % in_block};
  double square[count];
  squares_to_triangles(all, point_, square);
  for (std::size_t i = 0; i < count; ++i) take(triangle[i], square[i]);
  limit_ = float(limit_of(square_));
}

/// Tests the triangles of a block whose own boxes are close enough to the point.
inline void NearestTriangle::Search::look_at(std::uint32_t block) {
  const auto& corner = tree_.blocks_[block].corner;
  Quad least[3], most[3];
  for (int d = 0; d < 3; ++d) {
    const auto at = [&](int k) { return *reinterpret_cast<const Quad*>(corner[k][d]); };
    const Quad a = at(0), b = at(1), c = at(2), low = a < b ? a : b, high = a < b ? b : a;
    least[d] = (low < c ? low : c) - tree_.pad_, most[d] = (high < c ? c : high) + tree_.pad_;
  }
  const Quad sum = squares_to(least, most);
  const float limit = limit_;
  int count = count_;
  for (std::uint32_t i = 0; i < in_block; ++i) {
    asked_for_[count] = block * in_block + i;
    count += int(sum[i] <= limit);
  }
  count_ = count < 4 ? count : count - 4;
  if (count < 4) return;
  const std::uint32_t* const last = asked_for_ + count_;
  ask<4>({last[0], last[1], last[2], last[3]});
}

/// Prefetches into the processor's cache a child of a node that the search will visit soon.
inline void NearestTriangle::Search::fetch(std::uint32_t child) const {
  constexpr std::size_t cache_line = 64;
  const bool is_block = (child & of_blocks) != 0;
  const char* const at =
      is_block ? reinterpret_cast<const char*>(&tree_.blocks_[child & ~of_blocks]) : reinterpret_cast<const char*>(&tree_.nodes_[child]);
  for (std::size_t line = 0; line < sizeof(FourTriangles); line += cache_line) __builtin_prefetch(at + line);
}

/// Puts the children of a node that are close enough onto the stack. The processor cannot predict which children are close enough. So all
/// children are written to the stack without a branch, and the next child overwrites a child that is too far away. The counter is a local
/// variable, because the compiler must assume that the writes could change a member.
inline void NearestTriangle::Search::open(const Node& node) {
  const int first = waiting_;
  const float limit = limit_;
  int waiting = first;
  for (std::size_t half = 0; half < width; half += 4) {
    Quad least[3], most[3];
    for (int d = 0; d < 3; ++d)
      least[d] = *reinterpret_cast<const Quad*>(node.least[d] + half), most[d] = *reinterpret_cast<const Quad*>(node.most[d] + half);
    const Quad sum = squares_to(least, most);
    for (std::size_t i = 0; i < 4; ++i) {
      stack_[waiting] = {sum[i], node.first_child + std::uint32_t(half + i)};
      waiting += int(sum[i] <= limit);
    }
  }
  waiting_ = waiting;
  for (int i = first; i < waiting; ++i) fetch(stack_[i].child);
  if (waiting < first + 2) return;
  int nearest = first;
  for (int i = first + 1; i < waiting; ++i) nearest = stack_[i].square < stack_[nearest].square ? i : nearest;
  std::swap(stack_[nearest], stack_[waiting - 1]);  // the swap puts the nearest child on top of the stack, so the search visits it first
}

void NearestTriangle::Search::all() {
  open(tree_.nodes_.back());
  while (waiting_ > 0) {
    const Waiting next = stack_[--waiting_];
    if (next.square > limit_ || next.child == began_) continue;
    if ((next.child & of_blocks) != 0) look_at(next.child & ~of_blocks);
    else open(tree_.nodes_[next.child]);
  }
  if (count_ == 0) return;
  for (int i = count_; i < 4; ++i) asked_for_[i] = asked_for_[0];
  const std::uint32_t two[2] = {asked_for_[0], asked_for_[1]}, four[4] = {two[0], two[1], asked_for_[2], asked_for_[3]};
  count_ > 2 ? ask(four) : ask(two);
}

double NearestTriangle::distance(const Vec3& point, std::uint32_t& hint) const {
  Search search(*this, point, hint);
  search.all();
  hint = search.nearest();
  return std::sqrt(search.square());
}

}  // namespace kadr
