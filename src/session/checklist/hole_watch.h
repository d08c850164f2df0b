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
  std::set<std::array<std::int64_t, 5>> holes_;  // X, Y, bottom in µm, work system, tool
  std::uint32_t tool_ = 0;
  std::uint32_t stint_ = 0;
};

}  // namespace kadr
