#pragma once
// Frame: a coordinate system of a Sinumerik in another one, as a value: outer = shift + fine + linear · inner, where `linear` is the
// product of rotation, scale and mirror (spec/sinumerik 11.1).

#include <array>
#include <optional>

#include "base/vec.h"
#include "control/state/control_state.h"

namespace kadr::sinumerik {

using Matrix = std::array<std::array<double, 3>, 3>;
inline constexpr Matrix unit_matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

struct Frame {
  Axes shift{};  // coarse shift; of the axes after the third one too
  Axes fine{};
  Matrix linear = unit_matrix;
  bool is_unchanged() const { return !any_nonzero(shift) && !any_nonzero(fine) && linear == unit_matrix; }
  friend bool operator==(const Frame&, const Frame&) = default;
};

/// Returns the frame that first applies `inner`, then `outer` (outer:inner).
Frame chained(const Frame& outer, const Frame& inner);
/// Returns the inverse; nullopt if a scale factor is 0.
std::optional<Frame> inverse(const Frame& frame);
Axes applied(const Frame& frame, const Axes& point);

/// Returns the coordinates of X, Y and Z.
inline Vec3 in_space(const Axes& axes) { return {axes[0], axes[1], axes[2]}; }

/// Returns the rotation about an axis (0 X, 1 Y, 2 Z), in degrees, counter-clockwise seen from its positive end.
Matrix rotation_about(std::size_t axis, double degrees);
/// Returns the rotation about Z, then about the new Y, then about the new X (RPY, spec/sinumerik 11.2).
Matrix rotation_rpy(double about_x, double about_y, double about_z);
Matrix product(const Matrix& a, const Matrix& b);

/// The parts of a frame: rotation by RPY angles, then scale with the sign of a mirror.
struct FrameParts {
  std::array<double, 3> angles{};
  std::array<double, 3> scale{1, 1, 1};
};
FrameParts parts_of(const Matrix& linear);
Matrix matrix_of(const FrameParts& parts);

/// Returns the frame as a Transform of the interpreter, which turns one plane and has a factor per axis. Returns nullopt for a frame that
/// turns in space, or that shears, because unequal factors act after a rotation.
std::optional<Transform> transform_of(const Frame& frame);
/// Returns the scale and mirror of a frame as a Transform; its rotation and shift in space are left to the placement. Returns nullopt for a
/// frame that shears.
std::optional<Transform> scale_in_space(const Frame& frame);
/// Returns true if the frame's linear part is a rotation (without scale and mirror).
bool is_rotation(const Matrix& linear);

}  // namespace kadr::sinumerik
