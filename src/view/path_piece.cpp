// Computes levels of detail and binary frames of a segment of a path (ViewPiece). Used by view/path_record; tested by
// tests/view/path_piece_test.cpp.

#include "view/path_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/matrix.h"
#include "view/frame_bytes.h"

namespace kadr {
namespace {

constexpr std::size_t levels = 16;
// Levels are computed for this many vertices together. This limits the number of distances to some eight per vertex.
constexpr std::size_t run_length = 256;

double distance_to_chord(Vec3 p, Vec3 from, Vec3 to) {
  const Vec3 delta = to - from;
  const double square = dot(delta, delta);
  const double along = square > 0 ? std::clamp(dot(p - from, delta) / square, 0.0, 1.0) : 0;
  return length(p - (from + along * delta));
}

std::uint8_t level_of(double off) {
  if (!(off > finest_level)) return 0;
  return std::uint8_t(std::min(double(levels - 1), std::floor(std::log2(off / finest_level))));
}

/// Returns true if the tool, the kind of motion, the feed or the file changes at this vertex, which therefore remains at every level.
bool is_boundary(const PathVertex& a, const PathVertex& b) {
  return a.kind != b.kind || a.tool != b.tool || a.file != b.file || a.feed != b.feed || b.kind == PathKind::jump;
}

/// Sets the levels by the algorithm of Douglas and Peucker. No vertex gets a higher level than the vertex that divided its segment, so that
/// each level contains all vertices of the higher levels.
void divide(std::vector<PathVertex>& v, std::size_t first, std::size_t last, double most) {
  while (last - first > 1) {
    const Vec3 from = v[first].place(), to = v[last].place();
    double farthest = -1;
    std::size_t at = first + 1;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distance_to_chord(v[i].place(), from, to);
      if (off > farthest) farthest = off, at = i;
    }
    const double off = std::min(farthest, most);
    v[at].level = level_of(off);
    // Recursion for the shorter segment, and a loop for the longer segment, limit the depth to log2 of the number of vertices.
    if (at - first < last - at) divide(v, first, at, off), first = at;
    else divide(v, at, last, off), last = at;
    most = off;
  }
}

std::array<std::uint16_t, levels> counts_by_level(const ViewPiece& piece) {
  std::array<std::uint16_t, levels> counts{};
  for (const PathVertex& v : piece.vertices)
    for (std::size_t l = 0; l <= v.level; ++l) ++counts[l];
  return counts;
}

void put_head(FrameBytes& frame, const ViewPiece& piece) {
  constexpr float big = std::numeric_limits<float>::max();
  std::array<float, 3> least{big, big, big}, greatest{-big, -big, -big};
  for (const PathVertex& v : piece.vertices)
    for (std::size_t i = 0; i < 3; ++i) least[i] = std::min(least[i], v.at[i]), greatest[i] = std::max(greatest[i], v.at[i]);
  frame.put(piece.begins);
  frame.put(least);
  frame.put(greatest);
  frame.put(piece.first);
  frame.put(piece.vertices.front().number);
  frame.put(counts_by_level(piece));
  frame.put(std::uint64_t{0});
}

}  // namespace

void set_levels(ViewPiece& piece) {
  std::vector<PathVertex>& v = piece.vertices;
  if (v.empty()) return;
  v.front().level = v.back().level = levels - 1;
  for (std::size_t first = 0; first + 1 < v.size();) {
    std::size_t last = first + 1;
    while (last + 1 < v.size() && last - first < run_length && !is_boundary(v[last], v[last + 1])) ++last;
    v[last].level = levels - 1;
    divide(v, first, last, std::numeric_limits<double>::infinity());
    first = last;
  }
}

std::string path_frame(const ViewPiece& piece, std::uint32_t which, std::uint32_t channel) {
  const std::vector<PathVertex>& v = piece.vertices;
  FrameBytes frame(1, which, std::uint32_t(v.size()), channel);
  constexpr std::size_t head = 96, row = 40;
  frame.reserve(head + row * v.size());
  put_head(frame, piece);
  for (const PathVertex& x : v) frame.put(x.at);
  for (const PathVertex& x : v) frame.put(x.time);
  for (const PathVertex& x : v) frame.put(x.line);
  for (const PathVertex& x : v) frame.put(x.number);
  for (const PathVertex& x : v) frame.put(x.feed);
  for (const PathVertex& x : v) frame.put(x.speed);
  for (const PathVertex& x : v) frame.put(x.tool), frame.put(x.file);
  for (const PathVertex& x : v) frame.put(x.kind), frame.put(x.level), frame.put(std::uint16_t{0});
  return frame.take();
}

std::string directions_frame(const ViewPiece& piece, std::uint32_t which, std::uint32_t channel) {
  FrameBytes frame(2, which, std::uint32_t(piece.directions.size()), channel);
  frame.put_all(piece.directions.data(), piece.directions.size());
  return frame.take();
}

std::string positions_frame(const ViewPiece& piece, std::uint32_t which, std::uint32_t channel) {
  FrameBytes frame(4, which, std::uint32_t(piece.vertices.size()), channel);
  frame.put_all(piece.positions.data(), piece.positions.size());
  return frame.take();
}

}  // namespace kadr
