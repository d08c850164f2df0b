#pragma once
// The shape of the contour: arcs that turn back at both ends, arcs that go nearly all the way round, and where compensation begins and
// ends.

#include <array>
#include <optional>
#include <vector>

#include "action/step.h"
#include "session/checklist/advice.h"

namespace kadr {

class PathWatch {
 public:
  /// `step`: of the path as programmed, before compensation.
  void take(const Step& step, Advices& to);
  void finish(Advices& to);

 private:
  /// A motion at feed in the plane, as its neighbours see it.
  struct Piece {
    Origin origin;
    bool arc = false, ccw = false, full = false, helix = false, inch = false;
    std::uint8_t first = 0, second = 1;
    Vec2 from, to, center;
    Vec2 begins, ends;  // directions at its ends, of length 1
    double degrees = 0;
  };
  static std::optional<Piece> piece_of(const Step& step, const Motion& motion);
  void look_at_arc(const Piece& before, const Piece& arc, const Piece& after);
  static void look_at_circle(const Piece& arc, Advices& to);
  void look_at_side(const Step& step, const Motion& motion, Advices& to);
  void compensation_over(Advices& to);

  void close();

  std::array<std::optional<Piece>, 2> last_;           // the two before
  std::vector<std::pair<Origin, const char*>> kinks_;  // arcs that turn back, and the code that would fit
  std::vector<Piece> first_;                           // the first two of the contour
  std::optional<Origin> side_;                         // of the first motion on a side, while there is one
  const char* side_code_ = "G41";
  bool compensated_ = false;  // the motion before was
  /// Compensation has ended in a cut: how many cuts in the plane have followed at the same depth.
  std::optional<Origin> ended_;
  int cuts_since_ = 0;
};

}  // namespace kadr
