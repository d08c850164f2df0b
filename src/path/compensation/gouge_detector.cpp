// GougeDetector detects positions at which the tool cuts into the workpiece. A control compares only neighbouring blocks (nct 15.5.7). Used
// by path/compensation/radius_compensation; tested by tests/path/gouge_detector_test.cpp.

#include "path/compensation/gouge_detector.h"

#include <algorithm>
#include <utility>

#include "base/tolerance.h"
#include "path/compensation/contour_closing.h"

namespace kadr {
namespace {

bool overlap(const Box2& a, const Box2& b) {
  return a.least.x < b.most.x && b.least.x < a.most.x && a.least.y < b.most.y && b.least.y < a.most.y;
}

}  // namespace

template <class Found>
void GougeDetector::Ring::near(const PlanePiece& piece, double distance, const Found& found) const {
  const std::uint64_t filled = std::min<std::uint64_t>(count, at.size());
  const Vec2 margin{distance, distance};
  const Box2 around{piece.box.least - margin, piece.box.most + margin};
  for (std::size_t group = 0; group * group_size < filled; ++group) {
    if (!overlap(boxes[group], around)) continue;
    const std::uint64_t end = std::min<std::uint64_t>(filled, (group + 1) * group_size);
    for (std::size_t i = group * group_size; i < end; ++i)
      if (overlap(at[i].piece.box, around)) found(at[i]);
  }
}

template <class Found>
void GougeDetector::Ring::each(const Found& found) const {
  for (const Seen& seen : first) found(seen);
  for (std::uint64_t n = count - std::min<std::uint64_t>(count, at.size()); n < count; ++n) found(at[n % at.size()]);
}

std::uint64_t GougeDetector::contour(const ContourElement& element, double radius, const Origin& origin) {
  if (contour_.loses_first() || (any_ && contour_.count >= cuts_.size())) make_room();
  const Seen& seen = contour_.add([&] { return PlanePiece::of(element); }, radius, origin);
  path_.near(seen.piece, radius, [&](const Seen& path) { compare(seen, path); });
  return seen.number;
}

/// Handles the contour piece that leaves the ring buffer. If this piece is one of the first pieces, the cut into the piece is stored. Of
/// the cuts into later pieces only the deepest is stored.
void GougeDetector::make_room() {
  ContourGouge& cut = cuts_[contour_.place];
  if (contour_.loses_first()) {
    contour_.keep_first();
    first_cuts_.push_back(cut);
  } else if (cut.depth > worst_.depth) {
    worst_ = cut;
  }
  cut.depth = 0;
}

ContourGouge& GougeDetector::cut_into(std::uint64_t number) {
  return number < first_cuts_.size() ? first_cuts_[number] : cuts_[number % cuts_.size()];
}

void GougeDetector::compare_path(const Seen& path, ContourSpan known) {
  contour_.near(path.piece, path.radius, [&](const Seen& contour) {
    if (contour.number < known.first || contour.number > known.last) compare(contour, path);
  });
}

void GougeDetector::compare(const Seen& contour, const Seen& path) {
  const double allowed = std::min(contour.radius, path.radius) - tol::same_point - contour.piece.slack - path.piece.slack;
  if (allowed <= 0) return;
  const double depth = allowed - distance(contour.piece, path.piece);
  if (depth <= 0) return;
  ContourGouge& cut = cut_into(contour.number);
  if (depth > cut.depth) cut = {depth, path.origin, contour.origin};
  any_ = true;
}

/// Compares the first pieces with the last pieces of a contour that is longer than the ring buffer. These pieces have not been compared
/// with each other yet.
void GougeDetector::compare_ends() {
  for (const Seen& path : path_.first) compare_path(path, {});
  for (const Seen& contour : contour_.first) path_.near(contour.piece, contour.radius, [&](const Seen& path) { compare(contour, path); });
}

/// Recomputes the deepest cut into a contour piece. Only the section `piece` of the contour piece bounds the workpiece.
void GougeDetector::compare_again(const Seen& contour, const PlanePiece& piece) {
  if (cut_into(contour.number).depth == 0) return;
  cut_into(contour.number).depth = 0;
  Seen rest = contour;
  rest.piece = piece;
  path_.each([&](const Seen& path) { compare(rest, path); });
}

/// Removes the cuts into the run-in and the run-out, because these do not bound the workpiece.
void GougeDetector::leave_out_tails() {
  std::vector<Seen> seen;
  std::vector<PlanePiece> pieces;
  contour_.each([&](const Seen& contour) { seen.push_back(contour), pieces.push_back(contour.piece); });
  const bool parted = contour_.count > seen.size();
  const auto loop = closing(pieces, parted ? contour_.first.size() : 0);
  if (!loop) return;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (i < loop->first || i > loop->last) cut_into(seen[i].number).depth = 0;
    else if (i == loop->first || i == loop->last)
      compare_again(seen[i], cut_out(pieces[i], i == loop->first ? loop->first_part : 0, i == loop->last ? loop->last_part : 1));
  }
}

std::optional<ContourGouge> GougeDetector::end() {
  if (contour_.count > cuts_.size() || path_.count > cuts_.size()) compare_ends();
  ContourGouge worst = std::exchange(worst_, {});
  if (std::exchange(any_, false)) {
    leave_out_tails();
    for (const ContourGouge& cut : first_cuts_)
      if (cut.depth > worst.depth) worst = cut;
    for (ContourGouge& cut : cuts_) {
      if (cut.depth > worst.depth) worst = cut;
      cut.depth = 0;
    }
  }
  contour_.clear();
  path_.clear();
  first_cuts_.clear();
  if (worst.depth == 0) return std::nullopt;
  return worst;
}

}  // namespace kadr
