// The font for engraved text. Used by control/haas/engraving.

#include "control/haas/letters.h"

#include "base/ascii.h"

namespace kadr::haas {
namespace {

/// The strokes of a letter, as points on a grid of 5 by 7. Two digits give the x and y of a point; a space ends a stroke.
struct LetterRow {
  char letter;
  std::string_view strokes;
};
constexpr LetterRow letter_rows[] = {
    {' ', ""},
    {'A', "002640 1333"},
    {'B', "00063645443303 3342413000"},
    {'C', "4536160501103041"},
    {'D', "00062644422000"},
    {'E', "46060040 0333"},
    {'F', "460600 0333"},
    {'G', "45361605011030414323"},
    {'H', "0006 4046 0343"},
    {'I', "1030 2026 1636"},
    {'J', "4641301001"},
    {'K', "0006 460340"},
    {'L', "060040"},
    {'M', "0006234640"},
    {'N', "00064046"},
    {'O', "103041453616050110"},
    {'P', "00063645443303"},
    {'Q', "103041453616050110 2240"},
    {'R', "00063645443303 2340"},
    {'S', "453616050413334241301001"},
    {'T', "0646 2026"},
    {'U', "060110304146"},
    {'V', "062046"},
    {'W', "0610233046"},
    {'X', "0046 0640"},
    {'Y', "062346 2320"},
    {'Z', "06460040"},
    {'0', "103041453616050110 0145"},
    {'1', "152620 1030"},
    {'2', "05163645440040"},
    {'3', "05163645443323 334241301001"},
    {'4', "30360242"},
    {'5', "460603334241301001"},
    {'6', "453616050110304142331302"},
    {'7', "064610"},
    {'8', "13040516364544331302011030414233"},
    {'9', "011030414536160504133344"},
    {'.', "2021"},
    {',', "2110"},
    {'-', "1333"},
    {'+', "1333 2422"},
    {'/', "0046"},
    {':', "2122 2425"},
    {'(', "36252130"},
    {')', "16252110"},
    {'=', "1434 1232"},
    {'#', "1016 3036 0242 0444"},
    {'*', "1333 2422 1432 1234"},
    {'!', "2622 2021"},
    {'\'', "2625"},
    {'"', "1615 3635"},
    {'?', "051636454422 2021"},
    {'%', "0046 0506 4041"},
    {'_', "0040"},
    {'<', "460340"},
    {'>', "064300"},
    {'[', "36161030"},
    {']', "16363010"},
};

}  // namespace

std::optional<std::vector<std::vector<Vec2>>> strokes_of(char letter) {
  for (const LetterRow& row : letter_rows) {
    if (row.letter != to_upper(letter)) continue;
    std::vector<std::vector<Vec2>> strokes;
    bool begins = true;
    for (std::size_t i = 0; i + 1 < row.strokes.size();) {
      if (row.strokes[i] == ' ') {
        begins = true;
        ++i;
        continue;
      }
      if (begins) strokes.emplace_back();
      begins = false;
      strokes.back().push_back({double(row.strokes[i] - '0'), double(row.strokes[i + 1] - '0')});
      i += 2;
    }
    return strokes;
  }
  return std::nullopt;
}

}  // namespace kadr::haas
