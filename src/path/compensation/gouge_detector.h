#pragma once
// GougeDetector detects positions at which the tool cuts into the workpiece. A control compares only neighbouring blocks (nct 15.5.7).
// GougeDetector compares all blocks within a range, so it reports damage that the control would cause without an alarm.
//
// The boundary of the workpiece is the programmed contour without its run-in and run-out (path/compensation/contour_closing). These cross
// each other, or they lead to a point of the contour and away from it. If the tool's centre comes nearer to the boundary than the tool
// radius, the tool cuts into the workpiece. Run-in and run-out are known only at the end of the contour. Until then the deepest cut into
// each piece of the contour is stored.

#include <array>
#include <optional>
#include <vector>

#include "action/action.h"
#include "base/construct_in_place.h"
#include "path/curve/plane_distance.h"

namespace kadr {

/// The deepest cut of the tool into the workpiece.
struct ContourGouge {
  double depth = 0;  // depth of the cut into the workpiece, mm
  Origin tool;       // block whose tool path causes the cut
  Origin contour;    // block of the contour into which the tool cuts
};

/// A range of contour pieces, by their numbers, with which a piece of the tool's path is not compared. The corner rules guarantee that the
/// path lies on the offset of these pieces.
struct ContourSpan {
  std::uint64_t first = 1, last = 0;  // The default is an empty range: the path is compared with all contour pieces.
};

class GougeDetector {
 public:
  /// Adds a piece of the programmed contour. `radius` is the tool radius in mm.
  ///   returns  the number of the piece
  std::uint64_t contour(const ContourElement& element, double radius, const Origin& origin);
  /// Adds a piece of the path of the tool's centre. `make` is a function that returns the piece.
  template <class Make>
  void path(const Make& make, double radius, const Origin& origin, ContourSpan known) {
    if (path_.loses_first()) path_.keep_first();
    compare_path(path_.add(make, radius, origin), known);
  }
  /// Ends the contour and clears all data. Returns the deepest cut into the workpiece if this cut is deeper than tol::same_point; otherwise
  /// nullopt.
  ///   law  no cut is reported if the distance of each piece of the path from the last `reach` and the next `reach` contour pieces is at
  ///        least the radius, except at the run-in and the run-out
  ///   law  the end of the contour is compared with its start, whatever the length of the contour is
  std::optional<ContourGouge> end();

  // Number of contour pieces, before and after a piece of the tool's path, with which this piece is compared. Short moves around corners
  // count as pieces too.
  static constexpr std::size_t reach = 40;

 private:
  static constexpr std::size_t group_size = 8, groups = reach / group_size + 1;

  struct Seen {
    PlanePiece piece;
    double radius = 0;
    Origin origin;
    std::uint64_t number = 0;
  };
  /// The last pieces of a path, in a ring buffer of groups. Each group has a bounding box. Most groups are far away from the tool, so they
  /// are skipped as a whole. `first` stores the first pieces of the path after they have left the ring buffer.
  struct Ring {
    std::array<Seen, group_size * groups> at;
    std::array<Box2, groups> boxes;
    std::vector<Seen> first;
    std::uint64_t count = 0;
    std::size_t place = 0;  // index in the ring buffer at which the next piece is stored
    /// True if the next piece overwrites one of the path's first pieces in the ring buffer. The caller must then copy this first piece to
    /// `first`.
    // The difference of the numbers is unsigned, so the result is false as long as the ring buffer is not full.
    bool loses_first() const { return count - at.size() < at.size(); }
    void keep_first() { first.push_back(at[place]); }
    template <class Make>
    const Seen& add(const Make& piece, double radius, const Origin& origin);
    /// Calls `found` for each stored piece if the distance between its bounding box and the bounding box of `piece` is less than
    /// `distance`, mm.
    template <class Found>
    void near(const PlanePiece& piece, double distance, const Found& found) const;
    /// Calls `found` for the first pieces and then for the last pieces, in the order of the contour.
    template <class Found>
    void each(const Found& found) const;
    void clear() {
      count = place = 0;
      first.clear();
    }
  };
  void make_room();
  void compare_path(const Seen& path, ContourSpan known);
  void compare(const Seen& contour, const Seen& path);
  void compare_ends();
  void leave_out_tails();
  void compare_again(const Seen& contour, const PlanePiece& piece);
  ContourGouge& cut_into(std::uint64_t number);

  Ring contour_, path_;
  std::array<ContourGouge, group_size * groups> cuts_;  // the deepest cut of the tool into each contour piece in the ring buffer
  std::vector<ContourGouge> first_cuts_;                // the deepest cut of the tool into each of the first pieces of the contour
  // the deepest cut into contour pieces that have left the ring buffer and are not among the first pieces of the contour
  ContourGouge worst_;
  bool any_ = false;
};

template <class Make>
const GougeDetector::Seen& GougeDetector::Ring::add(const Make& piece, double radius, const Origin& origin) {
  const std::size_t i = place, group = i / group_size;
  place = i + 1 == at.size() ? 0 : i + 1;
  construct_in_place(at[i].piece, piece);
  at[i].radius = radius;
  at[i].origin = origin;
  at[i].number = count++;
  const Box2& box = at[i].piece.box;
  if (i % group_size == 0) boxes[group] = box;
  else boxes[group].take(box.least), boxes[group].take(box.most);
  return at[i];
}

}  // namespace kadr
