#pragma once
// TimedPath: a path in cells, whose speed is to be found: what the solvers of least time are given, what they hand back.
//
//   path          x(s) in each cell a polynomial of the fifth degree; x, x′, x″ continuous
//   path speed    b(s) = ṡ²; in each cell a quadratic polynomial, b and b′ continuous:
//                   s̈ = b′/2,   s⃛ = √b · b″/2
//   speed         b ≤ most
//   acceleration  |x′ b′/2 + x″ b| ≤ A
//   jerk          √b · |x′ b″/2 + 3/2 x″ b′ + x‴ b| ≤ J
//   time          ∫ ds/√b, to be the least
//
// b is told by its middle Bézier ordinate m in each cell:  b(knot k) = (h_k m_(k−1) + h_(k−1) m_k) / (h_(k−1) + h_k). In a cell beside a
// stop the motion is s = j t³/6, that is b ~ s^(4/3). Where the path turns back on itself the axes stand for an instant, but go on
// accelerating the same way: b = 0, b′ changes its sign, m/h is the same on both sides.

#include <cmath>
#include <cstddef>
#include <vector>

namespace kadr {

struct TimedPath {
  std::size_t axes = 0;
  std::vector<double> acceleration, jerk;  // of each axis, mm/s², mm/s³
  std::vector<double> h;                   // length of each cell, mm
  std::vector<double> most;                // greatest ṡ² in each cell, mm²/s²
  std::vector<char> turns;                 // the path turns back after this cell
  std::vector<double> shapes;              // x(s) of each cell and axis: Σ c_i s^i, c at (cell * axes + axis) * terms

  static constexpr std::size_t terms = 6;

  std::size_t cells() const { return h.size(); }
  void clear();
  const double* shape(std::size_t cell, std::size_t axis) const { return shapes.data() + (cell * axes + axis) * terms; }
  double* add_shapes();
  void append(const TimedPath& more);
  /// The last cell as so many with the same path.
  void divide_last(std::size_t parts);
  void forget(std::size_t count);
  /// The first cells by themselves.
  TimedPath first(std::size_t count) const;
};

/// x′, x″ and x‴ of an axis at a place of its cell.
struct Derivatives {
  double x1, x2, x3;
  static Derivatives at(const double* c, double s) {
    return {c[1] + s * (2 * c[2] + s * (3 * c[3] + s * (4 * c[4] + s * 5 * c[5]))),
            2 * c[2] + s * (6 * c[3] + s * (12 * c[4] + s * 20 * c[5])), 6 * c[3] + s * (24 * c[4] + s * 60 * c[5])};
  }
};

inline constexpr std::size_t least_cells = 4;  // that are solved together

/// Shares of the limits that the solvers keep: between the places that they look at the limits are a little exceeded.
struct LimitMargins {
  double acceleration = 0.99, jerk = 0.975;
};

/// ṡ² and its derivative by s at a knot.
struct PathSpeed {
  double b = 0, d = 0;
};

/// ṡ² and its derivative at the start and the end of a cell; at stops zero.
struct CellSpeeds {
  PathSpeed start, end;
};

/// How a path begins and ends.
struct PathEnds {
  bool from_stop = true;
  PathSpeed from{};             // else: that of an earlier solution at its knot
  bool to_stop = true;          // else: at the end it crawls, so slow that it may go on or stop after it
  double crawl = 0;             // ṡ² then, at most
  std::vector<double> guess{};  // middles of an earlier solution, of the first cells

  bool stand_in(std::size_t cell, std::size_t cells) const { return (cell == 0 && from_stop) || (cell + 1 == cells && to_stop); }
};

/// What a cell allows by itself, ṡ², whatever its neighbours do.
double fastest_alone(const TimedPath& path, std::size_t cell);
/// The least that any cell does.
double slowest_alone(const TimedPath& path);
/// About how fast the path may be passed, `middles`: by what each cell allows by itself, and by how soon jerk lets it get there.
void find_envelope(const TimedPath& path, const PathEnds& ends, std::vector<double>& middles);
/// d b^(3/4) / ds with constant jerk from rest: b = (6^(4/3)/4) j^(2/3) s^(4/3).
double soonest_rise(const TimedPath& path);
/// The middle ordinate, at most, of the cell beside a stop, whose constant jerk keeps the limits; `ahead`: of motion, 1: the stop is before
/// it.
double most_beside_stop(const TimedPath& path, std::size_t cell, bool is_first, const LimitMargins& margins);
/// The middle ordinate of the cell beside a stop as a share of that of its neighbour, of lengths h and next: b′ is continuous.
inline double share_beside_stop(double h, double next) { return 1.0 / 3 / (1 + 2.0 / 3 * next / h); }

}  // namespace kadr
