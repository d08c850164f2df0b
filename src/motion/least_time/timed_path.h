#pragma once
// TimedPath is a path divided into cells whose speeds a solver computes. This file defines the input and output types of the least-time
// solvers. In formulas x is an axis position and s is the length along the path; ′ means d/ds, and a dot means d/dt. A and J are the
// acceleration and jerk limits of an axis.
//
//   path          x(s) in each cell a polynomial of the fifth degree; x, x′, x″ continuous
//   path speed    b(s) = ṡ²; in each cell a quadratic polynomial, b and b′ continuous:
//                   s̈ = b′/2,   s⃛ = √b · b″/2
//   speed         b ≤ most
//   acceleration  |x′ b′/2 + x″ b| ≤ A
//   jerk          √b · |x′ b″/2 + 3/2 x″ b′ + x‴ b| ≤ J
//   time          ∫ ds/√b, which the solver minimises
//
// The unknowns are the middle Bézier ordinates m of b, one per cell:
//   b(knot k) = (h_k m_(k−1) + h_(k−1) m_k) / (h_(k−1) + h_k), with h_k the length of cell k.
// In a cell next to a stop the motion is s = j t³/6, so b is proportional to s^(4/3). At a reversal the path goes back along itself. The
// axes are then at rest for an instant but keep accelerating in the same direction: b is 0, b′ changes its sign, and m/h is equal before
// and after the reversal.

#include <cmath>
#include <cstddef>
#include <vector>

namespace kadr {

struct TimedPath {
  std::size_t axes = 0;
  std::vector<double> acceleration, jerk;  // acceleration and jerk limit of each axis, mm/s² and mm/s³
  std::vector<double> h;                   // length of each cell, mm
  std::vector<double> most;                // greatest squared path speed ṡ² in each cell, mm²/s²
  std::vector<char> turns;                 // 1: the path reverses after this cell
  // The coefficients c_i of x(s) = Σ c_i s^i for each cell and axis. The index of c_0 is (cell * axes + axis) * terms.
  std::vector<double> shapes;

  static constexpr std::size_t terms = 6;

  std::size_t cells() const { return h.size(); }
  void clear();
  const double* shape(std::size_t cell, std::size_t axis) const { return shapes.data() + (cell * axes + axis) * terms; }
  double* add_shapes();
  void append(const TimedPath& more);
  /// Divides the last cell into `parts` equal cells along the same path.
  void divide_last(std::size_t parts);
  void forget(std::size_t count);
  /// Returns a new path that consists of the first `count` cells.
  TimedPath first(std::size_t count) const;
};

/// The derivatives x′, x″ and x‴ of an axis position at the distance s, mm, from the start of a cell.
struct Derivatives {
  double x1, x2, x3;
  static Derivatives at(const double* c, double s) {
    return {c[1] + s * (2 * c[2] + s * (3 * c[3] + s * (4 * c[4] + s * 5 * c[5]))),
            2 * c[2] + s * (6 * c[3] + s * (12 * c[4] + s * 20 * c[5])), 6 * c[3] + s * (24 * c[4] + s * 60 * c[5])};
  }
};

inline constexpr std::size_t least_cells = 4;  // the smallest number of cells that a solver accepts as one path

/// The fractions of the limits that the solvers use. The margin is needed because a limit may be slightly exceeded between the sample
/// positions.
struct LimitMargins {
  double acceleration = 0.99, jerk = 0.975;
};

/// The squared path speed b = ṡ² and its derivative d = db/ds at a knot, the boundary between two cells.
struct PathSpeed {
  double b = 0, d = 0;
};

/// The values of b and db/ds at the start and the end of a cell; they are zero at stops.
struct CellSpeeds {
  PathSpeed start, end;
};

/// The conditions at the start and the end of a path.
struct PathEnds {
  bool from_stop = true;
  PathSpeed from{};  // the speed that an earlier solution has at the start of the first cell; used if `from_stop` is false
  // True: the axes stop at the end of the path. False: they crawl at the end of the path, slowly enough either to continue or to stop soon
  // after the end.
  bool to_stop = true;
  double crawl = 0;             // the greatest ṡ² at the end of the path, mm²/s²; used if `to_stop` is false
  std::vector<double> guess{};  // the middle ordinates of an earlier solution for the first cells of this path

  bool stand_in(std::size_t cell, std::size_t cells) const { return (cell == 0 && from_stop) || (cell + 1 == cells && to_stop); }
};

/// Returns the greatest ṡ², mm²/s², that the limits allow within this cell if the neighbouring cells impose no restriction.
double fastest_alone(const TimedPath& path, std::size_t cell);
/// Returns the smallest value of fastest_alone() over all cells.
double slowest_alone(const TimedPath& path);
/// Writes to `middles` an estimate of the middle ordinates of the squared path speed, one per cell. Each value is at most what the limits
/// in its cell allow. It is also at most what the jerk limit allows, which determines how quickly the speed can rise from the start of the
/// path and fall to its end.
void find_envelope(const TimedPath& path, const PathEnds& ends, std::vector<double>& middles);
/// Returns how quickly the path speed can rise from rest: d b^(3/4) / ds, where b is the squared path speed and s the path length. The axes
/// start with the constant jerk j that the most restrictive axis allows, so b = (6^(4/3)/4) j^(2/3) s^(4/3).
double soonest_rise(const TimedPath& path);
/// Returns the greatest middle ordinate of a cell next to a stop at which the motion with constant jerk in this cell obeys the limits.
/// `is_first` is true if the stop is at the start of the cell, and false if the stop is at its end.
double max_next_to_stop(const TimedPath& path, std::size_t cell, bool is_first, const LimitMargins& margins);
/// Returns the middle ordinate of the cell next to a stop divided by the middle ordinate of the neighbouring cell. This ratio makes b′
/// continuous. `h` is the length of the cell; `next` is the length of the neighbouring cell.
inline double share_next_to_stop(double h, double next) { return 1.0 / 3 / (1 + 2.0 / 3 * next / h); }

}  // namespace kadr
