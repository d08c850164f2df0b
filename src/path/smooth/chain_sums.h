#pragma once
// ChainSums: how the corners of a chain of short straight pieces move the path where all are rounded together, by running sums: at a place
// five look-ups, however many corners are felt there.
//
// With one width W for all corners around, the rounded path is the polyline convolved with the pulse k_W of a gentle corner
// (path/smooth/soft_corner). k is piecewise linear with five nodes r_n: k(r) = Σ κ_n max(0, r − r_n). So with y_n = s − r_n W and sums over
// the corners before y_n, at s_i, of bend Δu_i,
//
//   U = Σ Δu_i (y − s_i),  Q = Σ Δu_i (y − s_i)²,  C = Σ Δu_i (y − s_i)³
//   x″ = Σ_n κ_n/W² U(y_n);  x′ = P′ + Σ_n κ_n/(2W²) Q(y_n) − Σ_(s_i < s) Δu_i;  x = P + Σ_n κ_n/(6W²) C(y_n) − U(s)
//
// W may change slowly along the path: its derivatives come to x′ and x″.

#include <array>
#include <cstddef>
#include <vector>

#include "base/lanes.h"
#include "base/vec.h"

namespace kadr {

/// How wide corners are rounded at a place, mm, and its derivatives by the length.
struct WidthAt {
  double w = 0, w1 = 0, w2 = 0;
};

class ChainSums {
 public:
  explicit ChainSums(std::size_t axes) : axes_(axes), groups_((axes + group - 1) / group) {}

  /// The corners of the path: lengths, bends (of each axis), which of them are of the chain.
  struct Corners {
    const std::vector<double>& at;
    const std::vector<double>& bend;
    const std::vector<char>& is_chained;
  };
  /// Other corners from here on.
  void forget() { from_ = 1, to_ = 0; }

  /// By how much the path is moved at s, of each axis, mm: added to `x`.
  void move(const Corners& corners, double s, double width, double* x);
  /// The same with derivatives.
  void move(const Corners& corners, double s, const WidthAt& width, double* x, double* x1, double* x2);

 private:
  static constexpr std::size_t group = 4;  // axes side by side
  static constexpr std::size_t max_groups = (max_axes + group - 1) / group;
  static constexpr std::size_t nodes = 5;
  struct Sums {
    Four m0 = {}, m1 = {}, m2 = {}, m3 = {};  // Σ Δu, Σ Δu s, Σ Δu s², Σ Δu s³
  };
  void reach(const Corners& corners, double s);
  const Sums* before(std::size_t node, double y);
  template <std::size_t Groups>
  void add_ways(double at, double width, double* x);

  std::size_t axes_, groups_;
  double from_ = 1, to_ = 0;               // for places between it is ready
  double origin_ = 0;                      // lengths are counted from here: the sums stay small
  std::vector<double> at_;                 // of the corners; a last one that is never reached
  std::vector<Sums> sums_;                 // over the first 0, 1, 2, … corners, of each group of axes
  std::array<std::size_t, nodes> seen_{};  // corners before each node, at the last place
};

}  // namespace kadr
