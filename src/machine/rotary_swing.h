#pragma once
// RotarySwing: finds motions in which a rotary axis turns far while the controlled tip hardly moves. Close to a singular direction of the
// tool, the rotary axis that is parallel to the tool must turn far within a very short path (NCT 25a 5.1). The stop of the tip marks the
// part, and the rotation jolts the machine.

#include <optional>

#include "action/step.h"

namespace kadr {

struct RotarySwing {
  std::size_t axis = 0;
  double degrees = 0;  // rotation of the axis in the motion
  double way = 0;      // path of the tip in the same motion, mm
};

class SingularityWatch {
 public:
  static constexpr double most = 30;       // degrees per mm of the tip's path: a faster rotation is reported
  static constexpr double least = 20;      // degrees: a motion that rotates the axis by less is not reported
  static constexpr int max_reported = 20;  // greatest number of reports per program run

  /// Returns the swing if the step is a feed motion that rotates an axis faster than `most`; nullopt for all other steps. Of consecutive
  /// such motions only the first is reported. A motion in which the tip does not move is intended, and is not reported.
  std::optional<RotarySwing> look(const Step& step);

 private:
  bool swings_ = false;
  int told_ = 0;
};

}  // namespace kadr
