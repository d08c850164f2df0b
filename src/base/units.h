#pragma once
// Conversion factors for units other than the internal ones (mm, degrees, seconds).

namespace kadr {

inline constexpr double mm_per_inch = 25.4;  // exact by definition

}  // namespace kadr
