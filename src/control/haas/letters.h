#pragma once
// Kadr's own single-line font for engraved text (spec/haas 7.2: the font of the control is not public).

#include <optional>
#include <string_view>
#include <vector>

#include "base/vec.h"

namespace kadr::haas {

/// Height of a capital letter, and the distance from one letter to the next, in the units of strokes_of().
inline constexpr double letter_height = 6, letter_advance = 6;

/// Returns the strokes of a letter, as points relative to its lower left corner. Small letters are drawn as capitals. Returns nullopt if
/// the font lacks the letter.
std::optional<std::vector<std::vector<Vec2>>> strokes_of(char letter);

}  // namespace kadr::haas
