// Shows a program line below an alarm and underlines a range of the line. Positions count characters, not bytes. This file is used by cli
// and out.

#include "out/text/source_line.h"

#include <algorithm>
#include <vector>

namespace kadr {
namespace {

constexpr std::size_t widest = 110;  // greatest number of characters of a line that are shown
constexpr std::size_t ahead = 40;    // greatest number of characters before the underlined range in a line that had to be shortened
constexpr std::string_view indent = "  ";
constexpr std::string_view clipped = "…";

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

/// Returns the length in bytes of a UTF-8 character that begins with this byte; 0 if no character begins with this byte.
std::size_t length_by(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  return first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
}

/// Splits the text into characters. A byte that is not UTF-8 becomes one element, together with the continuation bytes after it.
std::vector<std::string_view> characters(std::string_view text) {
  std::vector<std::string_view> all;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t most = i + length_by(static_cast<unsigned char>(text[i]));
    std::size_t end = i + 1;
    while (end < text.size() && end < most && continues(text[end])) ++end;
    all.push_back(text.substr(i, end - i));
    i = end;
  }
  return all;
}

/// True for U+202A … U+202E and U+2066 … U+2069. These characters reverse the writing direction of the text after them.
bool turns_round(std::string_view character) {
  if (character.size() != 3 || character[0] != '\xE2') return false;
  const auto last = static_cast<unsigned char>(character[2]);
  return (character[1] == '\x80' && last >= 0xAA && last <= 0xAE) || (character[1] == '\x81' && last >= 0xA6 && last <= 0xA9);
}

constexpr const char* unknown = "\xEF\xBF\xBD";  // U+FFFD

/// Returns bytes that are not UTF-8 (text in some code page) unchanged. A byte that is a control character in one of the code pages is
/// replaced by U+FFFD.
std::string bytes_shown(std::string_view bytes) {
  std::string shown;
  for (const char byte : bytes)
    if (static_cast<unsigned char>(byte) >= 0x80 && static_cast<unsigned char>(byte) < 0xA0) shown += unknown;
    else shown += byte;
  return shown;
}

/// Returns the character in a form that a terminal may receive. Control characters are replaced by their symbols, U+2400 and above.
std::string character_shown(std::string_view character) {
  const auto byte = static_cast<unsigned char>(character[0]);
  const auto second = static_cast<unsigned char>(character.size() > 1 ? character[1] : 0);
  // true: the character has more bytes than UTF-8 permits for it
  const bool too_long_form = (byte == 0xE0 && second < 0xA0) || (byte == 0xF0 && second < 0x90);
  if (character.size() != length_by(byte) || too_long_form) return bytes_shown(character);
  if (byte == 0x7F) return "\xE2\x90\xA1";
  if (byte < 0x20 && byte != '\t') return std::string("\xE2\x90") + static_cast<char>(0x80 + byte);
  const bool second_set = byte == 0xC2 && second < 0xA0;
  return second_set || turns_round(character) ? unknown : std::string(character);
}

bool is_plain(char c) { return (static_cast<unsigned char>(c) >= 0x20 && static_cast<unsigned char>(c) < 0x7F) || c == '\n' || c == '\t'; }

}  // namespace

std::uint32_t characters_before(std::string_view text, std::size_t bytes) {
  const std::string_view before = text.substr(0, std::min(bytes, text.size()));
  return static_cast<std::uint32_t>(std::count_if(before.begin(), before.end(), [](char c) { return !continues(c); }));
}

std::string visible(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), is_plain)) return std::string(text);
  std::string shown;
  for (const std::string_view character : characters(text))
    if (character == "\n") shown += '\n';
    else shown += character_shown(character);
  return shown;
}

std::string visible_name(std::string_view name) {
  std::string shown;
  for (const std::string_view character : characters(name)) shown += character == "\t" ? "\xE2\x90\x89" : character_shown(character);
  return shown;
}

std::string shortened_line(std::string_view line, std::size_t most) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = std::min(line.find_first_not_of(blanks), line.size());
  line = line.substr(first, line.find_last_not_of(blanks) + 1 - first);
  const std::vector<std::string_view> all = characters(line);
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), most); ++i) text += all[i] == "\t" ? " " : character_shown(all[i]);
  if (all.size() > most) text += clipped;
  return text;
}

std::string marked_line(std::string_view line, Span place) {
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
  const std::vector<std::string_view> all = characters(line);
  const auto before = [&](std::size_t bytes) {
    std::size_t count = 0;
    for (std::size_t at = 0; count < all.size() && at < bytes; ++count) at += all[count].size();
    return count;
  };
  const std::size_t begin = before(place.begin), end = std::max(begin + 1, before(place.end));
  const std::size_t first = all.size() > widest && begin > ahead ? begin - ahead : 0;
  const std::size_t last = std::min(all.size(), first + widest);

  std::string text(indent), marks(indent);
  if (first > 0) {
    text += clipped;
    marks += ' ';
  }
  for (std::size_t i = first; i < std::max(last, begin + 1); ++i) {
    if (i < last) text += character_shown(all[i]);
    if (i < begin) marks += i < last && all[i] == "\t" ? '\t' : ' ';
    else if (i < end) marks += i == begin ? '^' : '~';
  }
  if (last < all.size()) text += clipped;
  return text + "\n" + marks + "\n";
}

}  // namespace kadr
