#pragma once
// The profile of a turning cycle: pieces in a row, the first the way to it (spec/linuxcnc 7.2; interp_g7x.cc). It is turned and mirrored so
// that X and Z fall along it; `turned` says how, for the way back.

#include <list>

#include "control/linuxcnc/turning/piece.h"

namespace kadr::linuxcnc {

struct Profile {
  std::list<Piece> pieces;
  unsigned turned = 0;  // bits: 1 Z mirrored, 2 X mirrored, 4 turned by 90° before

  void quarter_turn();
  /// X and Z of the last end lie below those of the first one.
  void face_down();
  /// Z falls along all of it, else "Not monotonic".
  Turned check_falls();
  /// Fillets and chamfers get their places.
  Turned place_corners();
  /// All but the way to it lies that much further outside.
  Turned offset(double distance);

  /// A point of it on the machine; does an arc keep its direction there?
  Point on_machine(Point p) const;
  bool keeps_turn() const { return ((turned & 1U) != 0) == ((turned & 2U) != 0); }

 private:
  Turned offset_step(double distance);
};

}  // namespace kadr::linuxcnc
