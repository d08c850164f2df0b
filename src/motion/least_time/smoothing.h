#pragma once
// Smoothing: joins straight motions under G5.1 into one curve before they are planned. NCT 4.7, 4.7.1.
//
//   Q2   through the programmed points: each straight piece becomes a Bezier curve at most N3104 from it
//   Q3   the points move too: each corner is rounded, at most N3106 from the programmed path
//
// One piece is held back until the next one arrives, as its direction determines how the piece ends.

#include <cstdint>
#include <functional>
#include <optional>

#include "config/setup.h"
#include "path/curve/bezier.h"

namespace kadr {

/// The parameters; lengths in mm. INFERRED: a limit of 0 is off, as in chapter 7; without N3104 and N3106 nothing is smoothed.
struct SmoothingRules {
  double longest = 0;       // N3100: longer pieces stay straight
  double shortest = 0;      // N3101: shorter pieces stay straight
  double angle = 0;         // N3102, degrees: two pieces that turn by more are both not smoothed
  double most = 0;          // N3104: a piece whose curve would leave its chord by more stays straight
  double least = 0;         // N3105: a piece whose curve would leave its chord by less stays straight
  double fine = 0;          // N3106: how far the corners of Q3 may leave the programmed path
  double always_below = 0;  // N3107, for Q3: shorter pieces are smoothed whatever the angle; at most twice N3106, more than N3103
};

/// Reads the rules from the set-up: what a program writes into the parameters acts from the next start on.
SmoothingRules smoothing_rules(const Setup& setup, const std::vector<std::string>& axes);

class Smoothing {
 public:
  struct Piece {
    Axes from{}, to{};
    double feed = 0;       // mm/s
    double tolerance = 0;  // of the corner at its start if that is not smoothed, mm; 0: exactly through it
    std::uint64_t tag = 0;
    std::uint8_t mode = 2;  // Q of G5.1
  };
  /// Receives a straight line, like Planner::line_to.
  using Line = std::function<void(const Axes& to, double feed, double tolerance, bool on_curve, std::uint64_t tag)>;

  Smoothing() = default;
  explicit Smoothing(const SmoothingRules& rules) : rules_(rules) {}

  /// Takes the next piece and emits the one before.
  void take(const Piece& piece, const Line& line);
  /// Emits the held piece, as no further piece follows.
  void finish(const Line& line);

 private:
  struct Held {
    Piece piece;
    Axes way;             // unit vector
    double length;        // mm
    bool fits;            // its length allows smoothing
    bool sharp = false;   // the corner before it is too sharp
    bool curved = false;  // it starts in the direction `start`, between its own and that of the previous piece, which was smoothed
    Axes start{};         // the direction between the two
  };
  bool is_sharp(const Held& before, const Held& behind) const;
  void let_out(const Held* next, const Line& line);

  SmoothingRules rules_;
  std::optional<Held> held_;
  bool before_smoothed_ = false;  // true if the piece emitted last was smoothed
};

}  // namespace kadr
