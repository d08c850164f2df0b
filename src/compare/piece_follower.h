#pragma once
// PieceFollower: passes the pieces of both paths, and the difference that they belong to, to the observer of a comparison. Used by
// compare/comparison.

#include <vector>

#include "compare/comparison.h"
#include "compare/lane.h"

namespace kadr {

class PieceFollower {
 public:
  ///   told  receives the pieces; empty if nobody follows
  PieceFollower(std::function<void(const ComparedPiece&)> told, const CourseSpace& space, double tolerance)
      : told_(std::move(told)), space_(space), tolerance_(tolerance) {}

  /// Sets part and difference of the pieces until end().
  void begin(ComparedPiece::Part part, std::size_t number, double distance = 0);
  /// The pieces belong to the difference only if they lead farther than the tolerance from here; until then they wait.
  void begin_waiting(std::size_t number, const Axes& here);
  ///   counts  pieces that still wait belong to the difference
  void end(bool counts = true);

  void take(const CourseItem& item, const Axes& from, const Axes& to, bool of_b);

  /// The files of the pieces, except the programs themselves; the caller fills in their names.
  std::map<std::uint16_t, std::string>& files(bool of_b) { return of_b ? files_b_ : files_a_; }

 private:
  void let_go(ComparedPiece::Part part);

  std::function<void(const ComparedPiece&)> told_;
  const CourseSpace& space_;
  double tolerance_;
  ComparedPiece now_;  // what the pieces have in common
  Axes here_{};
  bool waits_ = false;
  std::vector<ComparedPiece> waiting_;
  std::map<std::uint16_t, std::string> files_a_, files_b_;
};

}  // namespace kadr
