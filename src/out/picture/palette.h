#pragma once
// The colours that all pictures of a program have in common.

#include "out/picture/canvas.h"

namespace kadr {

inline constexpr Colour white = colour(0xFFFFFF);
inline constexpr Colour paper = colour(0xFBFCFD);  // background of a diagram
inline constexpr Colour grid = colour(0xE4E9EF);
inline constexpr Colour edge = colour(0xC3CCD6);       // frame around a diagram
inline constexpr Colour ink = colour(0x20262E);        // texts
inline constexpr Colour faint_ink = colour(0x5B6775);  // less important texts

}  // namespace kadr
