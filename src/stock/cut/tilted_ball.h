#pragma once
// Finds the intervals of lattice lines inside the volume that a ball sweeps along a straight path: the ball end of a tilted tool. Numbers
// have single precision; lengths are in mm, relative to the brick's middle.
//
// A ball has the same shape however the tool is tilted. The centre of the ball moves on a nearly straight path: the deviation is within the
// bend that is permitted for every part of a path (tilted_path.h). The swept volume is a ball at either end of the path and a tube between
// them.

#include "stock/cut/tilted_rows.h"

namespace kadr::lanes {

struct BallPath {
  float from[3], to[3];  // start and end of the path of the ball's centre, mm
  float radius;
};

/// The path of a ball (BallPath) in the coordinates of the lattice lines of one family. Of the three coordinates, `line` is along the
/// lines; `lane` and `row` are the two coordinates across the lines, by which the lines of a brick are numbered.
struct BallTube {
  KADR_IN_LANES BallTube(const BallPath& path, int family) {
    const int axes[3] = {family, (family + 1) % 3, (family + 2) % 3};
    float* const of_axis[3] = {line, lane, row};
    float forth[3];
    for (int i = 0; i < 3; ++i)
      of_axis[i][0] = path.from[axes[i]], of_axis[i][1] = path.to[axes[i]], forth[i] = of_axis[i][1] - of_axis[i][0];
    length = std::sqrt(forth[0] * forth[0] + forth[1] * forth[1] + forth[2] * forth[2]);
    const float per = 1 / std::max(length, shortest_path);
    along_line = forth[0] * per, along_lane = forth[1] * per, along_row = forth[2] * per;
    square = along_lane * along_lane + along_row * along_row;
    per_square = 1 / std::max(square, nearly_along);
    per_line = 1 / (std::fabs(along_line) < nearly_none ? nearly_none : along_line);
    is_there = length > shortest_path && square >= nearly_along;
    radius_square = path.radius * path.radius;
  }

  float line[2], lane[2], row[2];           // position of the ball's centre at the start and at the end of the path, mm
  float along_line, along_lane, along_row;  // unit vector of the path
  float length;                             // length of the path in mm
  // square: the squared sine of the angle between the path and the lines; per_square: its inverse; per_line: the inverse of along_line.
  float square, per_square, per_line;
  float radius_square;
  bool is_there;  // true if the ball sweeps a tube; false if the balls at both ends contain the whole swept volume
};

template <class V>
KADR_IN_LANES Swept<V> in_ball_of(const BallTube& b, int end, const V& lanes, const auto& row) {
  const V x = lanes - b.lane[end], room = (b.radius_square - (row - b.row[end]) * (row - b.row[end])) - x * x, half = root(room);
  return where(room > 0.f, b.line[end] - half, b.line[end] + half);
}

/// Returns for each lattice line the interval that the ball sweeps. `lanes` and `row` are the positions of the lines across their
/// direction; `row` is one number for all lines, or one number for each line.
template <class V>
KADR_IN_LANES Swept<V> in_ball_tube(const BallTube& b, const V& lanes, const auto& row) {
  const Swept<V> ends = either(in_ball_of(b, 0, lanes, row), in_ball_of(b, 1, lanes, row));
  if (!b.is_there) return ends;
  const V x = lanes - b.lane[0];
  const auto y = row - b.row[0];
  const V apart = y * b.along_lane - x * b.along_row, gone = x * b.along_lane + y * b.along_row;
  const V room = b.radius_square * b.square - apart * apart, half = root(room) * b.per_square;
  const V nearest = gone * (b.along_line * b.per_square);
  Swept<V> tube{nearest - half, nearest + half};
  clip_between(tube, gone, spread<V>(b.length), b.per_line);
  return either(ends, where((room > 0.f) & (tube.from <= tube.to), tube.from + b.line[0], tube.to + b.line[0]));
}

/// Returns for each line the interval of material that the shaft above the ball may still have to cut: the interval `material` without the
/// part at one of its ends that the ball removes.
template <class V>
KADR_IN_LANES Swept<V> left_by(const Swept<V>& ball, const Swept<V>& material) {
  const MarksOf<V> takes_from = ball.from <= material.from, takes_to = ball.to >= material.to;
  const V from = choose(takes_from & (ball.to > material.from), ball.to, material.from);
  return {from, choose(takes_to & (ball.from < material.to), ball.from, material.to)};
}

}  // namespace kadr::lanes
