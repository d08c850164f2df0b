#pragma once
// Holes of drilling cycles that are drilled twice.

#include <array>
#include <cstdint>
#include <set>

#include "action/step.h"
#include "session/checklist/advice.h"

namespace kadr {

class HoleWatch {
 public:
  void take(const Step& step, Advices& to);

 private:
  std::set<std::array<std::int64_t, max_axes + 1>> holes_;  // of the tool in the spindle: machine coordinates, µm; work system
};

}  // namespace kadr
