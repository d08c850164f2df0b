#pragma once
// The contour of a turning cycle: blocks P … Q read from the program without being carried out (spec/nct/19.A 2, 5).

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "control/interpreter.h"

namespace kadr::fanuc {

/// A motion of the contour in the plane, programmed, mm: a line or an arc whose radius changes linearly with the angle.
struct ContourPiece {
  MotionKind kind = MotionKind::rapid;
  Vec2 from, to;
  Vec2 center;
  double turns = 0;         // of an arc: swept angle / 360, positive
  std::uint32_t block = 0;  // N it comes from

  bool is_arc() const { return kind == MotionKind::arc_cw || kind == MotionKind::arc_ccw; }
  /// Point at a part 0 … 1 of its length or angle.
  Vec2 at(double part) const;
};

struct Contour {
  std::vector<ContourPiece> pieces;  // in order, the first begins where the tool stands
  Position behind;                   // its last block
  std::string_view uncompensated;    // G41 or G42 in it that the cycle does not carry out
  bool follows = false;              // it stands after the cycle's block: the program goes on at `after`
};

/// Where blocks P … Q stand in the file being read.
struct ContourPlace {
  Position first, last;
  Position behind;  // the last
};
/// By the words P and Q of the current block. alarms  word_missing, contour_block_missing, contour_order
Result<ContourPlace> find_contour(Interpreter& m, const Call& call);

/// The contour from where the tool stands.
///   alarms  those of find_contour; contour_shape: a block that is no G0, G1, G2, G3 in the plane; those of 17 for its corners;
///           plane_wrong: G68 in another plane; not_together: arcs with different factors of G51
Result<Contour> read_contour(Interpreter& m, const Call& call);

/// Arcs cut where one of the axes turns back: in each piece both run one way only.
std::vector<ContourPiece> monotone(const std::vector<ContourPiece>& pieces);

/// One motion of the contour, shifted; lines at rapid where the program says so, all else at the feed in force.
Status emit(Emitter& m, const ContourPiece& piece, Vec2 shift);

}  // namespace kadr::fanuc
