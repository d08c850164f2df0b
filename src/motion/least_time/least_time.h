#pragma once
// LeastTime finds the least time along a path in cells (motion/least_time/timed_path.h). It uses an interior-point method whose iterates
// all obey all limits. The method makes Newton steps on T − μ Σ log(slack), μ → 0, where T is the time and a slack is the distance from a
// limit. The Hessian is pentadiagonal. The unknown is b = ṡ², the squared path speed: Verscheure et al. 2009, IEEE TAC 54(10). The jerk
// limit is not convex in b; the logarithmic barrier enforces this limit, and the curvature of the limit is omitted from the Hessian. The
// method is slow but reliable. It is used for the paths that motion/least_time/primal_dual does not solve.

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/double_lanes.h"
#include "base/stop_token.h"
#include "motion/least_time/timed_path.h"

namespace kadr {

/// The solver of the speed along a path. It reuses its allocated memory for the next path.
class LeastTime {
 public:
  explicit LeastTime(const LimitMargins& margins = {}) : margins_(margins) {}

  /// Positions in a cell, as fractions of its length, at which the limits are checked. They are densest near both ends of the cell, where
  /// the jerk of the polynomial is greatest.
  static constexpr std::size_t places = lanes;
  static constexpr std::array<double, places> place_parts = {0, 0.12, 0.28, 0.43, 0.57, 0.72, 0.88, 1};

  ///   pre      the path has at least 4 cells
  ///   returns  false if no speed was found that obeys the limits, for example because a limit is not positive or the path is not finite;
  ///            if `stop` ends the search early, the time may be above the minimum
  bool solve(const TimedPath& path, const PathEnds& ends, StopToken stop = {});

  const std::vector<CellSpeeds>& speeds() const { return speeds_; }
  /// The middle Bézier ordinates of b in the solution, one per cell.
  const std::vector<double>& middles() const { return m_; }
  int steps() const { return steps_; }

 private:
  // Number of dummy variables that the vectors have after the last real variable. The neighbours of the last cells refer to these dummy
  // variables, whose derivatives and steps are 0.
  static constexpr std::size_t beyond = 2;
  using Three = std::array<double, 3>;
  /// The three Bézier ordinates of the polynomial b in a cell: at its start, in its middle and at its end.
  using Ordinates = Three;
  /// An axis that moves on this path, with the reciprocals of its acceleration and jerk limits.
  struct Moving {
    std::size_t axis = 0;
    double by_acceleration = 0, by_jerk = 0;
  };
  class Logs;
  /// The two terms of the objective T − μ Σ log(slack): the time T and the sum of logarithms.
  struct Height {
    double time, logs;
    double at(double mu) const { return time - mu * logs; }
  };
  /// The Hessian, a symmetric pentadiagonal matrix, stored as its main diagonal and the two diagonals above it.
  struct Diagonals {
    std::vector<double> h0, h1, h2;
  };
  /// A Bézier ordinate as a linear combination: the constant `given`, and one factor for each of the variables of the previous cell, the
  /// cell itself and the next cell.
  struct Mix {
    double given = 0;
    Three by{};
  };

  void prepare();
  void number_variables();
  void find_mixes();
  void find_moving();
  void keep_stop(std::size_t cell);
  bool first_guess();
  bool can_continue_crawling(double gently);
  bool can_continue_to_stop();
  void find_envelope();
  void find_places();
  void spread(const std::vector<double>& y);
  Ordinates ordinates(std::size_t cell) const;
  std::size_t at_places(std::size_t cell, const Moving& moving) const { return (cell * path_->axes + moving.axis) * places; }
  bool turns_after(std::size_t cell) const { return path_->turns[cell] != 0; }
  bool is_stop_cell(std::size_t cell) const { return ends_.stand_in(cell, n_); }
  std::size_t first_variable(std::size_t cell) const { return variable_[cell > 0 ? cell - 1 : 0]; }
  double time() const;
  Height height(const std::vector<double>& y);
  bool is_within(const std::vector<double>& y) { return height(y).time < std::numeric_limits<double>::infinity(); }
  void derivatives(double mu);
  template <class Lanes>
  KADR_LANES bool add_logs(Logs& logs) const;
  template <class Lanes>
  KADR_LANES void add_cell(std::size_t cell, double mu);
  bool newton_step();
  bool stiffen(double mu, bool first);
  template <class Lanes>
  KADR_LANES bool stiffen_cell(std::size_t cell, double mu);
  void add_hessian(std::size_t cell, double scale, const std::array<Three, 3>& h);
  Three step_in(std::size_t cell) const;
  void by_variables(std::size_t cell, std::array<Three, 3>& by) const;
  double line_search(double mu);

  const TimedPath* path_ = nullptr;
  PathEnds ends_;
  LimitMargins margins_;
  // The derivatives x′, x″, x‴ at the sample positions of each cell; the index is (cell * axes + axis) * places + place.
  std::vector<double> x1_, x2_, x3_;
  std::size_t n_ = 0;  // number of cells
  // Number of unknowns (variables). The middle Bézier ordinate of b in a cell is the cell's variable times the cell's factor in scale_. A
  // cell next to a stop or a reversal has the same variable as its neighbour.
  std::size_t variables_ = 0;
  std::vector<std::size_t> variable_;
  std::vector<double> scale_;
  bool first_given_ = false;  // true if the speed at the start of the path determines the speed of the first cell
  std::vector<Moving> moving_;
  std::vector<std::array<Mix, 2>> mixes_;  // the first and the last Bézier ordinate of each cell as linear combinations of the variables
  std::vector<double> cap_;
  std::vector<double> m_;  // the middle Bézier ordinates of b, one per cell
  // Vectors with one entry per variable of the solver. `y_` has the current values, and `trial_` the values after the step that is being
  // tried.
  std::vector<double> y_, trial_, step_, gradient_;
  Diagonals hessian_, factors_;  // `factors_` is the decomposition L D Lᵀ of the Hessian.
  // One flag per group of neighbouring cells; the flag is set if the Newton step violates a limit in one of these cells.
  std::vector<char> broken_, was_broken_;
  Height height_{};  // path time T and sum of logarithms for the current values y_ of the variables
  std::vector<CellSpeeds> speeds_;
  int steps_ = 0;
};

}  // namespace kadr
