#pragma once
// ChainSums computes how far the path moves if all corners of a chain of short straight pieces are rounded together. It uses running sums.
// The displacement at one position therefore needs only five look-ups, whatever the number of corners that affect the position.
//
// If all corners nearby have the same width W, the rounded path is the polyline convolved with the pulse k_W of a gentle corner
// (path/smooth/soft_corner). The pulse k is piecewise linear with five nodes r_n: k(r) = Σ κ_n max(0, r − r_n), where κ_n is the change of
// slope at node n. P is the polyline, s the path length, s_i the path length at corner i, and Δu_i the change of direction at this corner.
// With y_n = s − r_n W and sums over the corners before y = y_n:
//
//   U = Σ Δu_i (y − s_i),  Q = Σ Δu_i (y − s_i)²,  C = Σ Δu_i (y − s_i)³
//   x″ = Σ_n κ_n/W² U(y_n);  x′ = P′ + Σ_n κ_n/(2W²) Q(y_n) − Σ_(s_i < s) Δu_i;  x = P + Σ_n κ_n/(6W²) C(y_n) − U(s)
//
// W may change slowly along the path. The derivatives of W then contribute to x′ and x″.

#include <array>
#include <cstddef>
#include <vector>

#include "base/double_lanes.h"
#include "base/vec.h"

namespace kadr {

/// The width of the roundings at a position, mm, and its first two derivatives with respect to the path length.
struct WidthAt {
  double w = 0, w1 = 0, w2 = 0;
};

class ChainSums {
 public:
  explicit ChainSums(std::size_t axes) : axes_(axes), groups_((axes + group - 1) / group) {}

  /// The corners of the path. `at` is the path length at each corner, mm. `bend` is Δu of each corner, with one entry per axis.
  /// `is_chained` is 1 if the corner belongs to a chain of corners that are rounded together.
  struct Corners {
    const std::vector<double>& at;
    const std::vector<double>& bend;
    const std::vector<char>& is_chained;
  };
  /// Discards the sums. Call it when the corners have changed.
  void forget() { from_ = 1, to_ = 0; }

  /// Adds to `x` the displacement of each axis at the path length s, mm.
  void move(const Corners& corners, double s, double width, double* x);
  /// Adds to `x` the displacement at the path length s, and to `x1` and `x2` the first two derivatives of the displacement.
  void move(const Corners& corners, double s, const WidthAt& width, double* x, double* x1, double* x2);

 private:
  static constexpr std::size_t group = 4;  // number of axes that are computed in parallel
  static constexpr std::size_t max_groups = (max_axes + group - 1) / group;
  static constexpr std::size_t nodes = 5;
  struct Sums {
    Four m0 = {}, m1 = {}, m2 = {}, m3 = {};  // sums over the corners: Σ Δu, Σ Δu s, Σ Δu s², Σ Δu s³
  };
  void reach(const Corners& corners, double s);
  const Sums* before(std::size_t node, double y);
  template <std::size_t Groups>
  void add_shifts(double at, double width, double* x);

  std::size_t axes_, groups_;
  double from_ = 1, to_ = 0;               // The sums are valid for path lengths from from_ to to_, in mm.
  double origin_ = 0;                      // The path length that counts as 0 in the sums. It keeps the numbers in the sums small.
  std::vector<double> at_;                 // path lengths of the corners; the last entry is infinite
  std::vector<Sums> sums_;                 // sums over the first 0, 1, 2, … corners, for each group of axes
  std::array<std::size_t, nodes> seen_{};  // number of corners before each node, at the last evaluated position
};

}  // namespace kadr
