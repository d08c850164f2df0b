// PieceFollower: sends the segments of a comparison to its observer. Used by compare/comparison; tested by
// tests/compare/comparison_test.cpp.

#include "compare/piece_follower.h"

namespace kadr {
namespace {

// Greatest number of segments that are stored near one position. If there are more, all are sent as Part::together.
constexpr std::size_t max_waiting = 1000;

}  // namespace

void PieceFollower::begin(ComparedPiece::Part part, std::size_t number, double distance) {
  now_.part = part, now_.number = number, now_.distance = distance;
  waits_ = false;
}

void PieceFollower::begin_waiting(std::size_t number, const Axes& here) {
  begin(ComparedPiece::Part::changed, number);
  here_ = here;
  waits_ = true;
}

void PieceFollower::end(bool counts) {
  let_go(counts ? now_.part : ComparedPiece::Part::together);
  now_ = {};
  waits_ = false;
}

void PieceFollower::let_go(ComparedPiece::Part part) {
  for (ComparedPiece& piece : waiting_) piece.part = part, report_(piece);
  waiting_.clear();
}

void PieceFollower::take(const CourseItem& item, const Axes& from, const Axes& to, bool of_b) {
  if (!report_) return;
  const bool act = item.kind != CourseItem::Kind::move;
  if (act && now_.part == ComparedPiece::Part::together) return;
  ComparedPiece piece = now_;
  piece.of_b = of_b, piece.act = act;
  piece.move = item.state.move;
  piece.from = from, piece.to = to;
  piece.origin = item.origin;
  if (item.origin.file != 0) files(of_b)[item.origin.file];
  if (!waits_) return report_(piece);
  waiting_.push_back(piece);
  if (!of_b && space_.distance(here_, to) > tolerance_) {
    let_go(ComparedPiece::Part::changed);
    waits_ = false;
  } else if (waiting_.size() > max_waiting) {
    let_go(ComparedPiece::Part::together);
  }
}

}  // namespace kadr
