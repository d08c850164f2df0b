#pragma once
// PieceFollower: sends the segments of both paths, each with the difference that it belongs to, to the observer of a comparison
// (CompareRules::on_piece). Used by compare/comparison.

#include <vector>

#include "compare/comparison.h"
#include "compare/course_cursor.h"

namespace kadr {

class PieceFollower {
 public:
  ///   report  the observer, which receives the segments; empty if there is no observer
  PieceFollower(std::function<void(const ComparedPiece&)> report, const CourseSpace& space, double tolerance)
      : report_(std::move(report)), space_(space), tolerance_(tolerance) {}

  /// Sets the type (ComparedPiece::Part) and the difference that all segments get until end() is called.
  void begin(ComparedPiece::Part part, std::size_t number, double distance = 0);
  /// Starts a difference whose segments may still turn out to be common. The segments are stored and not sent until this is known. They
  /// belong to the difference only if they lead farther than the tolerance from the position `here`.
  void begin_waiting(std::size_t number, const Axes& here);
  /// Ends what begin() or begin_waiting() started. If `counts` is true, segments that are stored and not sent yet belong to the difference.
  void end(bool counts = true);

  void take(const CourseItem& item, const Axes& from, const Axes& to, bool of_b);

  /// Returns the numbers of the files that the segments come from, except the programs themselves. The caller adds the names.
  std::map<std::uint16_t, std::string>& files(bool of_b) { return of_b ? files_b_ : files_a_; }

 private:
  void let_go(ComparedPiece::Part part);

  std::function<void(const ComparedPiece&)> report_;
  const CourseSpace& space_;
  double tolerance_;
  ComparedPiece now_;  // values that all segments have in common until end() is called
  Axes here_{};
  bool waits_ = false;
  std::vector<ComparedPiece> waiting_;
  std::map<std::uint16_t, std::string> files_a_, files_b_;
};

}  // namespace kadr
