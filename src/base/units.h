#pragma once
// Units other than those used inside (mm, degrees, seconds).

namespace kadr {

inline constexpr double mm_per_inch = 25.4;  // exact by definition

}  // namespace kadr
