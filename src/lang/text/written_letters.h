#pragma once
// WrittenLetters: the characters that the text of a program may contain when it is written for a control, and their bytes.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "lang/text/encoding.h"

namespace kadr {

struct WrittenLetters {
  Encoding encoding = Encoding::utf8;
  bool ascii = false;  // only the ASCII part of UTF-8
  friend bool operator==(const WrittenLetters&, const WrittenLetters&) = default;
};

/// Reads "ascii", or an encoding by any of its names.
std::optional<WrittenLetters> written_letters_named(std::string_view name);
/// Returns true if it includes Russian letters.
bool has_russian(const WrittenLetters& letters);

/// Returns true if the text has only these characters and its bytes equal
/// their UTF-8: neither transliterated() nor bytes_of() would change it.
bool is_written_so(std::string_view utf8, const WrittenLetters& letters);

struct Transliterated {
  std::string text;            // UTF-8, only these characters
  std::size_t characters = 0;  // number of characters that were replaced
};
/// Replaces other characters by ones that read alike: Ё by Е or YO, ж by Ж or ZH, « by ".
///   law  a text of only these characters does not change
Transliterated transliterated(std::string_view utf8, const WrittenLetters& letters);

/// Returns the bytes of the text; a punched tape has a leader and a trailer.
///   alarms  bad_encoding: the character and its place
Result<std::string> bytes_of(std::string_view utf8, const WrittenLetters& letters);

}  // namespace kadr
