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
  eia,   // image of a punched tape in the code EIA RS-244: odd parity, 200 octal ends a block
  iso7,  // image of a punched tape: one byte per row, eighth track even parity; SO/SI switch to Russian letters (KOI-7 Н1)
};

std::string_view name_of(Encoding encoding);                    // "utf-8", "cp1251", …
std::optional<Encoding> encoding_named(std::string_view name);  // "koi8-r", "CP866", …

/// Returns the most likely encoding of a sample of program text. The image of a tape is recognised by its rows
/// (lang/text/tape_orientation). A sample of valid UTF-8 counts as UTF-8, even if its last character is incomplete; an exception is a
/// sample that reads as small Russian letters in CP866. Among the one-byte Russian encodings the frequencies of letter pairs decide, so
/// that a single word such as ПС is enough.
///   returns  nullopt if the sample has no byte above 127: every encoding fits
std::optional<Encoding> detect_encoding(std::string_view sample);

/// Returns true for tape images: one byte per row, each with its parity.
inline bool is_tape(Encoding encoding) { return encoding == Encoding::iso7 || encoding == Encoding::eia; }

/// Appends the `bytes` of one line to `text` as UTF-8; on an alarm, appends only the text before the fault.
///   alarms  bad_encoding, with the byte that has no meaning; parity_error, with the number of the row in the line, counted from 1;
///           the Span of the alarm is the location of the byte in `bytes`
///   law     `text` remains valid UTF-8, whatever the bytes
Status append_utf8(std::string_view bytes, Encoding encoding, std::string& text);

/// One UTF-8 character; its size is 0 if the text does not start with a complete, valid character.
struct Character {
  char32_t code = 0;
  std::size_t size = 0;
};
Character first_character(std::string_view text);

/// Returns a byte above 127 of cp1251, koi8r or cp866 as UTF-8; empty if the byte has no meaning.
std::string_view utf8_of(Encoding encoding, std::uint8_t byte);

/// Returns the Latin capital that a Cyrillic letter, capital or small, looks like (Х → X), or 0.
char look_alike(char32_t letter);

}  // namespace kadr
