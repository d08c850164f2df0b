#pragma once
// A piece of a turned profile, and operations on it (spec/linuxcnc 7.2, G70 to G72; interp_g7x.cc of the source). Points are complex: Z is
// the real part, X the imaginary one, in the unit of the program, X as a radius. Tolerances are the control's, in the same unit.

#include <complex>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace kadr::linuxcnc {

using Point = std::complex<double>;
/// The result of a step; its error is the control's text, or empty if the control's cycle would never end.
using Turned = tl::expected<void, std::string>;

inline constexpr double same_point = 1e-6, least_piece = 1e-3;

struct Piece {
  enum class Kind : std::uint8_t { line, arc, fillet, chamfer };
  Kind kind = Kind::line;
  bool ccw = false;  // G3
  Point start, end;
  Point center{};
  double corner = 0;  // size of a fillet or chamfer that has not been placed yet

  static Piece line(Point start, Point end) { return {Kind::line, false, start, end}; }
  static Piece arc(bool ccw, Point start, Point center, Point end) { return {Kind::arc, ccw, start, end, center}; }
  static Piece fillet(double size, Point at) { return {Kind::fillet, false, at, at, at, size}; }
  static Piece chamfer(double size, Point at) { return {Kind::chamfer, false, at, at, {}, size}; }

  bool is_arc() const { return kind == Kind::arc || kind == Kind::fillet; }
  /// The chord, or the radius of an arc if that is smaller. A piece below least_piece is dropped; one step of an offset is at most half of
  /// it.
  double size() const;
  /// True if Z does not grow along the piece, and an arc does not reverse in X.
  bool falls() const;
  /// Z of the points at that X: none to two.
  std::vector<double> crossings(double x) const;

  /// Shifts the piece parallel to itself by that distance.
  void offset(double distance);
  void mirror_x();
  void mirror_z();
  void quarter_turn();
};

/// Moves the end of one piece and the start of the next to their intersection.
Turned join(Piece& before, Piece& after);
/// Places a fillet or chamfer between two pieces, and shortens them.
Turned place_corner(Piece& before, Piece& corner, Piece& after);

}  // namespace kadr::linuxcnc
