// Arithmetic of frames. Used by control/sinumerik; tested by tests/control/sinumerik/frame_test.cpp.

#include "control/sinumerik/frame.h"

#include <cmath>

namespace kadr::sinumerik {
namespace {

constexpr double same = 1e-12;  // relative error of a product of rotations

bool near(double a, double b) { return std::fabs(a - b) <= same * std::max(1.0, std::max(std::fabs(a), std::fabs(b))); }

double determinant(const Matrix& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

}  // namespace

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

Axes applied(const Frame& frame, const Axes& point) {
  Axes to = point;
  for (std::size_t i = 0; i < 3; ++i) to[i] = frame.linear[i][0] * point[0] + frame.linear[i][1] * point[1] + frame.linear[i][2] * point[2];
  for (std::size_t a = 0; a < max_axes; ++a) to[a] += frame.shift[a] + frame.fine[a];
  return to;
}

Frame chained(const Frame& outer, const Frame& inner) {
  Frame all;
  all.linear = product(outer.linear, inner.linear);
  all.shift = applied(outer, applied(inner, Axes{}));
  return all;
}

std::optional<Frame> inverse(const Frame& frame) {
  const Matrix& m = frame.linear;
  const double d = determinant(m);
  if (!(std::fabs(d) > 0)) return std::nullopt;
  Frame back;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, e = (i + 2) % 3;
      back.linear[i][j] = (m[a][c] * m[b][e] - m[a][e] * m[b][c]) / d;
    }
  Frame turned;
  turned.linear = back.linear;
  Axes shift{};
  for (std::size_t a = 0; a < max_axes; ++a) shift[a] = -(frame.shift[a] + frame.fine[a]);
  back.shift = applied(turned, shift);
  return back;
}

Matrix rotation_about(std::size_t axis, double degrees) {
  const SinCos turn = sincos_deg(degrees);
  const std::size_t first = (axis + 1) % 3, second = (axis + 2) % 3;
  Matrix m = unit_matrix;
  m[first][first] = m[second][second] = turn.cos;
  m[first][second] = -turn.sin;
  m[second][first] = turn.sin;
  return m;
}

Matrix rotation_rpy(double about_x, double about_y, double about_z) {
  return product(rotation_about(2, about_z), product(rotation_about(1, about_y), rotation_about(0, about_x)));
}

FrameParts parts_of(const Matrix& linear) {
  FrameParts parts;
  Matrix turn = linear;
  for (std::size_t j = 0; j < 3; ++j) {
    parts.scale[j] = std::sqrt(linear[0][j] * linear[0][j] + linear[1][j] * linear[1][j] + linear[2][j] * linear[2][j]);
    if (parts.scale[j] > 0)
      for (std::size_t i = 0; i < 3; ++i) turn[i][j] /= parts.scale[j];
  }
  if (determinant(turn) < 0) {  // one axis is mirrored: the one that the frame reverses, or X
    std::size_t mirrored = 0;
    for (const std::size_t j : {2u, 1u, 0u})
      if (turn[j][j] < 0) mirrored = j;
    parts.scale[mirrored] = -parts.scale[mirrored];
    for (std::size_t i = 0; i < 3; ++i) turn[i][mirrored] = -turn[i][mirrored];
  }
  const double flat = std::hypot(turn[0][0], turn[1][0]);
  if (flat > same) {
    parts.angles = {angle_deg({turn[2][2], turn[2][1]}), angle_deg({flat, -turn[2][0]}), angle_deg({turn[0][0], turn[1][0]})};
  } else {  // Y is turned by 90 degrees: the angle about X is 0
    parts.angles = {0, turn[2][0] < 0 ? 90.0 : -90.0, angle_deg({turn[1][1], -turn[0][1]})};
  }
  return parts;
}

Matrix matrix_of(const FrameParts& parts) {
  Matrix m = rotation_rpy(parts.angles[0], parts.angles[1], parts.angles[2]);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[i][j] *= parts.scale[j];
  return m;
}

std::optional<Transform> transform_of(const Frame& frame) {
  Transform all;
  const Matrix& m = frame.linear;
  for (std::size_t a = 0; a < max_axes; ++a) all.added[a] = frame.shift[a] + frame.fine[a];
  const auto zero = [&](std::size_t i, std::size_t j) { return std::fabs(m[i][j]) <= same; };
  const bool diagonal = zero(0, 1) && zero(0, 2) && zero(1, 0) && zero(1, 2) && zero(2, 0) && zero(2, 1);
  if (diagonal) {
    for (std::size_t a = 0; a < 3; ++a) all.scale[a] = m[a][a];
    all.refresh();
    return all;
  }
  for (const std::size_t k : {2u, 1u, 0u}) {
    const std::size_t first = (k + 1) % 3, second = (k + 2) % 3;
    if (!zero(k, first) || !zero(k, second) || !zero(first, k) || !zero(second, k)) continue;
    const double size = std::hypot(m[first][first], m[second][first]);
    if (!(size > 0)) return std::nullopt;
    const double cos = m[first][first] / size, sin = m[second][first] / size;
    const double other = -sin * m[first][second] + cos * m[second][second];
    if (!near(m[first][second], -sin * other) || !near(m[second][second], cos * other)) return std::nullopt;
    all.scale[k] = m[k][k];
    // A rotation without a scale has the factor 1 exactly, and equal factors are equal, so that an arc stays an arc.
    all.scale[first] = near(size, 1) ? 1 : size;
    all.scale[second] = near(std::fabs(other), size) ? std::copysign(all.scale[first], other) : other;
    all.rotation = angle_deg({m[first][first], m[second][first]});
    all.rotation_center = {};
    all.first = static_cast<std::uint8_t>(first);
    all.second = static_cast<std::uint8_t>(second);
    all.turned_last = true;
    all.refresh();
    return all;
  }
  return std::nullopt;
}

std::optional<Transform> scale_in_space(const Frame& frame) {
  const FrameParts parts = parts_of(frame.linear);
  const Matrix back = matrix_of(parts);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (std::fabs(back[i][j] - frame.linear[i][j]) > 1e-9) return std::nullopt;
  Transform all;
  for (std::size_t a = 0; a < 3; ++a) all.scale[a] = near(parts.scale[a], 1) ? 1 : parts.scale[a];
  for (std::size_t a = 3; a < max_axes; ++a) all.added[a] = frame.shift[a] + frame.fine[a];
  all.refresh();
  return all;
}

bool is_rotation(const Matrix& linear) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double d = linear[0][i] * linear[0][j] + linear[1][i] * linear[1][j] + linear[2][i] * linear[2][j];
      if (!near(d, i == j ? 1 : 0)) return false;
    }
  return determinant(linear) > 0;
}

}  // namespace kadr::sinumerik
