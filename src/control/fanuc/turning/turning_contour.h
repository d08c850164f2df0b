#pragma once
// Reads the contour of a turning cycle: the blocks P … Q of the program, which the control does not execute (spec/nct/19.A 2, 5).

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "control/fanuc/turning/contour_piece.h"
#include "control/interpreter.h"

namespace kadr::fanuc {

struct Contour {
  std::vector<ContourPiece> pieces;  // lines and arcs of the contour in program order; the first one starts at the tool's position
  Vec2 entry;                        // travel of the first motion, mm; if the contour is compensated, the travel without compensation
  Position contour_end;              // position in the program just after the contour's last block
  std::string_view uncompensated;    // G41 or G42 of the contour, which the cycle does not apply; empty if the contour has neither
  AxisMask first_named = 0;          // axes that the contour's first block names
  bool follows = false;              // the contour comes after the block of the cycle, so the program continues at `contour_end`
};

/// The positions of blocks P … Q in the file being read.
struct ContourLocation {
  Position first, last;
  Position contour_end;  // position in the file just after block Q, the last block of the contour
};
/// Finds the contour by the words P and Q of the current block.
///   alarms  word_missing, contour_block_missing, contour_order; on a lathe's control figure_words, figure_block_missing (fanuc-t 9.1)
Result<ContourLocation> find_contour(Interpreter& m, const Call& call);

/// Reads the contour, starting at the tool's position.
///   alarms  those of find_contour; contour_shape: a block that is not G0, G1, G2, G3 in the plane; those of chapter 17 for its corners;
///           plane_wrong: G68 in another plane; not_together: arcs with different factors of G51; on a lathe's control instead of
///           contour_shape figure_first_block, figure_unavailable, figure_corner_last, figure_direct_last (fanuc-t 9.1)
Result<Contour> read_drawing(Interpreter& m, const Call& call);

/// Adds one motion of the contour, displaced by `shift` (mm in the plane). A rapid line of the contour remains rapid; any other motion has
/// the feed in force.
Status emit(Emitter& m, const ContourPiece& piece, Vec2 shift);

}  // namespace kadr::fanuc
