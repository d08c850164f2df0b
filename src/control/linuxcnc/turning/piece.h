#pragma once
// A piece of a turned profile, and what can be done with one (spec/linuxcnc 7.2, G70 to G72; interp_g7x.cc of the source). Points are
// complex: Z along, X across, in the unit of the program, X as a radius. Tolerances are the control's, and count in that unit too.

#include <complex>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"

namespace kadr::linuxcnc {

using Point = std::complex<double>;
/// What the control says if it cannot go on; empty: its cycle would never end.
using Turned = tl::expected<void, std::string>;

inline constexpr double same_point = 1e-6, least_piece = 1e-3;

struct Piece {
  enum class Kind : std::uint8_t { line, arc, fillet, chamfer };
  Kind kind = Kind::line;
  bool ccw = false;  // G3
  Point start, end;
  Point center{};
  double corner = 0;  // of a fillet or chamfer that has no place yet: its size

  static Piece line(Point start, Point end) { return {Kind::line, false, start, end}; }
  static Piece arc(bool ccw, Point start, Point center, Point end) { return {Kind::arc, ccw, start, end, center}; }
  static Piece fillet(double size, Point at) { return {Kind::fillet, false, at, at, at, size}; }
  static Piece chamfer(double size, Point at) { return {Kind::chamfer, false, at, at, {}, size}; }

  bool is_arc() const { return kind == Kind::arc || kind == Kind::fillet; }
  /// Below least_piece it is left out; half of it is as far as an offset goes in one step.
  double size() const;
  /// Z does not grow along it, and no arc turns back in X.
  bool falls() const;
  /// Z where it crosses that X, none to two of them.
  std::vector<double> crossings(double x) const;

  /// Parallel, at that distance.
  void offset(double distance);
  void mirror_x();
  void mirror_z();
  void quarter_turn();
};

/// The end of one and the start of the next come to where they meet.
Turned join(Piece& before, Piece& after);
/// A fillet or chamfer between two pieces gets its place, and these get shorter.
Turned place_corner(Piece& before, Piece& corner, Piece& after);

}  // namespace kadr::linuxcnc
