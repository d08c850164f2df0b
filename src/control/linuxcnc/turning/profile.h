#pragma once
// The profile of a turning cycle: connected pieces, the first of which is the approach (spec/linuxcnc 7.2; interp_g7x.cc). The profile is
// rotated and mirrored so that X and Z fall along it; `turned` records how, for the conversion back to machine coordinates.

#include <list>

#include "control/linuxcnc/turning/piece.h"

namespace kadr::linuxcnc {

struct Profile {
  std::list<Piece> pieces;
  unsigned turned = 0;  // bits: 1 Z mirrored, 2 X mirrored, 4 rotated by 90° before that

  void quarter_turn();
  /// Mirrors the profile so that X and Z of its last end are below those of the first one.
  void face_down();
  /// Checks that Z falls along the whole profile; else the error is "Not monotonic".
  Turned check_falls();
  /// Places fillets and chamfers.
  Turned place_corners();
  /// Offsets all pieces but the approach outwards by that distance.
  Turned offset(double distance);

  /// A point in machine coordinates. keeps_turn(): an arc keeps its direction there.
  Point on_machine(Point p) const;
  bool keeps_turn() const { return ((turned & 1U) != 0) == ((turned & 2U) != 0); }

 private:
  Turned offset_step(double distance);
};

}  // namespace kadr::linuxcnc
