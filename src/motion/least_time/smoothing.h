#pragma once
// Smoothing: straight motions under G5.1, made one curve before they are planned. NCT 4.7, 4.7.1.
//
//   Q2   through the programmed points: a Bezier curve instead of each straight piece, as far as N3104 from it
//   Q3   the points move too: a rounded corner, as far as N3106 from the programmed path
//
// One piece waits for the next, whose direction decides how it ends.

#include <cstdint>
#include <functional>
#include <optional>

#include "config/setup.h"
#include "path/curve/bezier.h"

namespace kadr {

/// The parameters; lengths mm. INFERRED: a limit of 0 is off, as those of chapter 7; without N3104 and N3106 nothing is smoothed.
struct SmoothingRules {
  double longest = 0;       // N3100: longer pieces are straight
  double shortest = 0;      // N3101: shorter ones too
  double angle = 0;         // N3102, degrees: neither of two pieces that turn by more is smoothed
  double most = 0;          // N3104: pieces that would go further off their chord are straight
  double least = 0;         // N3105: those that would not go so far too
  double fine = 0;          // N3106
  double always_below = 0;  // N3107: of Q3, shorter pieces are smoothed whatever the angle; at most twice N3106, more than N3103
};

/// Of the set-up: what a program writes into parameters acts from the next start on.
SmoothingRules smoothing_rules(const Setup& setup, const std::vector<std::string>& axes);

class Smoothing {
 public:
  struct Piece {
    Axes from{}, to{};
    double feed = 0;       // mm/s
    double tolerance = 0;  // of the corner at its beginning where nothing is smoothed, mm; 0: exactly through it
    std::uint64_t tag = 0;
    std::uint8_t mode = 2;  // Q of G5.1
  };
  /// A straight line; as Planner::line_to.
  using Line = std::function<void(const Axes& to, double feed, double tolerance, bool on_curve, std::uint64_t tag)>;

  Smoothing() = default;
  explicit Smoothing(const SmoothingRules& rules) : rules_(rules) {}

  /// The next piece; the one before is emitted.
  void take(const Piece& piece, const Line& line);
  /// Something else follows.
  void finish(const Line& line);

 private:
  struct Held {
    Piece piece;
    Axes way;             // unit vector
    double length;        // mm
    bool fits;            // by its length
    bool sharp = false;   // the corner before it is
    bool curved = false;  // it begins in the direction between it and the one before, which was smoothed
    Axes start{};         // that direction
  };
  bool is_sharp(const Held& before, const Held& behind) const;
  void let_out(const Held* next, const Line& line);

  SmoothingRules rules_;
  std::optional<Held> held_;
  bool before_smoothed_ = false;  // the piece emitted last
};

}  // namespace kadr
