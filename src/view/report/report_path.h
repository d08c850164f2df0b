#pragma once
// Packs the path for a report, with fewer vertices if the report would be too long.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "view/path_record.h"

namespace kadr {

/// The resolution of a packed path. Each quantity is packed as a whole number of counts; a member is the size of one count.
struct ReportQuanta {
  double length = 0.001;  // one count of a position, mm
  double time = 1e-4;     // one count of a time, s
  double feed = 0.1;      // one count of a feed or speed, mm/min
  double direction = 1e-5;
  double position = 1e-4;  // one count of a joint position, degrees or mm
};

/// A rule that omits vertices of a path: a vertex is omitted if its level of detail (PathVertex::level, set by set_levels()) is less than
/// the least level that this rule permits.
struct Thinning {
  int inner = 0;  // least level of a vertex that is kept inside a block, that is, if the next vertex belongs to the same block
  int any = 0;    // least level of any vertex that is kept, also of the last vertex of a block
  /// Returns the greatest distance in mm by which the path may deviate because of the omitted vertices.
  double off() const;
};

/// A segment of a path, and the number of this path (docs/panel-protocol.md).
struct DrawnPiece {
  const ViewPiece* piece;
  std::uint32_t which;  // number of the path in the protocol; 0: the path of the tool; 2: the contour as programmed
};
std::vector<DrawnPiece> drawn_pieces(const PathRecord& path, const std::vector<ViewPiece>& contour);

ReportQuanta quanta_of(const std::vector<DrawnPiece>& pieces);

/// Returns true if this vertex of `piece` is omitted.
bool is_left_out(const ViewPiece& piece, std::size_t vertex, const Thinning& thinning);

struct ReportPath {
  std::string bytes;  // the packed segments, each with a header; the caller compresses them together with the other data
  Thinning thinning;
};

/// Packs the path. Only as many vertices as necessary are omitted.
///   most_packed  greatest compressed size, bytes
///   returns      the path, or an error sentence if zlib is missing on this computer
tl::expected<ReportPath, std::string> report_path(const std::vector<DrawnPiece>& pieces, const ReportQuanta& quanta, double most_packed);

}  // namespace kadr
