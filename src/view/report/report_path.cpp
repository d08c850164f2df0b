// Packs the path of a run for a report. Used by view/report/page_report; tested by tests/view/report_path_test.cpp.

#include "view/report/report_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "view/report/packed_columns.h"

namespace kadr {
namespace {

constexpr std::uint32_t piece_of_path = 1;  // number that marks a segment of the path in the data of the report
constexpr double first_guess = 12;          // number of compressed bytes per vertex that the first attempt assumes
// Number of attempts to come close to the greatest compressed size. More attempts follow if no result is within this size.
constexpr int max_tries = 4;

/// The thinnings of a path, from no omission to a hardly recognisable path. Vertices within blocks are omitted first, so that the end of
/// each program line keeps its time.
constexpr std::array<Thinning, 16> thinnings = {Thinning{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0},   {6, 0},   {7, 0},
                                                {8, 0},         {8, 2}, {8, 4}, {8, 6}, {8, 8}, {10, 10}, {12, 12}, {15, 15}};

using Column = std::vector<std::int32_t>;

std::size_t count_left_by(const std::vector<DrawnPiece>& pieces, const Thinning& thinning) {
  std::size_t count = 0;
  for (const DrawnPiece& drawn : pieces)
    for (std::size_t i = 0; i < drawn.piece->vertices.size(); ++i) count += is_left_out(*drawn.piece, i, thinning) ? 0 : 1;
  return count;
}

template <class Value>
void put(PackedColumns& to, const std::vector<const PathVertex*>& vertices, Column& column, const Value& value) {
  column.clear();
  for (const PathVertex* const v : vertices) column.push_back(value(*v));
  to.put(column);
}

std::string packed_piece(const DrawnPiece& drawn, const Thinning& thinning, const ReportQuanta& q) {
  const ViewPiece& piece = *drawn.piece;
  std::vector<const PathVertex*> vertices;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < piece.vertices.size(); ++i) {
    if (is_left_out(piece, i, thinning)) continue;
    vertices.push_back(&piece.vertices[i]);
    indices.push_back(i);
  }
  PackedColumns to;
  to.put_u32(std::uint32_t(vertices.size()));
  // Number of the path in the protocol, then the number of the channel (0: the program's own channel).
  to.put_u32(drawn.which), to.put_u32(0);
  to.put_u32((piece.directions.empty() ? 0 : 1) + 2 * std::uint32_t(piece.joints()));
  to.put_u32(piece.first);
  to.put_f64(piece.begins);
  Column column;
  for (std::size_t axis = 0; axis < 3; ++axis)
    put(to, vertices, column, [&](const PathVertex& v) { return in_steps(double(v.at[axis]), q.length); });
  put(to, vertices, column, [&](const PathVertex& v) { return in_steps(double(v.time), q.time); });
  put(to, vertices, column, [](const PathVertex& v) { return std::int32_t(v.line); });
  put(to, vertices, column, [](const PathVertex& v) { return std::int32_t(v.number); });
  put(to, vertices, column, [&](const PathVertex& v) { return in_steps(double(v.feed), q.feed); });
  put(to, vertices, column, [&](const PathVertex& v) { return in_steps(double(v.speed), q.feed); });
  put(to, vertices, column, [](const PathVertex& v) { return std::int32_t(v.tool); });
  put(to, vertices, column, [](const PathVertex& v) { return std::int32_t(v.file); });
  put(to, vertices, column, [](const PathVertex& v) { return std::int32_t(v.kind); });
  put(to, vertices, column, [](const PathVertex& v) { return std::int32_t(v.level); });
  for (std::size_t axis = 0; axis < 3 && !piece.directions.empty(); ++axis) {
    column.clear();
    for (const std::size_t i : indices) column.push_back(in_steps(double(piece.directions[i][axis]), q.direction));
    to.put(column);
  }
  for (std::size_t joint = 0; joint < piece.joints(); ++joint) {
    column.clear();
    for (const std::size_t i : indices) column.push_back(in_steps(double(piece.positions[i * piece.joints() + joint]), q.position));
    to.put(column);
  }
  return to.bytes();
}

std::string packed_path(const std::vector<DrawnPiece>& pieces, const Thinning& thinning, const ReportQuanta& quanta) {
  std::string bytes;
  for (const DrawnPiece& drawn : pieces) {
    const std::string packed = packed_piece(drawn, thinning, quanta);
    PackedColumns head;
    head.put_u32(piece_of_path);
    head.put_u32(std::uint32_t(packed.size()));
    bytes += head.bytes() + packed;
  }
  return bytes;
}

}  // namespace

double Thinning::off() const {
  const int level = std::max(inner, any);
  return level == 0 ? 0 : finest_level * std::pow(2, level);
}

bool is_left_out(const ViewPiece& piece, std::size_t i, const Thinning& thinning) {
  const PathVertex& v = piece.vertices[i];
  if (i == 0 || i + 1 == piece.vertices.size()) return false;  // the ends of a segment are not omitted, because segments join there
  return v.level < thinning.any || (v.level < thinning.inner && piece.vertices[i + 1].number == v.number);
}

std::vector<DrawnPiece> drawn_pieces(const PathRecord& path, const std::vector<ViewPiece>& contour) {
  std::vector<DrawnPiece> pieces;
  for (const ViewPiece& piece : path.pieces()) pieces.push_back({&piece, 0});
  for (const ViewPiece& piece : contour) pieces.push_back({&piece, 2});
  return pieces;
}

ReportQuanta quanta_of(const std::vector<DrawnPiece>& pieces) {
  double length = 0, time = 0, feed = 0, position = 0;
  for (const DrawnPiece& drawn : pieces) {
    for (const float p : drawn.piece->positions) position = std::max(position, std::abs(double(p)));
    for (const PathVertex& v : drawn.piece->vertices) {
      for (const float c : v.at) length = std::max(length, std::abs(double(c)));
      time = std::max(time, double(v.time));
      feed = std::max({feed, double(v.feed), double(v.speed)});
    }
  }
  ReportQuanta q;
  q.length = unit_for(q.length, length), q.time = unit_for(q.time, time), q.feed = unit_for(q.feed, feed);
  q.position = unit_for(q.position, position);
  return q;
}

tl::expected<ReportPath, std::string> report_path(const std::vector<DrawnPiece>& pieces, const ReportQuanta& quanta, double most_packed) {
  const auto index_for = [&](double by_vertex) {
    std::size_t index = 0;
    while (index + 1 < thinnings.size() && double(count_left_by(pieces, thinnings[index])) * by_vertex > most_packed) ++index;
    return index;
  };
  // The variable too_long is the index of the coarsest thinning whose result was too long, plus 1; 0 if no result was too long.
  std::size_t index = index_for(first_guess), too_long = 0;
  std::optional<ReportPath> made;
  for (int tries = 0; tries < max_tries || !made; ++tries) {
    ReportPath path{packed_path(pieces, thinnings[index], quanta), thinnings[index]};
    const auto packed = zlib_packed(path.bytes);
    if (!packed) return tl::unexpected(packed.error());
    const bool fits = double(packed->size()) <= most_packed || index + 1 == thinnings.size();
    if (fits) made = std::move(path);
    else too_long = index + 1;
    const std::size_t by_now =
        index_for(double(packed->size()) / double(std::max<std::size_t>(count_left_by(pieces, thinnings[index]), 1)));
    const std::size_t next = std::max(by_now, too_long);
    if (fits && next >= index) break;
    index = std::min(fits ? next : std::max(next, index + 1), thinnings.size() - 1);
  }
  return std::move(*made);
}

}  // namespace kadr
