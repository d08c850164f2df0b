#pragma once
// HoleWatch: finds holes that drilling cycles drill twice.

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
  std::set<std::array<std::int64_t, max_axes + 1>> holes_;  // drilled by the present tool: machine coordinates, µm; work system
};

}  // namespace kadr
