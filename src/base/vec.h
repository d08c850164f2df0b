#pragma once
// Vectors of two and three numbers, values per axis, and trigonometry in degrees that is exact at multiples of 90°.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace kadr {

/// Greatest number of axes in one channel (NCT 2.0: 16).
inline constexpr std::size_t max_axes = 16;

/// One value per axis, in the order of the axis table: in mm for linear axes, in degrees for rotary axes.
using Axes = std::array<double, max_axes>;

/// Returns true if the value of any axis differs from 0.
constexpr bool any_nonzero(const Axes& axes) {
  for (const double v : axes)
    if (v != 0) return true;
  return false;
}

/// A set of axes: bit i stands for the axis with index i.
using AxisMask = std::uint32_t;

struct Vec2 {
  double x = 0;
  double y = 0;
  friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec2 operator*(double k, Vec2 a) { return {k * a.x, k * a.y}; }
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;
  friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(double k, Vec3 a) { return {k * a.x, k * a.y, k * a.z}; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }
inline double length(Vec3 a) { return std::hypot(a.x, a.y, a.z); }

struct SinCos {
  double sin = 0;
  double cos = 1;
  friend bool operator==(const SinCos&, const SinCos&) = default;
};

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double rad_per_deg = pi / 180.0;

/// Returns the sine and cosine of an angle in degrees; exactly 0 and ±1 at multiples of 90°.
///   law  sincos_deg(a + 90) == {cos a, -sin a}, bit by bit, while a + 90 is exact
SinCos sincos_deg(double deg);

/// Returns `v` rotated by `deg` counter-clockwise about the origin.
Vec2 rotated(Vec2 v, double deg);

/// Returns the direction of `v` in degrees, in (-180, 180]; exact at multiples of 90°.
double angle_deg(Vec2 v);

}  // namespace kadr
