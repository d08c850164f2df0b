#pragma once
// The passes of Fanuc's multiple repetitive turning cycles G71, G72 and G73 (spec/fanuc-t 9.2 to 9.5), one motion at a time. A generator
// needs constant memory apart from the figure, and a copy of it continues with the same motion. Pure geometry, in the plane of the cycle:
// the x of a point is the first axis of the plane (Z), its y the second one (X as a radius); mm.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "control/fanuc/lathe/rough_figure.h"
#include "control/fanuc/turning/contour_piece.h"

namespace kadr::fanuc {

/// A motion of a cycle. It may be shorter than tol::level, and then means nothing to the machine. `ends_pass`: a pass of the cycle ends
/// with this motion.
struct RoughStep {
  ContourPiece motion;
  bool ends_pass = false;
};

/// The passes of G71 and G72, type I and II.
///   law  a motion at rapid does not enter stock that is still there, provided that no stock lies before A' along the passes or above S+δ
///   law  a cut removes at most the depth of a pass
class RoughPasses {
 public:
  struct Plan {
    double depth = 0;          // Δd: distance of two levels, mm, greater than 0
    double back = 0;           // e: escape after a cut, mm
    double clearance = 0;      // 5134: distance in mm before a pocket at which the rapid ends; 0: the escape is this distance
    bool along_figure = true;  // the last pass follows the figure (false: RF1 or RF2 of 5105)
    // displacement in the plane of a further pass along the figure, which takes off a rough allowance (spec/haas-st 6.2); nullopt: none
    std::optional<Vec2> further;
  };
  ///   figure  a figure without a fault
  RoughPasses(RoughFigure figure, const Plan& plan);

  /// Returns the next motion, or nothing after the motion back to S.
  std::optional<RoughStep> next();

 private:
  enum class Stage : std::uint8_t { to_shifted_start, levels, along_figure, further, home, done };
  enum class Path : std::uint8_t { line, follow, whole_figure, home };
  /// A part of a pass: a line, motions along the figure, or the line to S. Points are in figure coordinates.
  struct Order {
    Path path = Path::line;
    MotionKind kind = MotionKind::rapid;
    Vec2 to;
    FigurePlace from, until;  // `follow`: the part of the figure
    bool ends_pass = false;
  };

  double level(double number) const { return number * plan_.depth; }
  void line(MotionKind kind, Vec2 to);
  void follow(const FigurePlace& from, const FigurePlace& until);
  std::optional<RoughStep> execute(Order& order);

  void order_more();
  bool order_level();
  bool order_pocket_level();
  void order_infeed();
  void order_entry_into_pocket();
  void order_along_figure();
  void order_further();
  void order_home();
  void rise_to(double depth);
  double clear_depth(const FigurePlace& place) const;
  bool find_stretch();
  bool find_next_sibling();

  RoughFigure figure_;
  Plan plan_;
  double entry_x_;  // x at which the tool is fed in before A'
  Stage stage_ = Stage::to_shifted_start;
  std::array<Order, 8> orders_{};
  std::size_t ordered_ = 0, done_ = 0;
  std::size_t piece_ = 0;  // the next piece of the pass along the figure
  Vec2 shift_;             // displacement of this pass in the plane
  Vec2 at_;                // the tool in the plane after the last motion returned
  Vec2 planned_;           // the tool in figure coordinates after the last order

  double number_ = 0;  // of the level
  // type II: the stretch being cut, the place on the figure from which the tool goes there, the depth cut at this place, the place where
  // the tool last left the figure, and whether the stretch cut last is open
  bool begun_ = false, last_open_ = true;
  Stretch stretch_;
  FigurePlace entry_, left_;
  double cut_at_entry_ = 0;
};

/// The passes of G73: the figure d times, each time shifted less.
class PatternPasses {
 public:
  struct Plan {
    Vec2 allowance;            // δ = (Δw, Δu/2)
    Vec2 relief;               // (Δk, Δi): shift of the first pass relative to the last one
    std::uint32_t passes = 1;  // d, at least 1
  };
  ///   contour  as for RoughFigure: the first line leads from S to A'
  PatternPasses(std::vector<ContourPiece> contour, const Plan& plan);

  /// Returns the next motion, or nothing after the motion back to S.
  std::optional<RoughStep> next();

 private:
  Vec2 shift() const;

  std::vector<ContourPiece> contour_;
  Plan plan_;
  std::uint32_t pass_ = 0;
  std::size_t next_ = 0;  // 0: the rapid to the pass's start point; then the pieces of the contour, counted from 1
  Vec2 at_;
};

}  // namespace kadr::fanuc
