#pragma once
// Encodings of program text: which one a file has, and one line of it as UTF-8 (iconv).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace kadr {

enum class Encoding : std::uint8_t {
  utf8,  // and plain ASCII
  cp1251,
  koi8r,
  cp866,
  eia,   // image of a punched tape in the code EIA RS-244: odd parity, 200 octal ends a block
  iso7,  // image of a punched tape: a byte a row, eighth track even parity; SO/SI switch to Russian letters (KOI-7 Н1)
};

std::string_view name_of(Encoding encoding);                    // "utf-8", "cp1251", …
std::optional<Encoding> encoding_named(std::string_view name);  // "koi8-r", "CP866", …

/// The most likely encoding of a sample of program text: a tape image is like one of a program (lang/text/tape_side); valid
/// UTF-8 is UTF-8 (its last character may be cut), unless it reads as small Russian letters of CP866; among the
/// one-byte Russian ones the frequencies of pairs of letters decide, so that a single word such as ПС is enough.
///   returns  nothing where the sample holds no byte above 127: every one fits
std::optional<Encoding> detect_encoding(std::string_view sample);

/// A row a byte, each with its parity.
inline bool is_tape(Encoding encoding) { return encoding == Encoding::iso7 || encoding == Encoding::eia; }

/// Appends one line's `bytes` as UTF-8 to `text`; on an alarm, what stands before the fault.
///   alarms  bad_encoding, with the byte that has no meaning; parity_error with the row of the line, counted from 1;
///           their Span is the byte's place in `bytes`
///   law     `text` stays valid UTF-8, whatever the bytes
Status append_utf8(std::string_view bytes, Encoding encoding, std::string& text);

/// One character of UTF-8; size 0 where the text does not begin with a whole, valid one.
struct Character {
  char32_t code = 0;
  std::size_t size = 0;
};
Character first_character(std::string_view text);

/// A byte above 127 of cp1251, koi8r or cp866 as UTF-8; empty where it has no meaning.
std::string_view utf8_of(Encoding encoding, std::uint8_t byte);

/// The Latin capital that a Cyrillic capital or small letter looks like (Х → X), or 0.
char look_alike(char32_t letter);

}  // namespace kadr
