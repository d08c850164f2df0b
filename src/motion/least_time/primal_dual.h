#pragma once
// PrimalDual: the least time along a path in cells (motion/least_time/timed_path.h), by a primal-dual interior-point method that need not
// begin within the limits. Eight cells are calculated side by side (base/lanes.h), the same to the last bit on all processors.
//
// Each limit ±c ≤ 1 has a slack s = 1 ∓ c of its own, and a dual z; s z = μ, μ → 0 (Nocedal, Wright: Numerical Optimization, 19). What
// makes it quick:
//
//   - The jerk is |L| ≤ J/√b with L linear in b. J/√b is convex, so its tangent lies below it: a step within the tangent is within the
//   limit.
//   - Every slack and every dual has a step length of its own, and b goes the whole step: one tight place does not shorten the step of the
//     window. What that makes wrong the next step mends.
//   - After some steps over all cells, only the blocks of eight cells go on that have not come to rest, and some beside them.
//   - Limits are looked at in three places of a cell. Then in sixteen more; where one is exceeded the cell's limits are made tighter by as
//     much, and its block goes on.

#include <array>
#include <cstddef>
#include <vector>

#include "base/lanes.h"
#include "base/stop.h"
#include "motion/least_time/timed_path.h"

namespace kadr {

class PrimalDual {
 public:
  ///   returns  false: some blocks did not come to rest within the limits; then speeds() are of no use
  ///            `stop` may ask it to end before
  bool solve(const TimedPath& path, const PathEnds& ends, StopToken stop = {});

  const std::vector<CellSpeeds>& speeds() const { return speeds_; }
  /// The middle ordinates.
  const std::vector<double>& middles() const { return middles_; }
  /// Steps over all cells, or as many blocks.
  double steps() const { return steps_; }

 private:
  static constexpr std::size_t places = 3;     // of a cell that its limits are looked at: its ends and its middle
  static constexpr std::size_t pad = lanes;    // cells of no meaning before the first and after the last: whole blocks
  static constexpr std::size_t per_axis = 34;  // numbers of a moving axis in each cell: below
  // of a place: x′, x″, x‴ divided by the jerk limit
  static constexpr std::size_t shape_row(std::size_t place) { return place * 3; }
  // of a place: slacks +, −, duals +, −
  static constexpr std::size_t jerk_row(std::size_t place) { return 9 + place * 4; }
  // of the middle and the end: the acceleration is continuous
  static constexpr std::size_t acceleration_row(std::size_t place) { return 17 + place * 4; }
  static constexpr std::size_t polynomial_row = 29;

  static constexpr LimitMargins margins{0.996, 0.995};
  static constexpr double at_rest = 0.005;                  // of a middle: a step
  static constexpr double most_beyond = 0.005;              // of a limit with its margin, in the places
  static constexpr double most_gap = 3;                     // slack · dual of the limits of a cell, as a share of their μ
  static constexpr double allowed = 1;                      // of a limit
  static constexpr double most_fall = -0.7, most_rise = 2;  // of a middle, in one step

  /// A number of each cell, eight in a row for each block.
  enum Row : std::size_t {
    length,
    inverse,  // of the length
    limited,  // 1: its limits count; 0: beside a stop, or no cell
    before,   // of the ordinate at its start: the share of the middle before,
    own_before,
    given,   // and what is given
    behind,  // of that at its end
    own_behind,
    inverse_cap,
    cap_slack,
    cap_dual,
    rows
  };

  /// Cells whose speed is sought, in whole blocks; those at its borders, but for stops, stay as they are.
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
    double worst = 1, step = 0;  // the least slack before the step; the greatest step, as a share
    double gap = 0;              // slack · dual of a cell's limits, as a share of what it comes to
    bool is_quiet() const { return step <= at_rest && worst >= -most_beyond && gap <= most_gap; }
    /// Nothing more will change: a start that an earlier solution has given may be so near its limits.
    bool stands() const { return step < 0.2 * at_rest && worst > 1 - allowed / margins.jerk; }
  };
  struct Moving {
    std::size_t axis;
    double ratio;  // of the limits of jerk and acceleration
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
  std::size_t blocks_end_ = 0;  // blocks 1 … blocks_end_ − 1 hold cells
  std::vector<Moving> moving_;
  std::vector<double> cells_;                    // rows of each block
  std::vector<float> limits_;                    // of each block and moving axis
  std::vector<double> m_, step_, gradient_;      // of each cell, pad before and after
  std::array<std::vector<double>, 6> products_;  // of each cell: its part of the matrix, by the middles before, own, behind
  std::array<std::vector<double>, 3> slopes_;    // and of the gradient
  std::array<std::vector<double>, 3> diagonals_;
  std::vector<double> tied_;                 // of each cell: its middle as a share of that before, beside a turn; else 0
  bool turns_ = false;                       // any
  std::vector<char> restless_;               // blocks
  double first_share_ = 0, last_share_ = 0;  // beside stops
  std::vector<double> middles_;
  std::vector<CellSpeeds> speeds_;
  double steps_ = 0;
};

}  // namespace kadr
