#pragma once
// The code EIA RS-244 of punched tape. Tracks 1 to 4, 6 and 7 encode the character; track 5 makes the number of punched holes odd; a row
// with track 8 alone ends a block.

#include <cstdint>
#include <optional>

namespace kadr {

inline constexpr std::uint8_t eia_end_of_block = 0x80;

bool has_odd_parity(std::uint8_t row);

/// Returns the meaning of a row with odd parity: a character ('\n' ends a block, '%' is the end of record), or 0 for a row without a
/// character (delete, back space, the shifts of a typewriter). Letters are returned as capitals.
///   returns  nullopt if the code has no such row
std::optional<char> eia_character(std::uint8_t row);

/// Returns the row that encodes a character; nullopt if the code lacks the character: ':', '=', brackets, Russian letters.
std::optional<std::uint8_t> eia_row(char32_t character);

}  // namespace kadr
