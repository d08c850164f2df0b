// The code EIA RS-244 of punched tape. Tracks 1 to 4, 6 and 7 encode the character; track 5 makes the number of punched holes odd; a row
// with track 8 alone ends a block. Used by cli, control, lang.

#include "lang/text/eia.h"

#include <array>
#include <bit>
#include <utility>

namespace kadr {
namespace {

constexpr char nothing = '\0';

/// The codes of EIA RS-244-A, in the order of the standard's table, so that they are easy to compare with that table.
constexpr std::array<std::pair<std::uint8_t, char>, 52> codes = {{
    {0x20, '0'},
    {0x01, '1'},
    {0x02, '2'},
    {0x13, '3'},
    {0x04, '4'},
    {0x15, '5'},
    {0x16, '6'},
    {0x07, '7'},
    {0x08, '8'},
    {0x19, '9'},
    {0x61, 'A'},
    {0x62, 'B'},
    {0x73, 'C'},
    {0x64, 'D'},
    {0x75, 'E'},
    {0x76, 'F'},
    {0x67, 'G'},
    {0x68, 'H'},
    {0x79, 'I'},
    {0x51, 'J'},
    {0x52, 'K'},
    {0x43, 'L'},
    {0x54, 'M'},
    {0x45, 'N'},
    {0x46, 'O'},
    {0x57, 'P'},
    {0x58, 'Q'},
    {0x49, 'R'},
    {0x32, 'S'},
    {0x23, 'T'},
    {0x34, 'U'},
    {0x25, 'V'},
    {0x26, 'W'},
    {0x37, 'X'},
    {0x38, 'Y'},
    {0x29, 'Z'},
    {0x6B, '.'},
    {0x3B, ','},
    {0x31, '/'},
    {0x70, '+'},
    // In the standard, the code 0x0B, which becomes %, is the code for the end of record.
    {0x40, '-'},
    {0x0E, '&'},
    {0x10, ' '},
    {0x3E, '\t'},
    {0x80, '\n'},
    {0x0B, '%'},
    {0x1A, '('},
    {0x4A, ')'},  // the standard names the codes of the two brackets control out and control in
    // Rows without a character. In the standard, their names are delete, back space, upper case, lower case.
    {0x7F, nothing},
    {0x2A, nothing},
    {0x7C, nothing},
    {0x7A, nothing},
}};

constexpr std::uint8_t no_row = 0xFF;  // entry of a character without an EIA code: a row with even parity, which is never a code

}  // namespace

bool has_odd_parity(std::uint8_t row) { return std::popcount(row) % 2 == 1; }

std::optional<char> eia_character(std::uint8_t row) {
  static constexpr char unknown = '\x01';
  static const auto characters = [] {
    std::array<char, 256> table{};
    table.fill(unknown);
    for (const auto& [code, character] : codes) table[code] = character;
    return table;
  }();
  if (characters[row] == unknown) return std::nullopt;
  return characters[row];
}

std::optional<std::uint8_t> eia_row(char32_t character) {
  static const auto rows = [] {
    std::array<std::uint8_t, 128> table{};
    table.fill(no_row);
    for (const auto& [code, of] : codes)
      if (of != nothing) table[static_cast<std::size_t>(of)] = code;
    return table;
  }();
  if (character >= U'a' && character <= U'z') character -= U'a' - U'A';
  if (character >= rows.size() || rows[character] == no_row) return std::nullopt;
  return rows[character];
}

}  // namespace kadr
