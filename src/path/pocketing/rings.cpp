// This file computes the rings of a pocket: closed passes at equal distances inside each other. A ring of level k is k steps (Job::step,
// mm) inside the boundary of the work area (Field::work). In a spiral outwards a ring is cut after the neighbouring rings that are one step
// farther in. In a spiral inwards a ring is cut before these rings.

#include <algorithm>

#include "base/tolerance.h"
#include "path/pocketing/milling_passes.h"

namespace kadr::area {
namespace {

constexpr std::size_t samples = 16;  // approximate number of edges of a ring at which its outer neighbours are searched for

struct Ring {
  Edges path;
  Bounds box;
  std::vector<std::size_t> inner;
};

double distance_to(const Edges& path, Vec2 p) {
  double least = 1e300;
  for (const Edge& e : path) least = std::min(least, distance(e, p));
  return least;
}

bool neighbours(const Ring& outer, const Ring& inner, double step) {
  if (!outer.box.near(inner.box, 2 * step)) return false;
  const std::size_t stride = 1 + inner.path.size() / samples;
  for (std::size_t i = 0; i < inner.path.size(); i += stride)
    for (const double part : {0.0, 0.5})
      if (distance_to(outer.path, at(inner.path[i], part)) < step * 1.001 + tol::area_cusp) return true;
  return false;
}

/// Returns an upper bound, mm, of the distance from the boundary of the work area to the innermost ring of the pocket: half the shorter
/// side of the box around the area.
double half_width(const Field& field) {
  Bounds box;
  for (const Edges& loop : field.work)
    for (const Edge& e : loop) box.take(e);
  return std::max(tol::area_cusp, 0.5 * std::min(box.most.x - box.least.x, box.most.y - box.least.y));
}

class RingTree {
 public:
  explicit RingTree(bool outwards) : outwards_(outwards) {}

  bool grow(const Field& field, const Job& job) {
    const double step = job.step, deepest = half_width(field);
    std::size_t first = 0;  // index of the first ring of the previous level
    for (std::size_t level = 0;; ++level) {
      const std::size_t here = rings_.size();
      if (job.watch.stop.requested()) return true;
      job.watch.report_progress(Stage::passes, std::min(1.0, step * static_cast<double>(level) / deepest));
      for (Edges& path : rings_at(field, step * static_cast<double>(level))) {
        Bounds box = bounds_of(path);
        rings_.push_back({std::move(path), box, {}});
        if (rings_.size() > max_passes) return false;
      }
      if (level == 0) roots_ = rings_.size();
      if (rings_.size() == here) return true;
      for (std::size_t outer = level == 0 ? here : first; outer < here; ++outer)
        for (std::size_t inner = here; inner < rings_.size(); ++inner)
          if (neighbours(rings_[outer], rings_[inner], step)) rings_[outer].inner.push_back(inner);
      first = here;
    }
  }

  Passes passes() {
    seen_.assign(rings_.size(), false);
    for (std::size_t root = 0; root < roots_; ++root) visit(root);
    // Some rings have no outer neighbour, so visit() has not reached them from the outermost rings. The loop starts at these rings.
    for (std::size_t i = roots_; i < rings_.size(); ++i) visit(i);
    return std::move(passes_);
  }

 private:
  /// Visits the rings that are connected with `root`, depth first. The function is not recursive, because there may be thousands of levels.
  void visit(std::size_t root) {
    // The current path in the tree. Each entry is a ring and the index of its inner ring that is visited next.
    std::vector<std::pair<std::size_t, std::size_t>> visiting;
    const auto enter = [&](std::size_t ring) {
      if (seen_[ring]) return;
      seen_[ring] = true;
      if (!outwards_) passes_.push_back({rings_[ring].path, true});
      visiting.emplace_back(ring, 0);
    };
    enter(root);
    while (!visiting.empty()) {
      auto& [ring, next] = visiting.back();
      if (next < rings_[ring].inner.size()) {
        enter(rings_[ring].inner[next++]);
        continue;
      }
      if (outwards_) passes_.push_back({rings_[ring].path, true});
      visiting.pop_back();
    }
  }

  bool outwards_;
  std::size_t roots_ = 0;
  std::vector<Ring> rings_;
  std::vector<bool> seen_;
  Passes passes_;
};

}  // namespace

Result<Passes> ring_passes(const Field& field, const Job& job) {
  RingTree tree(job.scheme == Scheme::spiral_out);
  if (!tree.grow(field, job)) return fail(alarm(AlarmId::mill_too_long, {}, double(max_passes)));
  return tree.passes();
}

}  // namespace kadr::area
