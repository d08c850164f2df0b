#pragma once
// HoleWatch: finds positions at which drilling cycles drill a hole twice.

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
  // holes that the present tool has drilled: machine coordinates in µm (rotary axes in 0.001°), and as last element the number of the work
  // offset
  std::set<std::array<std::int64_t, max_axes + 1>> holes_;
};

}  // namespace kadr
