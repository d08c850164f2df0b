#pragma once
// A piece of a turned profile (a line, an arc, or a fillet or chamfer to be inserted), and operations on pieces (spec/linuxcnc 7.2, G70 to
// G72; interp_g7x.cc of LinuxCNC's source). A point is a complex number: Z is the real part, X (a radius) the imaginary part, in the unit
// of the program. Tolerances are those of LinuxCNC, in the same unit.

#include <complex>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace kadr::linuxcnc {

using Point = std::complex<double>;
/// The result of an operation on a profile. The error is LinuxCNC's alarm text. The text is empty if LinuxCNC's cycle would never end.
using Turned = tl::expected<void, std::string>;

inline constexpr double same_point = 1e-6, least_piece = 1e-3;

struct Piece {
  enum class Kind : std::uint8_t { line, arc, fillet, chamfer };
  Kind kind = Kind::line;
  bool ccw = false;  // the arc is counter-clockwise (G3)
  Point start, end;
  Point center{};
  double corner = 0;  // size of a fillet or chamfer that place_corner() has not inserted yet

  static Piece line(Point start, Point end) { return {Kind::line, false, start, end}; }
  static Piece arc(bool ccw, Point start, Point center, Point end) { return {Kind::arc, ccw, start, end, center}; }
  static Piece fillet(double size, Point at) { return {Kind::fillet, false, at, at, at, size}; }
  static Piece chamfer(double size, Point at) { return {Kind::chamfer, false, at, at, {}, size}; }

  bool is_arc() const { return kind == Kind::arc || kind == Kind::fillet; }
  /// Returns the size of the piece: the length of its chord, for an arc at most the radius. A piece smaller than least_piece is removed.
  /// Each step of an offset is at most half the size of the smallest piece.
  double size() const;
  /// Returns true if Z does not increase along the piece and, on an arc, X does not reverse its direction.
  bool falls() const;
  /// Returns the Z coordinates of the points where the piece has the given X: none, one or two.
  std::vector<double> crossings(double x) const;

  /// Replaces the piece by the parallel line, or the concentric arc, at `distance`.
  void offset(double distance);
  void mirror_x();
  void mirror_z();
  void quarter_turn();
};

/// Moves the end of `before` and the start of `after` to the intersection of the two pieces.
Turned join(Piece& before, Piece& after);
/// Inserts a fillet or chamfer between two pieces, and shortens both pieces.
Turned place_corner(Piece& before, Piece& corner, Piece& after);

}  // namespace kadr::linuxcnc
