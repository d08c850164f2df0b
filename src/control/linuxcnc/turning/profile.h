#pragma once
// The profile of a turning cycle: connected lines and arcs, the first of which is the approach (spec/linuxcnc 7.2; interp_g7x.cc). The
// profile is rotated and mirrored so that Z decreases along the profile and X is greater at its end than at its start; `turned` records
// this transformation, so that points can be converted back to machine coordinates.

#include <list>

#include "control/linuxcnc/turning/piece.h"

namespace kadr::linuxcnc {

struct Profile {
  std::list<Piece> pieces;
  unsigned turned = 0;  // bits of the transformation: 1 Z mirrored, 2 X mirrored, 4 rotated by 90° before mirroring

  void quarter_turn();
  /// Mirrors the profile so that, at the end of the last piece, Z is not above and X not below their values at the end of the first piece.
  void face_down();
  /// Checks that Z decreases along the whole profile; else the error is "Not monotonic".
  Turned check_falls();
  /// Inserts the fillets and chamfers between the pieces that they connect.
  Turned place_corners();
  /// Offsets all pieces except the approach outwards by `distance`.
  Turned offset(double distance);

  /// Converts a point of the transformed profile back to machine coordinates. keeps_turn(): true if an arc keeps its direction of rotation
  /// in the conversion.
  Point on_machine(Point p) const;
  bool keeps_turn() const { return ((turned & 1U) != 0) == ((turned & 2U) != 0); }

 private:
  Turned offset_step(double distance);
};

}  // namespace kadr::linuxcnc
