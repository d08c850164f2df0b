#pragma once
// Kadr's own font for engraved text, whose letters consist of single lines (spec/haas 7.2: the font of the control is not public).

#include <optional>
#include <string_view>
#include <vector>

#include "base/vec.h"

namespace kadr::haas {

/// Height of a capital letter, and distance from one letter to the next, in units of the font.
inline constexpr double letter_height = 6, letter_advance = 6;

/// Returns the strokes of a letter, as points relative to the letter's lower left corner, in units of the font. Small letters have the
/// strokes of capitals. Returns nullopt if the font lacks the letter.
std::optional<std::vector<std::vector<Vec2>>> strokes_of(char letter);

}  // namespace kadr::haas
