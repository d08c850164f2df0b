#pragma once
// ContourWatch: detects where the tool cuts into the part. A control only compares neighbouring blocks (nct 15.5.7); this compares all
// blocks within a range, and reports what the control would do.
//
// The part's boundary is the programmed contour without run-in and run-out, which cross each other or lead to a point of it and away
// (path/contour/contour_closing): where the tool's centre comes nearer to the boundary than the radius, it cuts into the part. Run-in and
// run-out are only known at the end: until then each piece of the contour keeps the deepest cut into it.

#include <array>
#include <optional>
#include <vector>

#include "action/action.h"
#include "base/made_in.h"
#include "path/curve/plane_distance.h"

namespace kadr {

/// The deepest cut of the tool into the part.
struct ContourCut {
  double depth = 0;  // mm
  Origin tool;       // block of the tool's path
  Origin contour;    // block of the contour
};

/// Contour pieces, by number, that a piece of path is not compared with, because it lies on their offset according to the corner rules.
struct ContourSpan {
  std::uint64_t first = 1, last = 0;  // empty
};

class ContourWatch {
 public:
  /// Adds a piece of the programmed contour. `radius`: of the tool, mm.
  ///   returns  its number
  std::uint64_t contour(const ContourElement& element, double radius, const Origin& origin);
  /// Adds a piece of the tool centre's path, which `way` returns.
  template <class Make>
  void path(const Make& way, double radius, const Origin& origin, ContourSpan known) {
    if (path_.loses_first()) path_.keep_first();
    compare_path(path_.add(way, radius, origin), known);
  }
  /// Ends the contour. Returns the deepest cut into the part, if one was deeper than tol::same_point. Forgets everything.
  ///   law  there is no cut if the path is nowhere nearer than the radius to the last `reach` pieces or to the next `reach` pieces of the
  ///        contour; nor if it is so only at the run-in and the run-out
  ///   law  the end of the contour is compared with its start, however long it is
  std::optional<ContourCut> end();

  static constexpr std::size_t reach = 40;  // pieces; steps round corners count too

 private:
  static constexpr std::size_t group_size = 8, groups = reach / group_size + 1;

  struct Seen {
    PlanePiece piece;
    double radius = 0;
    Origin origin;
    std::uint64_t number = 0;
  };
  /// The last pieces, in groups with a bounding box each: most groups are far away and are skipped as a whole. Also the first pieces,
  /// after they have left the ring.
  struct Ring {
    std::array<Seen, group_size * groups> at;
    std::array<Box2, groups> boxes;
    std::vector<Seen> first;
    std::uint64_t count = 0;
    std::size_t place = 0;  // index for the next piece
    /// True if the next piece replaces one of the first, which must then be kept.
    bool loses_first() const { return count - at.size() < at.size(); }  // wraps below 0
    void keep_first() { first.push_back(at[place]); }
    template <class Make>
    const Seen& add(const Make& piece, double radius, const Origin& origin);
    /// Calls `found` for the pieces whose boxes are nearer to that of `piece` than `distance`.
    template <class Found>
    void near(const PlanePiece& piece, double distance, const Found& found) const;
    /// Calls `found` for the first pieces and the last ones, in order.
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
  void anew(const Seen& contour, const PlanePiece& piece);
  ContourCut& cut_into(std::uint64_t number);

  Ring contour_, path_;
  std::array<ContourCut, group_size * groups> cuts_;  // the deepest cuts into the pieces of the ring
  std::vector<ContourCut> first_cuts_;                // the deepest cuts into the first pieces
  ContourCut worst_;                                  // the deepest cut into the pieces between
  bool any_ = false;
};

template <class Make>
const ContourWatch::Seen& ContourWatch::Ring::add(const Make& piece, double radius, const Origin& origin) {
  const std::size_t i = place, group = i / group_size;
  place = i + 1 == at.size() ? 0 : i + 1;
  made_in(at[i].piece, piece);
  at[i].radius = radius;
  at[i].origin = origin;
  at[i].number = count++;
  const Box2& box = at[i].piece.box;
  if (i % group_size == 0) boxes[group] = box;
  else boxes[group].take(box.least), boxes[group].take(box.most);
  return at[i];
}

}  // namespace kadr
