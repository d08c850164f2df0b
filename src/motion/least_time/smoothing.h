#pragma once
// Smoothing joins straight motions under G5.1 into one curve before they are planned: NCT 4.7, 4.7.1.
//
//   Q2   the path goes through the programmed points: each straight piece becomes a Bezier curve at most N3104 away from the piece
//   Q3   the path leaves the programmed points too: each corner is rounded, at most N3106 away from the programmed path
//
// One piece is stored until the next piece arrives, because the direction of the next piece determines how the stored piece ends. Names
// such as N3104 are parameters of the control (SmoothingRules).

#include <cstdint>
#include <functional>
#include <optional>

#include "config/setup/setup.h"
#include "path/curve/bezier.h"

namespace kadr {

/// The smoothing parameters of the NCT control; lengths are in mm. INFERRED: the value 0 switches a limit off, as in chapter 7 of the NCT
/// manual. If neither N3104 nor N3106 is set, nothing is smoothed.
struct SmoothingRules {
  double longest = 0;   // N3100, mm: pieces longer than this length stay straight
  double shortest = 0;  // N3101, mm: pieces shorter than this length stay straight
  // N3102, degrees: if the direction changes by a greater angle between two pieces, neither of the two pieces is smoothed
  double angle = 0;
  double most = 0;   // N3104, mm: a piece whose curve would leave its chord by more than this distance stays straight
  double least = 0;  // N3105, mm: a piece whose curve would leave its chord by less than this distance stays straight
  double fine = 0;   // N3106, mm: with Q3, the greatest deviation of a rounded corner from the programmed path
  // N3107, mm: with Q3, pieces shorter than this length are smoothed at any angle. The value is limited to twice N3106. It is 0 (no such
  // pieces) unless it is greater than N3103.
  double always_below = 0;
};

/// Returns the rules that the set-up states. Parameter values that a program writes take effect at the next program start.
SmoothingRules smoothing_rules(const Setup& setup, const std::vector<std::string>& axes);

class Smoothing {
 public:
  struct Piece {
    Axes from{}, to{};
    double feed = 0;  // programmed feed, mm/s
    // Tolerance, mm, of the corner at the start of the piece if the corner is not smoothed. 0: the path goes exactly through the corner.
    double tolerance = 0;
    std::uint64_t tag = 0;
    std::uint8_t mode = 2;  // value of the word Q of G5.1: 2 or 3
  };
  /// The receiver of a straight line, with the same parameters as Planner::line_to.
  using Line = std::function<void(const Axes& to, double feed, double tolerance, bool on_curve, std::uint64_t tag)>;

  Smoothing() = default;
  explicit Smoothing(const SmoothingRules& rules) : rules_(rules) {}

  /// Accepts the next piece of the path and emits the previous piece, smoothed where the rules allow it.
  void take(const Piece& piece, const Line& line);
  /// Emits the stored piece; the path has no further piece that could be smoothed together with it.
  void finish(const Line& line);

 private:
  struct Held {
    Piece piece;
    Axes direction;       // direction of the piece, a unit vector
    double length;        // length of the piece, mm
    bool fits;            // true if the length of the piece allows smoothing
    bool sharp = false;   // true if the corner at the start of the piece is too sharp for smoothing
    bool curved = false;  // True if the curve starts in the direction `start`, because the previous piece was smoothed.
    Axes start{};         // mean direction of the previous piece and this piece, a unit vector
  };
  bool is_sharp(const Held& before, const Held& after) const;
  void let_out(const Held* next, const Line& line);

  SmoothingRules rules_;
  std::optional<Held> held_;
  bool before_smoothed_ = false;  // true if the last emitted piece was smoothed
};

}  // namespace kadr
