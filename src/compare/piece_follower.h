#pragma once
// PieceFollower: tells whoever follows a comparison the pieces of both ways, and which difference they belong to. For compare/comparison.

#include <vector>

#include "compare/comparison.h"
#include "compare/lane.h"

namespace kadr {

class PieceFollower {
 public:
  /// `told`: empty: nobody follows.
  PieceFollower(std::function<void(const ComparedPiece&)> told, const CourseSpace& space, double tolerance)
      : told_(std::move(told)), space_(space), tolerance_(tolerance) {}

  /// Of the pieces until end().
  void begin(ComparedPiece::Part part, std::size_t number, double distance = 0);
  /// They are the difference only if they lead farther than the tolerance from here: until then they wait.
  void begin_waiting(std::size_t number, const Axes& here);
  /// `counts`: those that still wait are the difference.
  void end(bool counts = true);

  void take(const CourseItem& item, const Axes& from, const Axes& to, bool of_b);

  /// Files that pieces stood in, but for the programs themselves; their names are the caller's.
  std::map<std::uint16_t, std::string>& files(bool of_b) { return of_b ? files_b_ : files_a_; }

 private:
  void let_go(ComparedPiece::Part part);

  std::function<void(const ComparedPiece&)> told_;
  const CourseSpace& space_;
  double tolerance_;
  ComparedPiece now_;  // what pieces have in common
  Axes here_{};
  bool waits_ = false;
  std::vector<ComparedPiece> waiting_;
  std::map<std::uint16_t, std::string> files_a_, files_b_;
};

}  // namespace kadr
