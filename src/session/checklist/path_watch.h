#pragma once
// PathWatch: checks the shape of the contour: arcs that turn back at both ends, arcs that are nearly full circles, and where cutter
// compensation starts and ends.

#include <array>
#include <optional>
#include <vector>

#include "action/step.h"
#include "session/checklist/advice.h"

namespace kadr {

class PathWatch {
 public:
  /// `step`: a step of the path as programmed, before compensation.
  void take(const Step& step, Advices& to);
  void finish(Advices& to);

 private:
  /// A motion at feed in the plane, with what its neighbours need.
  struct Piece {
    Origin origin;
    bool arc = false, ccw = false, full = false, helix = false, inch = false;
    std::uint8_t first = 0, second = 1;
    Vec2 from, to, center;
    Vec2 begins, ends;  // unit directions at its ends
    double degrees = 0;
  };
  static std::optional<Piece> piece_of(const Step& step, const Motion& motion);
  void look_at_arc(const Piece& before, const Piece& arc, const Piece& after);
  static void look_at_circle(const Piece& arc, Advices& to);
  void look_at_side(const Step& step, const Motion& motion, Advices& to);
  void compensation_over(Advices& to);

  void close();

  std::array<std::optional<Piece>, 2> last_;           // the two previous pieces
  std::vector<std::pair<Origin, const char*>> kinks_;  // arcs that turn back, and the code that would fit
  std::vector<Piece> first_;                           // the first two pieces of the contour
  std::optional<Origin> side_;                         // of the first motion of the compensation in force
  const char* side_code_ = "G41";
  bool compensated_ = false;  // the previous motion was compensated
  /// Set where compensation has ended in a cut; cuts_since_ counts the cuts in the plane that follow at the same depth.
  std::optional<Origin> ended_;
  int cuts_since_ = 0;
};

}  // namespace kadr
