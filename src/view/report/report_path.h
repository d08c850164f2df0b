#pragma once
// Packs the path for a report, with fewer vertices if it would be too long.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "view/path_record.h"

namespace kadr {

/// The units as whole multiples of which the numbers of a path are packed.
struct ReportQuanta {
  double length = 0.001;  // mm
  double time = 1e-4;     // s
  double feed = 0.1;      // mm/min
  double direction = 1e-5;
  double position = 1e-4;  // unit of joint positions, degrees or mm
};

/// Says which vertices are omitted: those whose PathVertex::level, set by set_levels(), is below the following levels.
struct Thinning {
  int inner = 0;  // level for a vertex whose next vertex belongs to the same block
  int any = 0;    // level for every vertex
  /// Returns by how much the path may deviate because of the omitted vertices, mm.
  double off() const;
};

/// A piece of a path, and which path it belongs to (docs/panel-protocol.md).
struct DrawnPiece {
  const ViewPiece* piece;
  std::uint32_t which;  // 0: the path; 2: the contour as programmed
};
std::vector<DrawnPiece> drawn_pieces(const PathRecord& path, const std::vector<ViewPiece>& contour);

ReportQuanta quanta_of(const std::vector<DrawnPiece>& pieces);

/// True if this vertex of `piece` is omitted.
bool is_left_out(const ViewPiece& piece, std::size_t vertex, const Thinning& thinning);

struct ReportPath {
  std::string bytes;  // the packed pieces, each with its header; the caller compresses them with the other data
  Thinning thinning;
};

/// Packs the path. Omits only as many vertices as necessary for the limit.
///   most_packed  limit of the compressed size, bytes
///   returns      an error sentence if zlib is missing on this machine
tl::expected<ReportPath, std::string> report_path(const std::vector<DrawnPiece>& pieces, const ReportQuanta& quanta, double most_packed);

}  // namespace kadr
