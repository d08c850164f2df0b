#pragma once
// RotarySwing: finds motions in which a rotary axis turns far while the controlled tip hardly moves. Close to a singular direction of the
// tool, the rotary axis that is parallel to the tool must turn far within a very short path (NCT 25a 5.1). The tip then rests on the part
// and leaves a mark, and the fast rotation jolts the machine.

#include <optional>

#include "action/step.h"

namespace kadr {

struct RotarySwing {
  std::size_t axis = 0;
  double degrees = 0;     // angle by which the axis turns in the motion, degrees
  double tip_travel = 0;  // length of the tip's path in the same motion, mm
};

class SingularityWatch {
 public:
  static constexpr double most = 30;       // greatest rotation of an axis, degrees per mm of the tip's path, that is not reported
  static constexpr double least = 20;      // least rotation of an axis, degrees, that is reported
  static constexpr int max_reported = 20;  // greatest number of reports per program run

  /// Returns the swing if the step is a feed motion that turns an axis faster than `most`; nullopt for every other step. Only the first of
  /// several consecutive motions of this kind is reported. A motion in which the tip does not move is intended, and is not reported.
  std::optional<RotarySwing> look(const Step& step);

 private:
  bool swings_ = false;
  int reported_ = 0;
};

}  // namespace kadr
