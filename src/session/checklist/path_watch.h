#pragma once
// PathWatch: checks the shape of the contour. It finds arcs that reverse the direction of motion at both of their ends, arcs that are
// nearly full circles, and faulty starts and ends of cutter compensation.

#include <array>
#include <optional>
#include <vector>

#include "action/step.h"
#include "session/checklist/advice.h"

namespace kadr {

class PathWatch {
 public:
  /// Processes a step of the programmed path, that is, of the path without cutter compensation.
  void take(const Step& step, Advices& to);
  void finish(Advices& to);

 private:
  /// A motion at feed in the working plane, with the values that are compared with those of the motions before and after it.
  struct Piece {
    Origin origin;
    bool arc = false, ccw = false, full = false, helix = false, inch = false;
    std::uint8_t first = 0, second = 1;
    Vec2 from, to, center;
    Vec2 begins, ends;  // unit vectors of the direction of motion, at the start and at the end
    double degrees = 0;
  };
  static std::optional<Piece> piece_of(const Step& step, const Motion& motion);
  void look_at_arc(const Piece& before, const Piece& arc, const Piece& after);
  static void look_at_circle(const Piece& arc, Advices& to);
  void look_at_side(const Step& step, const Motion& motion, Advices& to);
  void compensation_over(Advices& to);

  void close();

  std::array<std::optional<Piece>, 2> last_;  // the two motions before the present one
  // arcs that reverse the direction of motion at both ends, each with the code (G2 or G3) that would fit
  std::vector<std::pair<Origin, const char*>> kinks_;
  std::vector<Piece> first_;    // the first two motions of the contour; if the contour is closed, they are compared with its last motions
  std::optional<Origin> side_;  // location of the first motion with the cutter compensation that is in force
  const char* side_code_ = "G41";
  bool compensated_ = false;  // true: the previous motion was made with cutter compensation
  /// The location where cutter compensation has ended during a cut. The member cuts_since_ counts the cuts after this location that move in
  /// the plane at the same depth.
  std::optional<Origin> ended_;
  int cuts_since_ = 0;
};

}  // namespace kadr
