#pragma once
// ContourWatch: does the tool's path come nearer to the contour than its radius? A control only looks at the blocks next to each other
// (nct 15.5.7); this looks at all that lie within some blocks, and tells what the control would do to the part.

#include <array>
#include <optional>

#include "base/made_in.h"
#include "control/action.h"
#include "path/plane_distance.h"

namespace kadr {

/// The deepest place where the tool cuts into the contour.
struct ContourCut {
  double depth = 0;           // mm
  Origin tool;                // block of the tool's path
  std::uint32_t contour = 0;  // line of the contour's block
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
    compare_path(path_.add(way, radius, origin), known);
  }
  /// The contour is over: the deepest cut, if there was one deeper than tol::same_point. Forgets all.
  ///   law  a way that is nowhere nearer to the last `reach` pieces, or those of the next `reach`, than the radius gives none
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
  /// The last pieces, in groups with a box around each: most are far away, and nothing else of them is looked at.
  struct Ring {
    std::array<Seen, group_size * groups> at;
    std::array<Box2, groups> boxes;
    std::uint64_t count = 0;
    template <class Make>
    const Seen& add(const Make& piece, double radius, const Origin& origin);
    /// Calls back with those whose boxes come nearer to that of `piece` than `distance`.
    template <class Found>
    void near(const PlanePiece& piece, double distance, const Found& found) const;
  };
  void compare_path(const Seen& path, ContourSpan known);
  void compare(const Seen& contour, const Seen& path);

  Ring contour_, path_;
  ContourCut worst_;
};

template <class Make>
const ContourWatch::Seen& ContourWatch::Ring::add(const Make& piece, double radius, const Origin& origin) {
  const std::size_t i = count % at.size(), group = i / group_size;
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
