// Computes the width of text in a picture without a font library. The layout is therefore the same on every computer and in both file
// formats. This file is used by the rest of out.

#include "out/picture/text_width.h"

#include <array>
#include <cstdint>

namespace kadr {
namespace {

constexpr char32_t replacement = 0xFFFD;
constexpr double em = 1000;

// Widths of the characters of DejaVu Sans, in thousandths of the font size. One table contains the characters from blank to ~, the other
// those from А to я.
constexpr char32_t first_ascii = 0x20, first_cyrillic = 0x410;
constexpr std::array<std::uint16_t, 95> ascii = {
    318, 401, 460, 838, 636, 950, 780, 275, 390,  390, 500, 838, 318, 361, 318, 337, 636, 636, 636, 636, 636, 636, 636, 636,
    636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632, 575, 775, 752, 295, 295, 656, 557, 863, 748, 787,
    603, 787, 695, 635, 611, 732, 684, 989, 685,  611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352, 635,
    634, 278, 278, 579, 278, 974, 634, 612, 635,  635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838};
constexpr std::array<std::uint16_t, 64> cyrillic = {684, 686, 686, 610, 781, 632, 1077, 641, 748,  748,  710, 752, 863, 752, 787,  752,
                                                    603, 698, 611, 609, 861, 685, 776,  686, 1069, 1094, 833, 882, 686, 698, 1080, 695,
                                                    613, 617, 589, 525, 691, 615, 901,  532, 650,  650,  604, 639, 754, 654, 612,  654,
                                                    635, 550, 583, 592, 855, 592, 681,  591, 915,  942,  707, 790, 589, 549, 842,  602};

/// Removes the first character from the text and returns it. A byte that is not UTF-8 is returned as the replacement character.
char32_t take_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t size = lead < 0x80                   ? 1
                           : lead >= 0xC2 && lead < 0xE0 ? 2
                           : lead >= 0xE0 && lead < 0xF0 ? 3
                           : lead >= 0xF0 && lead < 0xF5 ? 4
                                                         : 0;
  char32_t character = size < 2 ? lead : lead & (0x7FU >> size);
  bool whole = size > 0 && size <= text.size();
  for (std::size_t i = 1; whole && i < size; ++i) {
    whole = (byte(i) & 0xC0U) == 0x80;
    character = character << 6U | (byte(i) & 0x3FU);
  }
  // The least character that needs 1, 2, 3 or 4 bytes in UTF-8. A character that is written with more bytes than it needs is invalid.
  constexpr std::array<char32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
  if (!whole || character < least[size]) character = replacement;
  text.remove_prefix(whole ? size : 1);
  return character;
}

bool is_character_of_xml(char32_t c) {
  const bool surrogate = c >= 0xD800 && c < 0xE000;
  return c < 0x110000 && !surrogate && (c & 0xFFFEU) != 0xFFFE;
}

void append(std::string& to, char32_t c) {
  const auto byte = [&](char32_t value) { to += static_cast<char>(static_cast<unsigned char>(value)); };
  if (c < 0x80) return byte(c);
  if (c < 0x800) byte(0xC0 | c >> 6U);
  else if (c < 0x10000) byte(0xE0 | c >> 12U), byte(0x80 | (c >> 6U & 0x3FU));
  else byte(0xF0 | c >> 18U), byte(0x80 | (c >> 12U & 0x3FU)), byte(0x80 | (c >> 6U & 0x3FU));
  byte(0x80 | (c & 0x3FU));
}

double width_of(char32_t c) {
  constexpr double other = 640, wide = 1000;
  // the first character (Hangul) of the East Asian scripts; this character and all greater ones count as wide
  constexpr char32_t first_wide = 0x1100;
  if (c >= first_ascii && c < first_ascii + ascii.size()) return ascii[c - first_ascii];
  if (c >= first_cyrillic && c < first_cyrillic + cyrillic.size()) return cyrillic[c - first_cyrillic];
  return c >= first_wide ? wide : other;
}

}  // namespace

double text_width(std::string_view text, double size) {
  double width = 0;
  while (!text.empty()) width += width_of(take_character(text));
  return width * size / em;
}

std::string printable(std::string_view text) {
  // Two symbols that replace invisible characters: the symbol of the character 0 (others follow in order), and that of the character DEL.
  constexpr char32_t pictures = 0x2400, deleted = 0x2421;
  std::string clean;
  while (!text.empty()) {
    const char32_t c = take_character(text);
    append(clean, c < 0x20 ? pictures + c : c == 0x7F ? deleted : is_character_of_xml(c) ? c : replacement);
  }
  return clean;
}

}  // namespace kadr
