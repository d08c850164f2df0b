#pragma once
// The profile of a turning cycle: connected lines and arcs; the first of them is the approach (spec/linuxcnc 7.2; interp_g7x.cc). The
// profile is rotated and mirrored so that Z decreases along the profile, and X is greater at its end than at its start. `turned` records
// this transformation, so that points can be converted back to machine coordinates.

#include <list>

#include "control/linuxcnc/turning/piece.h"

namespace kadr::linuxcnc {

struct Profile {
  std::list<Piece> pieces;
  unsigned turned = 0;  // transformation as a sum of bits: 1 Z was mirrored, 2 X was mirrored, 4 the profile was first rotated by 90°

  void quarter_turn();
  /// Mirrors the profile so that at its end Z is at most, and X at least, as large as at the end of the approach.
  void face_down();
  /// Checks that Z decreases along the whole profile. The error is LinuxCNC's alarm text "Not monotonic".
  Turned check_falls();
  /// Inserts the fillets and chamfers between the pieces that they connect.
  Turned place_corners();
  /// Offsets all pieces except the approach by `distance`, away from the part.
  Turned offset(double distance);

  /// Converts a point of the rotated and mirrored profile back to machine coordinates. keeps_turn() is true if this conversion keeps the
  /// direction of rotation of an arc.
  Point on_machine(Point p) const;
  bool keeps_turn() const { return ((turned & 1U) != 0) == ((turned & 2U) != 0); }

 private:
  Turned offset_step(double distance);
};

}  // namespace kadr::linuxcnc
