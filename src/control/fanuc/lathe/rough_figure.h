#pragma once
// The figure of Fanuc's roughing cycles G71 and G72 (spec/fanuc-t 9.1 to 9.4), in the coordinates in which its passes are computed. Pure
// geometry: this file knows nothing of programs and machines.
//
//   S+δ ─────────► x: along the passes
//    │  ═══════════► pass at a level, up to the figure
//    ▼           ╭────
//    y: depth ───╯ figure, from A' on

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "control/fanuc/turning/contour_piece.h"

namespace kadr::fanuc {

/// What the figure of a cycle violates (9.2). The axes are those of the plane, whichever of them the passes follow.
enum class FigureFault : std::uint8_t {
  none,
  first_axis,   // the first axis reverses by more than is permitted (PS0064, parameter 5145)
  second_axis,  // the second axis reverses by more than is permitted (PS0329, parameter 5146)
  over_start,   // the figure passes the start point in the direction of the infeed (PS0322)
  first_block,  // the first block of the figure is an arc (PS0065)
};

/// A point on the figure: on which of its sections the point lies, and at which fraction 0 … 1 of the section.
struct FigurePlace {
  std::size_t section = 0;
  double part = 0;
  Vec2 point;  // in figure coordinates

  bool before(const FigurePlace& other) const { return section != other.section ? section < other.section : part < other.part; }
};

/// A piece of the figure that is deeper than a level and as long as possible. `open`: it begins at A', the first point of the figure.
struct Stretch {
  FigurePlace begin, end;
  bool open = false;
};

/// The figure from A' on, shifted by the finishing allowance. In figure coordinates the point S+δ, where the cycle's start point S comes to
/// lie by this shift, is the origin (with `levels_from_start` its depth is that of S); x grows along the passes towards the end of the
/// figure, and y into the material.
class RoughFigure {
 public:
  struct Settings {
    bool facing = false;      // G72: the passes follow the plane's second axis, and the levels lie along its first one
    bool pockets = false;     // type II: only the axis along the passes must not reverse
    Vec2 allowance;           // δ = (Δw, Δu/2), mm in the plane
    Vec2 reversal_permitted;  // parameters 5145 and 5146: by how many mm the first and the second axis may reverse
    // the levels count from S, not from S+δ, and with pockets the last block may lead beyond S (spec/haas-st 6.2, 6.3)
    bool levels_from_start = false;
  };
  ///   contour  lines and arcs of the figure in the plane, mm, without allowance; the first one leads from S to A'. Not empty
  RoughFigure(const std::vector<ContourPiece>& contour, const Settings& settings);

  FigureFault fault() const { return fault_; }
  std::uint32_t fault_block() const { return fault_block_; }  // block number N of the piece with the fault
  bool pockets() const { return pockets_; }

  /// Returns a point, line or arc in figure coordinates as one of the plane, in programmed coordinates.
  Vec2 in_plane(Vec2 point) const;
  Vec2 in_figure(Vec2 point) const;
  ContourPiece in_plane(ContourPiece piece) const;
  Vec2 start() const { return start_; }                                // S in the plane, without allowance
  Vec2 start_in_figure() const { return in_figure(start_); }           // S in figure coordinates: −δ in the directions of the axes
  MotionKind infeed() const { return infeed_; }                        // rapid or feed: the code of the figure's first block
  const std::vector<ContourPiece>& pieces() const { return pieces_; }  // figure from A' on with allowance, in the plane

  FigurePlace begin() const { return {0, 0, sections_.front().from}; }
  FigurePlace end() const { return {sections_.size() - 1, 1, sections_.back().to}; }
  double deepest() const { return deepest_; }

  /// Returns the first stretch that begins on the figure between `from` and `to`. The place `from` itself begins a stretch only if it is
  /// A'.
  ///   law  every point between begin and end of the stretch is deeper than the level, and the ends lie on the level or at an end of the
  ///        figure
  std::optional<Stretch> stretch(double level, const FigurePlace& from, const FigurePlace& to) const;
  /// Returns the stretch of the level in which the place lies. The place is deeper than the level.
  Stretch stretch_around(double level, const FigurePlace& place) const;
  /// Returns the least deep point between two places, ends included; of several equal ones the first.
  FigurePlace ridge(const FigurePlace& from, const FigurePlace& to) const;
  /// Returns the part of the figure from `from` to `to`, but at most to the end of the section of `from`; in figure coordinates.
  ContourPiece section(const FigurePlace& from, const FigurePlace& to) const;
  /// Returns the place where section(from, to) ends.
  FigurePlace after_section(const FigurePlace& from, const FigurePlace& to) const;

 private:
  ContourPiece in_figure(ContourPiece piece) const;
  void choose_directions(Vec2 first);
  FigureFault check(const Settings& settings);
  FigurePlace crossing(std::size_t section, double level) const;

  bool facing_ = false, pockets_ = false;
  MotionKind infeed_ = MotionKind::rapid;
  FigureFault fault_ = FigureFault::none;
  std::uint32_t fault_block_ = 0;
  Vec2 start_, origin_;          // S and S+δ in the plane
  double along_ = 1, into_ = 1;  // ±1: direction of x and y along the axes of the plane
  double deepest_ = 0;
  std::vector<ContourPiece> pieces_;
  std::vector<ContourPiece> sections_;  // the pieces in figure coordinates, split where an axis reverses
};

}  // namespace kadr::fanuc
