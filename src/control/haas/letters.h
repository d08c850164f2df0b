#pragma once
// A font of single lines, Kadr's own, for engraved texts (spec/haas 7.2: the control's is not public).

#include <optional>
#include <string_view>
#include <vector>

#include "base/vec.h"

namespace kadr::haas {

/// Height of a capital, and how far one letter is from the next, in the units of the strokes.
inline constexpr double letter_height = 6, letter_advance = 6;

/// The strokes of a letter, from its lower left corner; small letters are drawn as capitals. Nothing: there is no such letter.
std::optional<std::vector<std::vector<Vec2>>> strokes_of(char letter);

}  // namespace kadr::haas
