#pragma once
// TimedPath: a path divided into cells whose speeds a solver computes. The file defines the input and output types of the least-time
// solvers. x is an axis position, s the length along the path; ′ is d/ds, a dot is d/dt. A and J are an axis' acceleration and jerk limits.
//
//   path          x(s) in each cell a polynomial of the fifth degree; x, x′, x″ continuous
//   path speed    b(s) = ṡ²; in each cell a quadratic polynomial, b and b′ continuous:
//                   s̈ = b′/2,   s⃛ = √b · b″/2
//   speed         b ≤ most
//   acceleration  |x′ b′/2 + x″ b| ≤ A
//   jerk          √b · |x′ b″/2 + 3/2 x″ b′ + x‴ b| ≤ J
//   time          ∫ ds/√b, to be the least
//
// The unknowns are the middle Bézier ordinates m of b, one per cell:
//   b(knot k) = (h_k m_(k−1) + h_(k−1) m_k) / (h_(k−1) + h_k), with h_k the length of cell k.
// In a cell next to a stop the motion is s = j t³/6, that is b ~ s^(4/3). Where the path reverses (goes back along itself) the axes are
// at rest for an instant but keep accelerating in the same direction: there b = 0, b′ changes its sign, and m/h is equal before and after.

#include <cmath>
#include <cstddef>
#include <vector>

namespace kadr {

struct TimedPath {
  std::size_t axes = 0;
  std::vector<double> acceleration, jerk;  // limits of each axis, mm/s², mm/s³
  std::vector<double> h;                   // length of each cell, mm
  std::vector<double> most;                // greatest ṡ² in each cell, mm²/s²
  std::vector<char> turns;                 // 1: the path reverses after this cell
  // coefficients c_i of x(s) = Σ c_i s^i for each cell and axis; index of c_0: (cell * axes + axis) * terms
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
  /// Returns a path that consists of the first `count` cells.
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

inline constexpr std::size_t least_cells = 4;  // the least number of cells that a solver accepts as one path

/// The shares of the limits that the solvers use. The margin is needed because a limit may be slightly exceeded between the sample
/// positions.
struct LimitMargins {
  double acceleration = 0.99, jerk = 0.975;
};

/// b = ṡ² and d = db/ds at a knot (a cell boundary).
struct PathSpeed {
  double b = 0, d = 0;
};

/// The values of b and db/ds at the start and the end of a cell; zero at stops.
struct CellSpeeds {
  PathSpeed start, end;
};

/// The conditions at the start and the end of a path.
struct PathEnds {
  bool from_stop = true;
  PathSpeed from{};             // if !from_stop: the speed that an earlier solution has at the first knot
  bool to_stop = true;          // false: the axes crawl at the end of the path, slowly enough either to continue or to stop soon after
  double crawl = 0;             // if !to_stop: the greatest ṡ² at the end of the path, mm²/s²
  std::vector<double> guess{};  // the middle ordinates of an earlier solution, for the first cells

  bool stand_in(std::size_t cell, std::size_t cells) const { return (cell == 0 && from_stop) || (cell + 1 == cells && to_stop); }
};

/// Returns the greatest ṡ² that the limits allow within this cell, if its neighbours impose no restriction.
double fastest_alone(const TimedPath& path, std::size_t cell);
/// Returns the least fastest_alone() of all cells.
double slowest_alone(const TimedPath& path);
/// Writes to `middles` an estimate of the middle ordinates: bounded by what each cell allows on its own, and by how quickly the jerk
/// limit lets the speed rise to that.
void find_envelope(const TimedPath& path, const PathEnds& ends, std::vector<double>& middles);
/// Returns d b^(3/4) / ds for a start from rest with constant jerk j, where j is the jerk that the most restrictive axis allows: b =
/// (6^(4/3)/4) j^(2/3) s^(4/3).
double soonest_rise(const TimedPath& path);
/// Returns the greatest middle ordinate of a cell next to a stop for which the motion with constant jerk in it obeys the limits.
/// `is_first`: the stop is at the start of the cell; else at its end.
double max_next_to_stop(const TimedPath& path, std::size_t cell, bool is_first, const LimitMargins& margins);
/// Returns the middle ordinate of the cell next to a stop divided by the middle ordinate of its neighbour; this ratio makes b′
/// continuous. `h`: length of the cell; `next`: length of the neighbour.
inline double share_next_to_stop(double h, double next) { return 1.0 / 3 / (1 + 2.0 / 3 * next / h); }

}  // namespace kadr
