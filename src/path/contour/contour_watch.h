#pragma once
// ContourWatch: does the tool cut into the part? A control only looks at the blocks next to each other (nct 15.5.7); this looks at all
// that lie within some blocks, and tells what the control would do.
//
// The part's boundary is the programmed contour, without the run-in and run-out that cross each other or lead to a point of it and away
// (path/contour/contour_closing): where the tool's centre comes nearer to it than the radius, it cuts into the material that lies after.
// What run-in and run-out look like is known at the end only: until then each piece of the contour keeps the deepest cut into it.

#include <array>
#include <optional>
#include <vector>

#include "action/action.h"
#include "base/made_in.h"
#include "path/curve/plane_distance.h"

namespace kadr {

/// The deepest place where the tool cuts into the part.
struct ContourCut {
  double depth = 0;  // mm
  Origin tool;       // block of the tool's path
  Origin contour;    // block of the contour
};

/// Contour pieces, by number, that a piece of path need not be compared with: it lies on their offset, as the corner rules made it.
struct ContourSpan {
  std::uint64_t first = 1, last = 0;  // none
};

class ContourWatch {
 public:
  /// A piece of the programmed contour. `radius`: of the tool, mm.
  ///   returns  its number
  std::uint64_t contour(const ContourElement& element, double radius, const Origin& origin);
  /// A piece of the way of the tool's centre: `way` returns it.
  template <class Make>
  void path(const Make& way, double radius, const Origin& origin, ContourSpan known) {
    if (path_.loses_first()) path_.keep_first();
    compare_path(path_.add(way, radius, origin), known);
  }
  /// The contour is over: the deepest cut into the part, if there was one deeper than tol::same_point. Forgets all.
  ///   law  a way that is nowhere nearer to the last `reach` pieces, or those of the next `reach`, than the radius gives none; nor one
  ///        that is so on the run-in and the run-out alone
  ///   law  the end of the contour is compared with its beginning, however long it is
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
  /// The last pieces, in groups with a box around each: most are far away, and nothing else of them is looked at. And the first ones,
  /// once they have left the row.
  struct Ring {
    std::array<Seen, group_size * groups> at;
    std::array<Box2, groups> boxes;
    std::vector<Seen> first;
    std::uint64_t count = 0;
    std::size_t place = 0;  // of the next
    /// The next takes the place of one of the first: that is kept.
    bool loses_first() const { return count - at.size() < at.size(); }  // wraps below
    void keep_first() { first.push_back(at[place]); }
    template <class Make>
    const Seen& add(const Make& piece, double radius, const Origin& origin);
    /// Calls back with those whose boxes come nearer to that of `piece` than `distance`.
    template <class Found>
    void near(const PlanePiece& piece, double distance, const Found& found) const;
    /// Calls back with the first ones and the last ones, in their order.
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
  std::array<ContourCut, group_size * groups> cuts_;  // deepest ones, into the pieces of the ring
  std::vector<ContourCut> first_cuts_;                // … into the first ones
  ContourCut worst_;                                  // … into those between
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
