#pragma once
// Reads the contour of a turning cycle: the blocks P … Q of the program, which the control does not execute (spec/nct/19.A 2, 5).

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "control/interpreter.h"

namespace kadr::fanuc {

/// A motion of the contour in the plane, in programmed coordinates, mm. It is a line, or an arc whose radius changes linearly with the
/// angle.
struct ContourPiece {
  MotionKind kind = MotionKind::rapid;
  Vec2 from, to;
  Vec2 center;
  double turns = 0;         // swept angle of an arc in revolutions, positive; 0 for a line
  std::uint32_t block = 0;  // block number N of the block that programs this motion

  bool is_arc() const { return kind == MotionKind::arc_cw || kind == MotionKind::arc_ccw; }
  /// Returns the point at a fraction 0 … 1 of the line's length or of the arc's angle.
  Vec2 at(double part) const;
};

struct Contour {
  std::vector<ContourPiece> pieces;  // lines and arcs of the contour in program order; the first one starts at the tool's position
  Vec2 entry;                        // travel of the first motion, mm; if the contour is compensated, the travel without compensation
  Position contour_end;              // position in the program just after the contour's last block
  std::string_view uncompensated;    // G41 or G42 of the contour, which the cycle does not apply; empty if the contour has neither
  bool follows = false;              // the contour comes after the block of the cycle, so the program continues at `contour_end`
};

/// The positions of blocks P … Q in the file being read.
struct ContourLocation {
  Position first, last;
  Position contour_end;  // position in the file just after block Q, the last block of the contour
};
/// Finds the contour by the words P and Q of the current block. alarms  word_missing, contour_block_missing, contour_order
Result<ContourLocation> find_contour(Interpreter& m, const Call& call);

/// Reads the contour, starting at the tool's position.
///   alarms  those of find_contour; contour_shape: a block that is not G0, G1, G2, G3 in the plane; those of chapter 17 for its corners;
///           plane_wrong: G68 in another plane; not_together: arcs with different factors of G51
Result<Contour> read_drawing(Interpreter& m, const Call& call);

/// Splits arcs at the points where one of the axes reverses. Along each line or arc of the result, neither axis reverses its direction.
std::vector<ContourPiece> monotone(const std::vector<ContourPiece>& pieces);

/// Adds one motion of the contour, displaced by `shift` (mm in the plane). A rapid line of the contour remains rapid; any other motion has
/// the feed in force.
Status emit(Emitter& m, const ContourPiece& piece, Vec2 shift);

}  // namespace kadr::fanuc
