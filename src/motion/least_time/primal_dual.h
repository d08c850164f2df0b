#pragma once
// PrimalDual finds the least time along a path in cells (motion/least_time/timed_path.h). It uses a primal-dual interior-point method whose
// first guess may violate the limits. Eight cells are computed in parallel (base/double_lanes.h); the results are bit-identical on all
// processors.
//
// Each limit is written as ±c ≤ 1, where c is an acceleration or jerk as a fraction of its limit. Each limit has its own slack s = 1 ∓ c
// and its own dual variable z. The method solves s z = μ for μ → 0 (Nocedal, Wright: Numerical Optimization, 19). The method is fast for
// these reasons:
//
//   - The jerk limit J is |L| ≤ J/√b, where b is the squared path speed and L is linear in b. The curve J/√b is convex and lies above its
//     tangent, so a step that stays below the tangent obeys the limit.
//   - Every slack and every dual variable has its own step length, and b always makes the full step. One cell near a limit therefore does
//     not shorten the step of the whole window. The next step corrects the resulting errors.
//   - After some steps over all cells, only blocks of eight cells that have not converged, and some blocks around them, are computed
//     further.
//   - Limits are checked at three positions of each cell, and after convergence at sixteen more. If a limit is exceeded at such a position,
//     the limits of the cell are tightened by the excess, and the block of the cell is solved again.

#include <array>
#include <cstddef>
#include <vector>

#include "base/double_lanes.h"
#include "base/stop_token.h"
#include "motion/least_time/timed_path.h"

namespace kadr {

class PrimalDual {
 public:
  ///   returns  false if some blocks did not converge within the limits or `stop` ended the search; speeds() is then not valid
  bool solve(const TimedPath& path, const PathEnds& ends, StopToken stop = {});

  const std::vector<CellSpeeds>& speeds() const { return speeds_; }
  /// The middle Bézier ordinates of b in the solution, one per cell.
  const std::vector<double>& middles() const { return middles_; }
  /// The work of the solver, as a number of steps over all cells. A step over some of the blocks counts as a fraction.
  double steps() const { return steps_; }

 private:
  static constexpr std::size_t places = 3;  // number of positions in a cell at which the solver checks limits: both ends and the middle
  // Number of dummy cells before the first cell and after the last cell of the path. They complete the blocks of eight cells that are
  // computed in parallel.
  static constexpr std::size_t pad = lanes;
  // Number of table rows that store the limits of one moving axis in a block of eight cells. The functions and constants below define what
  // each row stores.
  static constexpr std::size_t per_axis = 34;
  // Index of the first table row of the axis derivatives x′, x″ and x‴ at one position in the cell. Each derivative is divided by the jerk
  // limit.
  static constexpr std::size_t shape_row(std::size_t place) { return place * 3; }
  // Index of the first of four table rows of the jerk limit at one position in the cell: the slacks of the upper and the lower limit, and
  // the dual variables of the upper and the lower limit.
  static constexpr std::size_t jerk_row(std::size_t place) { return 9 + place * 4; }
  // Index of the first of four table rows of the acceleration limit at one position in the cell: slacks and dual variables, as for the jerk
  // limit. The start of a cell has no such rows: the acceleration is continuous, so the acceleration at the start equals the acceleration
  // at the end of the previous cell.
  static constexpr std::size_t acceleration_row(std::size_t place) { return 17 + place * 4; }
  static constexpr std::size_t polynomial_row = 29;

  static constexpr LimitMargins margins{0.996, 0.995};
  // The middle ordinate of a cell has converged when a Newton step changes it by less than this fraction.
  static constexpr double at_rest = 0.005;
  // The greatest accepted excess over a limit, as a fraction of the limit, at the positions where limits are checked. The limit that is
  // checked is already reduced by its margin.
  static constexpr double max_excess = 0.005;
  // The greatest accepted product of slack and dual variable of any limit in a cell, as a multiple of the barrier parameter μ.
  static constexpr double max_gap = 3;
  static constexpr double allowed = 1;                     // greatest accepted acceleration or jerk, as a fraction of its limit
  static constexpr double max_fall = -0.7, most_rise = 2;  // bounds of the relative change of a middle ordinate in one Newton step

  /// The numbers stored for each cell. Each of them is one table row of a block and has one number for each of the block's eight cells.
  enum Row : std::size_t {
    length,
    inverse,  // reciprocal of the length of the cell, 1/mm
    // Value 1: the acceleration and jerk limits of the cell apply. Value 0: these limits do not apply, because the cell is next to a stop
    // or is a dummy cell.
    limited,
    before,      // weight of the previous cell's middle ordinate in the squared speed b at the start of this cell
    own_before,  // weight of this cell's middle ordinate in the squared speed b at the start of this cell
    given,       // constant part of the squared speed b at the start of this cell
    next_after,  // weight of the next cell's middle ordinate in the squared speed b at the end of this cell
    own_after,   // weight of this cell's middle ordinate in the squared speed b at the end of this cell
    inverse_cap,
    cap_slack,
    cap_dual,
    rows
  };

  /// A range of blocks whose speeds are computed together. The cells outside the range keep their speeds; beyond a stop of the axes there
  /// are no further cells.
  struct Range {
    std::size_t first, end;  // block indices; `end` is the index after the last block
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
    // `worst` is the least slack before the Newton step; `step` is the greatest relative change of a middle ordinate in this step.
    double worst = 1, step = 0;
    double gap = 0;  // the greatest product of slack and dual variable of the limits of a cell, as a multiple of the barrier parameter μ
    bool is_quiet() const { return step <= at_rest && worst >= -max_excess && gap <= max_gap; }
    /// True if further steps would change nothing, so that the range counts as solved. This case occurs if the speed at the start comes
    /// from an earlier solution that is very near the limits.
    bool stands() const { return step < 0.2 * at_rest && worst > 1 - allowed / margins.jerk; }
  };
  struct Moving {
    std::size_t axis;
    double ratio;  // the axis' jerk limit divided by its acceleration limit, 1/s
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
  void deliver_result();

  double* row(std::size_t block, Row which) { return cells_.data() + (block * rows + which) * lanes; }
  const double* row(std::size_t block, Row which) const { return cells_.data() + (block * rows + which) * lanes; }
  double& of_cell(std::size_t cell, Row which) { return row((cell + pad) / lanes, which)[(cell + pad) % lanes]; }
  double of_cell(std::size_t cell, Row which) const { return row((cell + pad) / lanes, which)[(cell + pad) % lanes]; }
  float* of_axis(std::size_t block, std::size_t axis) { return limits_.data() + (block * moving_.size() + axis) * per_axis * lanes; }
  double limits_of_cell() const { return 1 + 2 * static_cast<double>(moving_.size() * (2 * places - 1)); }

  const TimedPath* path_ = nullptr;
  const PathEnds* ends_ = nullptr;
  StopToken stop_;
  std::size_t n_ = 0;  // number of cells
  // The blocks with the indices 1 to blocks_end_ − 1 contain cells of the path; the other blocks contain dummy cells.
  std::size_t blocks_end_ = 0;
  std::vector<Moving> moving_;
  std::vector<double> cells_;  // the table rows (Row) of all blocks of eight cells
  std::vector<float> limits_;  // The table rows of the limits: `per_axis` rows for each block and each moving axis.
  // The middle ordinates of the squared path speed, their changes in a Newton step, and the gradient. Each vector has one entry per cell,
  // and dummy entries before and after the cells.
  std::vector<double> m_, step_, gradient_;
  // The contribution of each cell to the matrix of the Newton step. There is one element for each pair of the middle ordinates of the
  // previous cell, the cell itself and the next cell.
  std::array<std::vector<double>, 6> products_;
  // The contribution of each cell to the gradient of the objective, for the middle ordinates of the previous cell, the cell itself and the
  // next cell.
  std::array<std::vector<double>, 3> slopes_;
  std::array<std::vector<double>, 3> diagonals_;
  // A ratio for each cell. For a cell after a reversal of the path it is the middle ordinate of the cell divided by the middle ordinate of
  // the previous cell; for other cells it is 0.
  std::vector<double> tied_;
  bool turns_ = false;          // true if the path has reversals
  std::vector<char> restless_;  // one flag per block; the flag is set if the speeds in the block have not converged
  // The middle ordinate of the cell next to the stop at the start and at the end of the path, divided by the middle ordinate of the
  // neighbouring cell.
  double first_share_ = 0, last_share_ = 0;
  std::vector<double> middles_;
  std::vector<CellSpeeds> speeds_;
  double steps_ = 0;
};

}  // namespace kadr
