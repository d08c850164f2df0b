#pragma once
// The path of a report: packed, and thinned where it would be too long.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "view/path_record.h"

namespace kadr {

/// What one step of a packed number is.
struct ReportQuanta {
  double length = 0.001;  // mm
  double time = 1e-4;     // s
  double feed = 0.1;      // mm/min
  double direction = 1e-5;
  double position = 1e-4;  // of a joint, degrees or mm
};

/// Which vertices are left out: those below a level.
struct Thinning {
  int inner = 0;  // where the next one belongs to the same block
  int any = 0;    // wherever they are
  /// mm that the path may be off.
  double off() const;
};

/// A piece as a frame of the protocol has it.
struct DrawnPiece {
  const ViewPiece* piece;
  std::uint32_t which;  // 0: of the path, 2: of the contour as programmed
};
std::vector<DrawnPiece> drawn_pieces(const PathRecord& path, const std::vector<ViewPiece>& contour);

ReportQuanta quanta_of(const std::vector<DrawnPiece>& pieces);

/// Whether that one is left out of `piece`.
bool is_left_out(const ViewPiece& piece, std::size_t vertex, const Thinning& thinning);

struct ReportPath {
  std::string bytes;  // pieces, each with its head, to be packed with the rest
  Thinning thinning;
};

/// Thinned no more than needed.
///   most_packed  bytes that it may take, packed
///   returns      an error sentence: this machine has no zlib
tl::expected<ReportPath, std::string> report_path(const std::vector<DrawnPiece>& pieces, const ReportQuanta& quanta, double most_packed);

}  // namespace kadr
