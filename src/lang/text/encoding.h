#pragma once
// Encodings of program text: detects the encoding of a file, and converts its lines to UTF-8 (iconv).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace kadr {

enum class Encoding : std::uint8_t {
  utf8,  // UTF-8, including plain ASCII
  cp1251,
  koi8r,
  cp866,
  eia,  // image of a punched tape in the code EIA RS-244, with odd parity; the byte 200 (octal) ends a block
  // Image of a punched tape in ISO 7-bit code: one byte per row, even parity by the eighth track; SO and SI switch to Russian letters
  // (KOI-7 Н1) and back.
  iso7,
};

std::string_view name_of(Encoding encoding);                    // Returns the name of an encoding: "utf-8", "cp1251", …
std::optional<Encoding> encoding_named(std::string_view name);  // Returns the encoding with this name: "koi8-r", "CP866", …

/// Returns the most probable encoding of a sample of program text. The image of a tape is recognised by its rows
/// (lang/text/tape_orientation). A sample of valid UTF-8 counts as UTF-8, even if its last character is incomplete; the exception is a
/// sample that reads as small Russian letters in CP866. Among the one-byte Russian encodings the frequencies of letter pairs decide, so a
/// single word such as ПС is enough.
///   returns  nullopt if the sample has no byte above 127, because then every encoding fits
std::optional<Encoding> detect_encoding(std::string_view sample);

/// Returns true for the images of tapes, which have one byte per row, each with its parity.
inline bool is_tape(Encoding encoding) { return encoding == Encoding::iso7 || encoding == Encoding::eia; }

/// Appends the `bytes` of one line to `text` in UTF-8. On an alarm, only the text before the fault is appended.
///   alarms  bad_encoding, with the byte that has no meaning; parity_error, with the number of the row in the line, counted from 1; the
///     Span of the alarm is the location of the byte in `bytes`
///   law     `text` remains valid UTF-8, whatever the bytes
Status append_utf8(std::string_view bytes, Encoding encoding, std::string& text);

/// One UTF-8 character. Its size is 0 if the text does not start with a complete, valid character.
struct Character {
  char32_t code = 0;
  std::size_t size = 0;
};
Character first_character(std::string_view text);

/// Returns a byte above 127 of cp1251, koi8r or cp866 in UTF-8; an empty text if the byte has no meaning.
std::string_view utf8_of(Encoding encoding, std::uint8_t byte);

/// Returns the Latin capital that looks like a Cyrillic letter, capital or small (X for Х); 0 if no Latin capital looks like it.
char look_alike(char32_t letter);

}  // namespace kadr
