#pragma once
// PrimalDual: the least time along a path in cells (motion/least_time/timed_path.h), by a primal-dual interior-point method that may
// start outside the limits. Eight cells are computed in parallel (base/lanes.h), with results that are bit-identical on all processors.
//
// Each limit ±c ≤ 1 has a slack s = 1 ∓ c of its own, and a dual z; s z = μ, μ → 0 (Nocedal, Wright: Numerical Optimization, 19). It is
// fast for these reasons:
//
//   - The jerk is |L| ≤ J/√b with L linear in b. J/√b is convex, so its tangent lies below it: a step within the tangent is within the
//     limit.
//   - Every slack and every dual has a step length of its own, and b makes the full step: one tight spot does not shorten the step of the
//     whole window. The next step corrects the errors that this causes.
//   - After some steps over all cells, only those blocks of eight cells continue that have not converged, and some blocks around them.
//   - Limits are checked at three positions of a cell, afterwards at sixteen more; where a limit is exceeded, the limits of the cell are
//     tightened by the excess, and its block continues.

#include <array>
#include <cstddef>
#include <vector>

#include "base/lanes.h"
#include "base/stop.h"
#include "motion/least_time/timed_path.h"

namespace kadr {

class PrimalDual {
 public:
  ///   returns  false if some blocks did not converge within the limits; speeds() are then of no use; `stop` may end the search early
  bool solve(const TimedPath& path, const PathEnds& ends, StopToken stop = {});

  const std::vector<CellSpeeds>& speeds() const { return speeds_; }
  /// The middle ordinates of the solution, one per cell.
  const std::vector<double>& middles() const { return middles_; }
  /// Work done: steps over all cells, or over as many single blocks.
  double steps() const { return steps_; }

 private:
  static constexpr std::size_t places = 3;     // positions in a cell where its limits are checked: its ends and its middle
  static constexpr std::size_t pad = lanes;    // dummy cells before the first and after the last cell, which fill up the blocks
  static constexpr std::size_t per_axis = 34;  // numbers per moving axis in each cell, in the rows below
  // per position: x′, x″, x‴ divided by the jerk limit
  static constexpr std::size_t shape_row(std::size_t place) { return place * 3; }
  // per position: slacks +, −, duals +, −
  static constexpr std::size_t jerk_row(std::size_t place) { return 9 + place * 4; }
  // for the middle and the end only: the acceleration is continuous
  static constexpr std::size_t acceleration_row(std::size_t place) { return 17 + place * 4; }
  static constexpr std::size_t polynomial_row = 29;

  static constexpr LimitMargins margins{0.996, 0.995};
  static constexpr double at_rest = 0.005;                  // relative step of a middle ordinate, below which it has converged
  static constexpr double most_beyond = 0.005;              // greatest excess over a limit with its margin, at the positions checked
  static constexpr double most_gap = 3;                     // greatest slack · dual of the limits of a cell, as a share of their μ
  static constexpr double allowed = 1;                      // greatest share of a limit
  static constexpr double most_fall = -0.7, most_rise = 2;  // bounds of the relative change of a middle ordinate in one step

  /// The numbers kept for each cell; a block stores eight of each in a row.
  enum Row : std::size_t {
    length,
    inverse,     // 1 / length
    limited,     // 1: the limits of the cell count; 0: next to a stop, or a dummy cell
    before,      // weights in the ordinate at its start: of the previous middle ordinate,
    own_before,  // of its own,
    given,       // and the constant part
    behind,      // weights in the ordinate at its end: of the next middle ordinate,
    own_behind,  // of its own
    inverse_cap,
    cap_slack,
    cap_dual,
    rows
  };

  /// Cells whose speed is being solved, in whole blocks; the cells at the borders are fixed, except at stops.
  struct Range {
    std::size_t first, end;  // blocks
    bool from_stop, to_stop;
  };
  template <class Lanes>
  struct BlockSpeed;
  template <class Lanes>
  struct Pairs;
  template <class Lanes>
  struct PlaceSums;
  template <class Lanes>
  struct OrdinateSums;
  struct Progress {
    double worst = 1, step = 0;  // least slack before the step; greatest relative step
    double gap = 0;              // slack · dual of a cell's limits, as a share of the value it should have
    bool is_quiet() const { return step <= at_rest && worst >= -most_beyond && gap <= most_gap; }
    /// True if nothing more will change. Needed where an earlier solution gives a start that is very near its limits.
    bool stands() const { return step < 0.2 * at_rest && worst > 1 - allowed / margins.jerk; }
  };
  struct Moving {
    std::size_t axis;
    double ratio;  // jerk limit / acceleration limit
    double by_jerk;
  };

  bool prepare();
  void find_moving();
  void mix();
  void keep_polynomials();
  void guess();
  double seconds() const;
  void fill();
  void begin(const Range& range, double mu);
  void derive(const Range& range, double mu);
  bool newton(const Range& range);
  Progress go(const Range& range, double mu);
  double greatest_share(const Range& range, int tighter);
  template <class Lanes>
  KADR_LANES void fill_shapes();
  template <class Lanes>
  KADR_LANES void begin_duals(const Range& range, double mu);
  template <class Lanes>
  KADR_LANES void build(const Range& range, double mu);
  template <class Lanes>
  KADR_LANES void gather(const Range& range);
  template <class Lanes>
  KADR_LANES Progress update(const Range& range, double mu);
  template <class Lanes>
  KADR_LANES void move(const Range& range);
  template <class Lanes>
  KADR_LANES double look(const Range& range, int tighter);
  void factor(std::size_t first, std::size_t end);
  std::size_t merge_turns(std::size_t first, std::size_t end);
  void spread_turns(std::size_t first, std::size_t end, std::size_t variables);
  bool step(const Range& range, double mu, Progress& progress);
  bool settle(double mu);
  bool settle_range(Range& range, double mu);
  Range widened(const Range& range, std::size_t by) const;
  void lower(const Range& range);
  void hand_over();

  double* row(std::size_t block, Row which) { return cells_.data() + (block * rows + which) * lanes; }
  const double* row(std::size_t block, Row which) const { return cells_.data() + (block * rows + which) * lanes; }
  double& of_cell(std::size_t cell, Row which) { return row((cell + pad) / lanes, which)[(cell + pad) % lanes]; }
  double of_cell(std::size_t cell, Row which) const { return row((cell + pad) / lanes, which)[(cell + pad) % lanes]; }
  float* of_axis(std::size_t block, std::size_t axis) { return limits_.data() + (block * moving_.size() + axis) * per_axis * lanes; }
  double limits_of_cell() const { return 1 + 2 * static_cast<double>(moving_.size() * (2 * places - 1)); }

  const TimedPath* path_ = nullptr;
  const PathEnds* ends_ = nullptr;
  StopToken stop_;
  std::size_t n_ = 0;           // cells
  std::size_t blocks_end_ = 0;  // blocks 1 … blocks_end_ − 1 contain cells
  std::vector<Moving> moving_;
  std::vector<double> cells_;                    // rows of each block
  std::vector<float> limits_;                    // of each block and moving axis
  std::vector<double> m_, step_, gradient_;      // one per cell, with padding before and after
  std::array<std::vector<double>, 6> products_;  // of each cell: its matrix elements, by pairs of the middle ordinates before, own, after
  std::array<std::vector<double>, 3> slopes_;    // of each cell: its part of the gradient, likewise
  std::array<std::vector<double>, 3> diagonals_;
  std::vector<double> tied_;                 // of each cell after a reversal: its middle ordinate as a share of the one before; else 0
  bool turns_ = false;                       // true if the path has reversals
  std::vector<char> restless_;               // blocks that have not converged
  double first_share_ = 0, last_share_ = 0;  // middle ordinates next to stops, as shares of their neighbours'
  std::vector<double> middles_;
  std::vector<CellSpeeds> speeds_;
  double steps_ = 0;
};

}  // namespace kadr
