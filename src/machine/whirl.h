#pragma once
// Whirl: places where a rotary axis turns far while the tip that is led hardly goes on: near a direction of the tool that is singular, the
// axis that carries the tool upright there has to turn at once (NCT 25a 5.1). The part gets marks, the machine a jolt.

#include <optional>

#include "action/step.h"

namespace kadr {

struct Whirl {
  std::size_t axis = 0;
  double degrees = 0;  // that it turns
  double way = 0;      // mm of the tip meanwhile
};

class WhirlWatch {
 public:
  static constexpr double most = 30;    // degrees a mm of the tip's way
  static constexpr double least = 20;   // degrees in a motion: less is no whirl
  static constexpr int most_told = 20;  // in a run

  /// A motion at feed that turns an axis faster than that; each row of such motions once. A tip that stands is meant to.
  std::optional<Whirl> look(const Step& step);

 private:
  bool whirls_ = false;
  int told_ = 0;
};

}  // namespace kadr
