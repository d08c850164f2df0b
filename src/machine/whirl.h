#pragma once
// Whirl: finds motions in which a rotary axis turns far while the controlled tip hardly moves. Near a singular direction of the tool,
// the axis that the tool is parallel to has to turn all at once (NCT 25a 5.1). The part gets marks, and the machine a jolt.

#include <optional>

#include "action/step.h"

namespace kadr {

struct Whirl {
  std::size_t axis = 0;
  double degrees = 0;  // turned by the axis
  double way = 0;      // mm that the tip moves meanwhile
};

class WhirlWatch {
 public:
  static constexpr double most = 30;    // degrees per mm of the tip's path
  static constexpr double least = 20;   // degrees in a motion; less is not reported
  static constexpr int most_told = 20;  // reports in a run

  /// Returns a feed motion that turns an axis faster than `most`, once for each run of such motions. A tip at rest is intended and
  /// not reported.
  std::optional<Whirl> look(const Step& step);

 private:
  bool whirls_ = false;
  int told_ = 0;
};

}  // namespace kadr
