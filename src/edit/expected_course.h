#pragma once
// ExpectedCourse: changes the course of the old program to what the edits ask of the new program: other feeds, speeds and tools; positions
// mapped in the XY plane; pieces of the course repeated at other places, or run backwards.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/comparison.h"
#include "edit/edits.h"

namespace kadr {

class ExpectedCourse {
 public:
  ///   edits  must outlive this object
  ///   axes   names of the axes, in the order of the course
  ///   start  position at which the old program begins, machine coordinates
  ExpectedCourse(const Edits& edits, const std::vector<std::string>& axes, const Axes& start);

  /// Takes all items of `from`, and appends the items that are expected instead.
  void take(ItemRing& from, ItemRing& to);

 private:
  void change_state(CourseItem& item) const;
  void put(const CourseItem& item, const PlaneMap* map, bool commands_all, ItemRing& to);
  bool must_lead_back(const CourseItem& item);
  void repeat(ItemRing& to);
  void reverse(ItemRing& to);
  std::optional<std::size_t> piece_of(const CourseItem& item) const;
  void end_piece(ItemRing& to);

  const Edits& edits_;
  std::size_t axes_;
  int x_ = -1, y_ = -1;  // indices of the axes X and Y; -1: there is no such axis
  Axes raw_{}, now_{};   // position in the old and in the new program
  // The tool stands at another place than in the old program, because a piece was repeated or reversed before
  bool is_elsewhere_ = false;
  bool is_copy_ = false;          // the items of a repeated piece are being appended
  std::vector<CourseItem> held_;  // items of the piece of the course that is repeated or reversed
  Axes held_from_{};              // position of the old program at the start of the piece
  std::optional<std::size_t> piece_;
};

}  // namespace kadr
