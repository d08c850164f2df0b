// SmoothPath, the corners that are rounded singly: sharp corners, and corners near a stop. Where several roundings overlap, their
// displacements add up. The roundings are then narrowed until no point of the path moves farther than the tolerance.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/vec.h"
#include "path/smooth/smooth_path.h"
#include "path/smooth/soft_corner.h"

namespace kadr {

/// Returns how far, mm, the single roundings move the path at the length s.
double SmoothPath::moved(double s, std::size_t around) const {
  std::array<double, max_axes> sum{};
  add_single_shifts(s, around, sum.data());
  double squares = 0;
  for (std::size_t a = 0; a < axes_; ++a) squares += sum[a] * sum[a];
  return std::sqrt(squares);
}

void SmoothPath::add_single_shifts(double s, std::size_t around, double* x) const {
  corners_near(s, around, reach_, [&](std::size_t i) {
    const Rounding& rounding = roundings_[i];
    const double part = std::fabs(s - at_[i]) * rounding.inverse;
    if (is_chained_[i] != 0 || !(part < 1)) return;
    const double g = width_[i] * rounding.shape->height(part);
    for (std::size_t a = 0; a < axes_; ++a) x[a] += bend_[i * axes_ + a] * g;
  });
}

/// Returns the greatest displacement, mm, that the roundings cause on one side of a vertex. The displacement is sampled as densely as the
/// rounding of this vertex requires, up to the end of this rounding or up to a neighbour that needs equally dense samples. Between that
/// position and the middle of the next piece there are only a few samples.
double SmoothPath::moved_near_vertex(std::size_t vertex, int side) const {
  constexpr int places = 6;   // number of samples between the vertex and the position of the greatest deviation to the outside
  constexpr int farther = 4;  // number of samples between this position and the middle of the next piece
  const double step = SoftCorner::of(turn_[vertex]).flank() * width_[vertex] / places, felt = (places + 1) * step;
  const std::size_t neighbour = side < 0 ? vertex - 1 : vertex;
  std::size_t next = side < 0 ? vertex - 1 : vertex + 1, piece = neighbour;
  double most = 0;
  for (int k = 1; k <= places + 1; ++k) {
    const double s = at_[vertex] + side * k * step;
    while (side * (s - at_[next]) > 0 && next > 0 && next + 1 < at_.size() && width_[next] > 2 * width_[vertex])
      side < 0 ? (--next, --piece) : (++next, ++piece);
    if (side * (s - at_[next]) > 0) break;
    most = std::max(most, moved(s, piece));
  }
  const double sampled_length = std::min(length_[neighbour] / 2, reach_) - felt;
  for (int k = 1; k <= farther && sampled_length > 0; ++k)
    most = std::max(most, moved(at_[vertex] + side * (felt + k * sampled_length / farther), neighbour));
  return most;
}

/// Returns true if another single rounding overlaps the rounding of this vertex.
bool SmoothPath::overlaps(std::size_t vertex) const {
  bool any = false;
  corners_near(at_[vertex], vertex, width_[vertex] + reach_, [&](std::size_t k) {
    any = any || (k != vertex && is_chained_[k] == 0 && std::fabs(at_[k] - at_[vertex]) < width_[k] + width_[vertex]);
  });
  return any;
}

/// Returns the fraction of the tolerance that a single rounding may use. Next to a chain of corners that are rounded together, a part of
/// the tolerance is reserved for the rounding of these corners.
double SmoothPath::share_alone(std::size_t vertex) const {
  constexpr double share_next_to_chain = 0.8;
  // Fraction of the tolerance. Corners that move the path by less than this fraction, even at the greatest width, are ignored.
  constexpr double faint = 0.02;
  bool any = false;
  corners_near(at_[vertex], vertex, width_[vertex] + widest, [&](std::size_t k) {
    any = any || (is_chained_[k] != 0 && widest * SoftCorner::of(turn_[k]).highest() * turn_[k] > faint * tolerance_[k]);
  });
  return any ? share_next_to_chain : 1;
}

void SmoothPath::look_at_roundings(std::size_t first) {
  roundings_.resize(at_.size());
  for (std::size_t i = first; i < at_.size(); ++i) {
    constexpr double none = std::numeric_limits<double>::infinity();
    if (is_chained_[i] == 0) roundings_[i] = {width_[i] > 0 ? 1 / width_[i] : none, &SoftCorner::of(turn_[i])};
  }
}

/// Narrows the roundings that move the path farther than the tolerance. Returns false if no rounding was narrowed.
bool SmoothPath::shrink(std::size_t first, std::size_t end) {
  // Relative tolerance for numerical errors. It is needed where several roundings together use exactly the tolerance.
  constexpr double rounding = 1e-9;
  // If the displacement exceeds the permitted displacement by less than this factor, the widths are reduced in small steps, so that the
  // most important roundings stay widest.
  constexpr double far_off = 1.3;
  // Fraction of the tolerance that the roundings may use at the sampled positions. The rest is a reserve for the positions between the
  // samples.
  constexpr double between = 0.99;
  // The widths are reduced until the displacement is this fraction of the permitted displacement, so that the iteration ends.
  constexpr double aim = 0.999;
  bool any = false;
  look_at_roundings(done_);
  factor_.assign(at_.size(), 1);
  for (const std::size_t i : marks_) {
    if (i < first || i >= end || is_chained_[i] != 0 || width_[i] == 0 || !overlaps(i))
      continue;  // A rounding that no other rounding overlaps is already as wide as the tolerance allows, so it is not narrowed.
    const double most = std::max({moved(at_[i], i), moved_near_vertex(i, -1), moved_near_vertex(i, 1)}),
                 allowed = between * tolerance_[i] * share_alone(i);
    if (most <= allowed * (1 + rounding)) continue;
    any = true;
    // The exponent is below 1, so each step is small, because several overlapping corners are narrowed at the same time.
    const double less = std::pow(aim * allowed / most, most > far_off * allowed ? 0.5 : 0.2);
    const double far = width_[i];
    corners_near(at_[i], i, 2 * reach_, [&](std::size_t k) {
      if (k >= done_ && std::fabs(at_[k] - at_[i]) < width_[k] + far) factor_[k] = std::min(factor_[k], less);
    });
  }
  if (any)
    for (std::size_t i = done_; i < at_.size(); ++i) width_[i] *= factor_[i];
  return any;
}

/// Returns the width, mm, that the tolerance allows if no other rounding overlaps.
double SmoothPath::width_alone(std::size_t vertex) const {
  // Fraction of the tolerance that is used on a curve. The rest is a reserve for the start and the end of the curve.
  constexpr double used = 0.9;
  const SoftCorner& shape = SoftCorner::of(turn_[vertex]);
  const double tolerance = tolerance_[vertex];
  if (!on_curve(vertex)) return tolerance / (shape.highest() * turn_[vertex]);
  const double length =
      // The roundings move the chords of a circle by curvature · w² · second_moment, where w is the width.
      (length_[vertex - 1] + length_[vertex]) / 2;
  return std::sqrt(used * tolerance * length / (shape.second_moment() * turn_[vertex]));
}

void SmoothPath::round_single_ones(std::size_t first, const StopToken& stop) {
  constexpr int max_rounds = 200;  // greatest number of iterations; overlapping roundings need ten to thirty
  for (const std::size_t i : marks_)
    if (i >= first && is_chained_[i] == 0) {
      width_[i] = turns_back(i) ? 0 : std::min({widest, room_[i], width_alone(i)});
      if (!on_curve(i)) width_[i] *= share_alone(i);
    }
  reach_ = 0;
  for (std::size_t i = 0; i < at_.size(); ++i)
    if (is_chained_[i] == 0) reach_ = std::max(reach_, width_[i]);
  if (reach_ == 0) return;
  look_at_roundings(0);
  for (int round = 0; round < max_rounds && !stop.requested() && shrink(first, at_.size() - 1); ++round) {
  }
}

}  // namespace kadr
