#pragma once
// WrittenLetters: which characters a program's text may hold where it is written for a control, and the bytes that they become.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "lang/text/encoding.h"

namespace kadr {

struct WrittenLetters {
  Encoding encoding = Encoding::utf8;
  bool ascii = false;  // of UTF-8 only that
  friend bool operator==(const WrittenLetters&, const WrittenLetters&) = default;
};

/// "ascii", or an encoding by any of its names.
std::optional<WrittenLetters> written_letters_named(std::string_view name);
/// It has Russian letters.
bool has_russian(const WrittenLetters& letters);

/// It holds nothing but such letters, and its bytes are those of UTF-8: neither transliterated() nor bytes_of() would change it.
bool is_written_so(std::string_view utf8, const WrittenLetters& letters);

struct Transliterated {
  std::string text;            // UTF-8, of these letters alone
  std::size_t characters = 0;  // that have become others
};
/// What has no place among these letters becomes what is read alike: Ё as Е or YO, ж as Ж or ZH, « as ".
///   law  a text of these letters alone stays as it is
Transliterated transliterated(std::string_view utf8, const WrittenLetters& letters);

/// The text as bytes; a punched tape has a leader and a trailer.
///   alarms  bad_encoding: the character and its place
Result<std::string> bytes_of(std::string_view utf8, const WrittenLetters& letters);

}  // namespace kadr
