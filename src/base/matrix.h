#pragma once
// Mat3: 3×3 rotation matrices, and the vector operations in space that rotations need.

#include <array>

#include "base/vec.h"

namespace kadr {

inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
/// Returns the vector scaled to length 1; {} for a zero vector.
inline Vec3 unit(Vec3 a) {
  const double l = length(a);
  return l > 0 ? (1 / l) * a : Vec3{};
}

/// A 3×3 matrix, stored by rows. A new matrix is the identity.
struct Mat3 {
  std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

  static Mat3 of_columns(Vec3 x, Vec3 y, Vec3 z) { return {{Vec3{x.x, y.x, z.x}, Vec3{x.y, y.y, z.y}, Vec3{x.z, y.z, z.z}}}; }
  /// Returns the right-handed rotation about an axis of length 1 (NCT 25.1, 25a 4).
  static Mat3 about(Vec3 axis, double degrees) {
    const SinCos t = sincos_deg(degrees);
    const auto [x, y, z] = axis;
    const double s = t.sin, c = t.cos, q = 1 - c;
    return {{Vec3{c + x * x * q, x * y * q - z * s, x * z * q + y * s}, Vec3{y * x * q + z * s, c + y * y * q, y * z * q - x * s},
             Vec3{z * x * q - y * s, z * y * q + x * s, c + z * z * q}}};
  }
  Vec3 column(int i) const {
    const auto of = [i](const Vec3& r) { return i == 0 ? r.x : i == 1 ? r.y : r.z; };
    return {of(rows[0]), of(rows[1]), of(rows[2])};
  }
  friend Vec3 operator*(const Mat3& m, Vec3 v) { return {dot(m.rows[0], v), dot(m.rows[1], v), dot(m.rows[2], v)}; }
  friend Mat3 operator*(const Mat3& a, const Mat3& b) { return of_columns(a * b.column(0), a * b.column(1), a * b.column(2)); }
  friend bool operator==(const Mat3&, const Mat3&) = default;
};

/// Returns the transposed matrix. For a rotation, it is the inverse rotation.
inline Mat3 transposed(const Mat3& m) { return {{m.column(0), m.column(1), m.column(2)}}; }
/// Returns transposed(m) · v. If m is a rotation, this is v rotated by the inverse rotation.
inline Vec3 turned_back(const Mat3& m, Vec3 v) { return v.x * m.rows[0] + v.y * m.rows[1] + v.z * m.rows[2]; }

}  // namespace kadr
