#pragma once
// The least time along a given path: path speed as a function of path length, so that no axis exceeds its acceleration and jerk.
//
//   path          x(s), cut into cells; x′, x″ (continuous) and x‴ are known at eight places of each
//   path speed    b(s) = ṡ²; in each cell a quadratic polynomial, b and b′ continuous:
//                   s̈ = b′/2,   s⃛ = √b · b″/2
//   speed         b ≤ most
//   acceleration  |x′ b′/2 + x″ b| ≤ A
//   jerk          √b · |x′ b″/2 + 3/2 x″ b′ + x‴ b| ≤ J
//   time          ∫ ds/√b, to be the least
//
// b is told by its middle Bézier ordinate m in each cell:  b(knot k) = (h_k m_(k−1) + h_(k−1) m_k) / (h_(k−1) + h_k). In a cell beside a
// stop the motion is s = j t³/6, that is b ~ s^(4/3). Where the path turns back on itself the axes stand for an instant, but go on
// accelerating the same way: b = 0, b′ changes its sign, m/h is the same on both sides. The problem is solved by an interior-point method:
// Newton steps on T − μ Σ log(slack), μ → 0, with a Hessian of five diagonals; every iterate obeys all limits. b as the unknown: Verscheure
// et al. 2009, IEEE TAC 54(10); the jerk, which is not convex in b, is kept by the barrier itself and its bend left out of the Hessian.

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/stop.h"
#include "motion/least_time/lanes.h"

namespace kadr {

/// A path to be timed, in cells.
struct TimedPath {
  std::size_t axes = 0;
  std::vector<double> acceleration, jerk;  // of each axis, mm/s², mm/s³
  std::vector<double> h;                   // length of each cell, mm
  std::vector<double> most;                // greatest ṡ² in each cell, mm²/s²
  std::vector<char> turns;                 // the path turns back after this cell
  std::vector<double> x1, x2, x3;          // x′, x″, x‴ in each cell at its places: (cell * axes + axis) * places + place

  /// Where the limits are looked at: at the ends of a cell and between, denser where the jerk of its polynomial is greatest.
  static constexpr std::size_t places = lanes;
  static constexpr std::array<double, places> part = {0, 0.12, 0.28, 0.43, 0.57, 0.72, 0.88, 1};

  std::size_t cells() const { return h.size(); }
  void clear();
};

inline constexpr std::size_t least_cells = 4;  // that are solved together

/// ṡ² and its derivative by s at a knot.
struct PathSpeed {
  double b = 0, d = 0;
};

/// Finds the speed. Keeps its memory for the next path.
class LeastTime {
 public:
  /// How the path begins and ends.
  struct Ends {
    bool from_stop = true;
    PathSpeed from{};             // else: that of an earlier solution at its knot
    bool to_stop = true;          // else: at the end it crawls, so slow that it may go on or stop after it
    double crawl = 0;             // ṡ² then, at most
    std::vector<double> guess{};  // middles to begin with, of the first cells; the others crawl
  };

  ///   pre      at least 4 cells
  ///   returns  false: no speed was found that obeys the limits (a limit that is not positive, a path that is not finite)
  ///            `stop` may ask it to end before the time is the least
  bool solve(const TimedPath& path, const Ends& ends, StopToken stop = {});

  /// ṡ² and its derivative at the start and the end of each cell; at stops zero.
  struct CellSpeeds {
    PathSpeed start, end;
  };
  const std::vector<CellSpeeds>& speeds() const { return speeds_; }
  /// The middle ordinates.
  const std::vector<double>& middles() const { return m_; }
  int steps() const { return steps_; }

  /// The least ṡ² that any cell allows by itself, whatever its neighbours do.
  static double slowest(const TimedPath& path);

 private:
  static constexpr std::size_t places = TimedPath::places;
  static constexpr std::size_t beyond = 2;  // a cell may name variables after the last; derivatives and steps of these are 0
  using Three = std::array<double, 3>;
  /// b in a cell by its Bézier ordinates: at the start, the middle one, at the end.
  using Ordinates = Three;
  /// An axis that moves, and what its acceleration and jerk are divided by.
  struct Moving {
    std::size_t axis = 0;
    double by_acceleration = 0, by_jerk = 0;
  };
  class Logs;
  /// T and Σ log(slack).
  struct Height {
    double time, logs;
    double at(double mu) const { return time - mu * logs; }
  };
  /// The Hessian, a matrix of five diagonals: the middle one, the next, the last.
  struct Diagonals {
    std::vector<double> h0, h1, h2;
  };
  /// An ordinate as a sum of variables: of those before, of and after its cell.
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
  bool goes_on_crawling(double gently);
  bool goes_on_to_stop();
  double soonest() const;
  void find_envelope();
  static double alone(const TimedPath& path, std::size_t cell);
  void spread(const std::vector<double>& y);
  Ordinates ordinates(std::size_t cell) const;
  std::size_t at_places(std::size_t cell, const Moving& moving) const { return (cell * path_->axes + moving.axis) * places; }
  bool turns_behind(std::size_t cell) const { return path_->turns[cell] != 0; }
  bool is_stop_cell(std::size_t cell) const { return (cell == 0 && ends_.from_stop) || (cell + 1 == n_ && ends_.to_stop); }
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
  Ends ends_;
  std::size_t n_ = 0;          // cells
  std::size_t variables_ = 0;  // m of a cell = scale * its variable; those beside stops and turns have their neighbour's
  std::vector<std::size_t> variable_;
  std::vector<double> scale_;
  bool first_given_ = false;  // the first cell follows from the start
  std::vector<Moving> moving_;
  std::vector<std::array<Mix, 2>> mixes_;  // of each cell's first and last ordinate
  std::vector<double> cap_;
  std::vector<double> m_;                            // of the cells
  std::vector<double> y_, trial_, step_, gradient_;  // of the variables
  Diagonals hessian_, factors_;                      // factors: L D Lᵀ
  std::vector<char> broken_, was_broken_;            // groups of cells in which the step breaks a limit
  Height height_{};                                  // of y_
  std::vector<CellSpeeds> speeds_;
  int steps_ = 0;
};

}  // namespace kadr
