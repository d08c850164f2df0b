#pragma once
// ChainSums: computes how far the path moves if all corners of a chain of short straight pieces are rounded together. It uses running
// sums: the displacement at one position needs five look-ups, for any number of corners that affect the position.
//
// With one width W for all corners nearby, the rounded path is the polyline convolved with the pulse k_W of a gentle corner
// (path/smooth/soft_corner). k is piecewise linear with five nodes r_n: k(r) = Σ κ_n max(0, r − r_n), where κ_n is the change of slope at
// node n. P is the polyline, s the path length, s_i the path length at corner i, Δu_i the change of direction there. With y_n = s − r_n W
// and sums over the corners before y = y_n:
//
//   U = Σ Δu_i (y − s_i),  Q = Σ Δu_i (y − s_i)²,  C = Σ Δu_i (y − s_i)³
//   x″ = Σ_n κ_n/W² U(y_n);  x′ = P′ + Σ_n κ_n/(2W²) Q(y_n) − Σ_(s_i < s) Δu_i;  x = P + Σ_n κ_n/(6W²) C(y_n) − U(s)
//
// W may change slowly along the path; its derivatives then contribute to x′ and x″.

#include <array>
#include <cstddef>
#include <vector>

#include "base/double_lanes.h"
#include "base/vec.h"

namespace kadr {

/// The width of the roundings at a position, mm, and its derivatives with respect to the length.
struct WidthAt {
  double w = 0, w1 = 0, w2 = 0;
};

class ChainSums {
 public:
  explicit ChainSums(std::size_t axes) : axes_(axes), groups_((axes + group - 1) / group) {}

  /// The corners of the path: `at`: path length at each corner; `bend`: Δu of each corner, per axis; `is_chained`: whether the corner
  /// belongs to the chain.
  struct Corners {
    const std::vector<double>& at;
    const std::vector<double>& bend;
    const std::vector<char>& is_chained;
  };
  /// Discards the sums, because the corners have changed.
  void forget() { from_ = 1, to_ = 0; }

  /// Adds to `x` the displacement of the path at s, of each axis, mm.
  void move(const Corners& corners, double s, double width, double* x);
  /// Adds the displacement at s to `x`, and its first two derivatives to `x1` and `x2`.
  void move(const Corners& corners, double s, const WidthAt& width, double* x, double* x1, double* x2);

 private:
  static constexpr std::size_t group = 4;  // axes computed in parallel
  static constexpr std::size_t max_groups = (max_axes + group - 1) / group;
  static constexpr std::size_t nodes = 5;
  struct Sums {
    Four m0 = {}, m1 = {}, m2 = {}, m3 = {};  // sums over the corners: Σ Δu, Σ Δu s, Σ Δu s², Σ Δu s³
  };
  void reach(const Corners& corners, double s);
  const Sums* before(std::size_t node, double y);
  template <std::size_t Groups>
  void add_ways(double at, double width, double* x);

  std::size_t axes_, groups_;
  double from_ = 1, to_ = 0;               // the sums are valid for path lengths from from_ to to_
  double origin_ = 0;                      // path length that counts as 0 in the sums, so that their numbers stay small
  std::vector<double> at_;                 // path lengths of the corners; the last entry is infinite
  std::vector<Sums> sums_;                 // sums over the first 0, 1, 2, … corners, for each group of axes
  std::array<std::size_t, nodes> seen_{};  // number of corners before each node, at the position evaluated last
};

}  // namespace kadr
