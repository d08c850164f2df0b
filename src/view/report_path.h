#pragma once
// The path of a report: packed, and thinned if it would be too long.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "view/path_record.h"

namespace kadr {

/// The unit of each packed number.
struct ReportQuanta {
  double length = 0.001;  // mm
  double time = 1e-4;     // s
  double feed = 0.1;      // mm/min
  double direction = 1e-5;
  double position = 1e-4;  // of a joint, degrees or mm
};

/// Which vertices are left out: those below these levels.
struct Thinning {
  int inner = 0;  // for vertices that are followed by one of the same block
  int any = 0;    // for all vertices
  /// mm by which the path may be off.
  double off() const;
};

/// A piece with its number in frames of the protocol.
struct DrawnPiece {
  const ViewPiece* piece;
  std::uint32_t which;  // 0: of the path, 2: of the contour as programmed
};
std::vector<DrawnPiece> drawn_pieces(const PathRecord& path, const std::vector<ViewPiece>& contour);

ReportQuanta quanta_of(const std::vector<DrawnPiece>& pieces);

/// True if this vertex of `piece` is left out.
bool is_left_out(const ViewPiece& piece, std::size_t vertex, const Thinning& thinning);

struct ReportPath {
  std::string bytes;  // pieces, each with its header, to be packed together with the rest
  Thinning thinning;
};

/// Packs the path, thinned no more than needed.
///   most_packed  limit in bytes, packed
///   returns      an error sentence if this machine has no zlib
tl::expected<ReportPath, std::string> report_path(const std::vector<DrawnPiece>& pieces, const ReportQuanta& quanta, double most_packed);

}  // namespace kadr
