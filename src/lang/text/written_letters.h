#pragma once
// WrittenLetters: the characters that the text of a program for a control may contain, and their bytes.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "lang/text/encoding.h"

namespace kadr {

struct WrittenLetters {
  Encoding encoding = Encoding::utf8;
  bool ascii = false;  // only the ASCII part of UTF-8 is allowed
  friend bool operator==(const WrittenLetters&, const WrittenLetters&) = default;
};

/// Returns the letters for the name "ascii", or for any of the names of an encoding.
std::optional<WrittenLetters> written_letters_named(std::string_view name);
/// Returns true if the characters include Russian letters.
bool has_russian(const WrittenLetters& letters);

/// Returns true if the text has only the characters of `letters`, and its bytes for the control equal its bytes in UTF-8. Then neither
/// transliterated() nor bytes_of() would change the text.
bool is_written_so(std::string_view utf8, const WrittenLetters& letters);

struct Transliterated {
  std::string text;            // text in UTF-8, with only the characters that the control accepts
  std::size_t characters = 0;  // number of characters that were replaced
};
/// Replaces characters that the control does not have by characters that read alike: Ё by Е or YO, ж by Ж or ZH, « by ".
///   law  a text that has only allowed characters does not change
Transliterated transliterated(std::string_view utf8, const WrittenLetters& letters);

/// Returns the bytes of the text for the control. The bytes of a punched tape include a leader and a trailer (blank rows).
///   alarms  bad_encoding, with the character that has no code and its location
Result<std::string> bytes_of(std::string_view utf8, const WrittenLetters& letters);

}  // namespace kadr
