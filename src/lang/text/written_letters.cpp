// Converts text to the characters that a control accepts. Used by convert/conversion, cli/convert; tested by
// tests/lang/written_letters_test.cpp.

#include "lang/text/written_letters.h"

#include <algorithm>
#include <array>

#include "lang/text/tape.h"

namespace kadr {
namespace {

constexpr std::size_t leader_rows = 100;
constexpr std::size_t high_bytes = 128;  // number of byte values above 127

/// The Latin letters for А to Я by GOST 7.79-2000, system B, without the accents and apostrophes of this system.
constexpr std::array<std::string_view, 32> romanized = {"A", "B",  "V",  "G",   "D", "E", "ZH", "Z", "I",  "J", "K",
                                                        "L", "M",  "N",  "O",   "P", "R", "S",  "T", "U",  "F", "X",
                                                        "C", "CH", "SH", "SHH", "",  "Y", "",   "E", "YU", "YA"};
constexpr char32_t capital_a = U'А', small_a = U'а', capital_yo = U'Ё', small_yo = U'ё';
constexpr char32_t first_high = 0x80;

struct LettersAlike {
  char32_t code;
  std::string_view text;
};
constexpr LettersAlike alike_signs[] = {{U'«', "\""},   {U'»', "\""}, {U'“', "\""}, {U'”', "\""},  {U'„', "\""},    {U'’', "'"},
                                        {U'–', "-"},    {U'—', "-"},  {U'−', "-"},  {U'…', "..."}, {U'×', "x"},     {U'·', "."},
                                        {U'°', " deg"}, {U'±', "+-"}, {U'№', "N"},  {U'Ø', "D"},   {U'ø', "d"},     {U'⌀', "D"},
                                        {U'→', "->"},   {U'²', "2"},  {U'³', "3"},  {U'µ', "u"},   {U'\u00a0', " "}};

std::string utf8_text(char32_t code) {
  constexpr char32_t follows = 0x80, six = 0x3f, two_bytes = 0x800, lead_of_two = 0xc0, lead_of_three = 0xe0;
  if (code < first_high) return {static_cast<char>(code)};
  if (code < two_bytes) return {static_cast<char>(lead_of_two | code >> 6U), static_cast<char>(follows | (code & six))};
  return {static_cast<char>(lead_of_three | code >> 12U), static_cast<char>(follows | (code >> 6U & six)),
          static_cast<char>(follows | (code & six))};
}

std::string small(std::string_view capitals) {
  std::string text(capitals);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Returns possible replacements for a character, in the order of similarity, the most similar first.
std::vector<std::string> alike(char32_t code) {
  if (code == capital_yo) return {"Е", "YO"};
  if (code == small_yo) return {"е", "Е", "yo", "YO"};
  if (code >= capital_a && code < capital_a + romanized.size()) {
    const std::string_view text = romanized[code - capital_a];
    return code == U'Ъ' ? std::vector<std::string>{"Ь", ""} : std::vector<std::string>{std::string(text), small(text)};
  }
  if (code >= small_a && code < small_a + romanized.size()) {
    const char32_t capital = code - small_a + capital_a;
    const std::string_view text = romanized[code - small_a];
    return {utf8_text(capital), small(text), std::string(text)};
  }
  for (const LettersAlike& sign : alike_signs)
    if (sign.code == code) return {std::string(sign.text), " "};
  return {"?", " "};
}

/// Returns the table of a one-byte encoding. The key is a character, the value is its byte above 127.
const std::map<char32_t, char>& bytes_above(Encoding encoding) {
  static const auto table_of = [](Encoding of) {
    std::map<char32_t, char> table;
    for (std::size_t i = 0; i < high_bytes; ++i)
      if (const std::string_view text = utf8_of(of, static_cast<std::uint8_t>(high_bytes + i)); !text.empty())
        table.emplace(first_character(text).code, static_cast<char>(high_bytes + i));
    return table;
  };
  static const std::map<char32_t, char> cp1251 = table_of(Encoding::cp1251), koi8r = table_of(Encoding::koi8r),
                                        cp866 = table_of(Encoding::cp866);
  return encoding == Encoding::cp1251 ? cp1251 : encoding == Encoding::koi8r ? koi8r : cp866;
}

TapeCode tape_code(Encoding encoding) { return encoding == Encoding::eia ? TapeCode::eia : TapeCode::iso; }

bool has_letter(const WrittenLetters& letters, char32_t code) {
  if (is_tape(letters.encoding)) return encode_tape(utf8_text(code), 0, tape_code(letters.encoding)).has_value();
  if (code < first_high) return true;
  if (letters.encoding == Encoding::utf8) return !letters.ascii;
  return bytes_above(letters.encoding).count(code) != 0;
}

bool has_letters(const WrittenLetters& letters, std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const Character one = first_character(text.substr(at));
    if (!has_letter(letters, one.code)) return false;
    at += one.size;
  }
  return true;
}

/// Stores the replacements that have been found, so that each character is looked up only once.
class Alikes {
 public:
  explicit Alikes(const WrittenLetters& letters) : letters_(letters) {}
  /// Returns the replacement for a character; nullopt if the character itself is allowed.
  const std::optional<std::string>& of(char32_t code) {
    if (const auto found = known_.find(code); found != known_.end()) return found->second;
    return known_.emplace(code, look(code)).first->second;
  }

 private:
  std::optional<std::string> look(char32_t code) const {
    if (has_letter(letters_, code)) return std::nullopt;
    for (const std::string& one : alike(code))
      if (has_letters(letters_, one)) return one;
    return std::string();
  }

  const WrittenLetters& letters_;
  std::map<char32_t, std::optional<std::string>> known_;
};

}  // namespace

std::optional<WrittenLetters> written_letters_named(std::string_view name) {
  if (name == "ascii") return WrittenLetters{Encoding::utf8, true};
  const auto encoding = encoding_named(name);
  return encoding ? std::optional(WrittenLetters{*encoding, false}) : std::nullopt;
}

bool has_russian(const WrittenLetters& letters) { return has_letter(letters, capital_a); }

bool is_written_so(std::string_view utf8, const WrittenLetters& letters) {
  if (is_tape(letters.encoding)) return false;
  if (letters.encoding == Encoding::utf8 && !letters.ascii) return true;
  return std::all_of(utf8.begin(), utf8.end(), [](char c) { return static_cast<unsigned char>(c) < first_high; });
}

Transliterated transliterated(std::string_view utf8, const WrittenLetters& letters) {
  Transliterated made;
  Alikes alikes(letters);
  made.text.reserve(utf8.size());
  for (std::size_t at = 0; at < utf8.size();) {
    std::size_t end = at;  // end of the sequence of ASCII characters that starts at `at`
    while (end < utf8.size() && static_cast<unsigned char>(utf8[end]) < first_high) ++end;
    made.text.append(utf8.substr(at, end - at));
    if (end == utf8.size()) break;
    const Character one = first_character(utf8.substr(end));
    const std::size_t size = std::max<std::size_t>(one.size, 1);
    const auto& instead = alikes.of(one.code);
    if (one.size != 0 && !instead) made.text.append(utf8.substr(end, size));
    else made.text += instead.value_or("?"), ++made.characters;
    at = end + size;
  }
  return made;
}

Result<std::string> bytes_of(std::string_view utf8, const WrittenLetters& letters) {
  if (is_tape(letters.encoding)) return encode_tape(utf8, leader_rows, tape_code(letters.encoding));
  std::string bytes;
  bytes.reserve(utf8.size());
  for (std::size_t at = 0; at < utf8.size();) {
    const Character one = first_character(utf8.substr(at));
    const std::size_t size = std::max<std::size_t>(one.size, 1);
    const std::string_view character = utf8.substr(at, size);
    if (one.size == 0 || !has_letter(letters, one.code))
      return fail(alarm(AlarmId::bad_encoding, {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + size)}, character));
    if (one.code < first_high || letters.encoding == Encoding::utf8) bytes += character;
    else bytes += bytes_above(letters.encoding).at(one.code);
    at += size;
  }
  return bytes;
}

}  // namespace kadr
