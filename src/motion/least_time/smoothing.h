#pragma once
// Smoothing: joins straight motions under G5.1 into one curve before they are planned. NCT 4.7, 4.7.1.
//
//   Q2   the path goes through the programmed points: each straight piece becomes a Bezier curve at most N3104 away from the piece
//   Q3   the path leaves the programmed points too: each corner is rounded, at most N3106 away from the programmed path
//
// One piece is stored (held) until the next piece arrives, because the direction of the next piece determines how the held piece ends.
// Names such as N3104 are parameters of the control (SmoothingRules).

#include <cstdint>
#include <functional>
#include <optional>

#include "config/setup/setup.h"
#include "path/curve/bezier.h"

namespace kadr {

/// The parameters of the control; lengths in mm. INFERRED: a limit of 0 is off, as in chapter 7 of the NCT manual; without N3104 and
/// N3106 nothing is smoothed.
struct SmoothingRules {
  double longest = 0;       // N3100: longer pieces stay straight
  double shortest = 0;      // N3101: shorter pieces stay straight
  double angle = 0;         // N3102, degrees: if the direction changes by more between two pieces, neither piece is smoothed
  double most = 0;          // N3104: a piece whose curve would leave its chord by more stays straight
  double least = 0;         // N3105: a piece whose curve would leave its chord by less stays straight
  double fine = 0;          // N3106: with Q3, the greatest deviation of a rounded corner from the programmed path
  double always_below = 0;  // N3107, with Q3: shorter pieces are smoothed at any angle; N3107 is at most twice N3106 and greater than N3103
};

/// Reads the rules from the set-up: parameter values that a program writes take effect at the next program start.
SmoothingRules smoothing_rules(const Setup& setup, const std::vector<std::string>& axes);

class Smoothing {
 public:
  struct Piece {
    Axes from{}, to{};
    double feed = 0;  // programmed feed, mm/s
    // tolerance of the corner at the piece's start if the corner is not smoothed, mm; 0: the path goes exactly through the corner
    double tolerance = 0;
    std::uint64_t tag = 0;
    std::uint8_t mode = 2;  // the word Q of G5.1: 2 or 3
  };
  /// Receives a straight line, like Planner::line_to.
  using Line = std::function<void(const Axes& to, double feed, double tolerance, bool on_curve, std::uint64_t tag)>;

  Smoothing() = default;
  explicit Smoothing(const SmoothingRules& rules) : rules_(rules) {}

  /// Accepts the next piece and emits the previous one.
  void take(const Piece& piece, const Line& line);
  /// Emits the held piece, because no further piece follows.
  void finish(const Line& line);

 private:
  struct Held {
    Piece piece;
    Axes way;             // direction of the piece, a unit vector
    double length;        // length of the piece, mm
    bool fits;            // the length of the piece allows smoothing
    bool sharp = false;   // the corner at the start of the piece is too sharp to smooth
    bool curved = false;  // the curve starts in the direction `start`, because the previous piece was smoothed
    Axes start{};         // a direction between those of the previous piece and this piece
  };
  bool is_sharp(const Held& before, const Held& behind) const;
  void let_out(const Held* next, const Line& line);

  SmoothingRules rules_;
  std::optional<Held> held_;
  bool before_smoothed_ = false;  // true if the piece emitted last was smoothed
};

}  // namespace kadr
