#pragma once
// Encodings of program text: which one a file has, and one line of it as UTF-8 (iconv).

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace kadr {

enum class Encoding : std::uint8_t {
  utf8,     // and plain ASCII
  cp1251,
  koi8r,
  cp866,
  iso7,     // image of a punched tape: a byte a row, eighth track even parity; SO/SI switch to Russian letters (KOI-7 Н1)
};

std::string_view name_of(Encoding encoding);                       // "utf-8", "cp1251", …
std::optional<Encoding> encoding_named(std::string_view name);     // "koi8-r", "CP866", …

/// The most likely encoding of a sample of program text: valid UTF-8 is UTF-8; a tape image has even parity in
/// (nearly) every row; among the one-byte Russian ones the letters' frequencies decide.
///   returns  nothing where the sample holds no byte above 127: every one fits
std::optional<Encoding> detect_encoding(std::string_view sample);

/// Appends `bytes` as UTF-8 to `text`.
///   alarms  bad_encoding, with the byte that has no meaning; parity_error with the row of the line, counted from 1
Status append_utf8(std::string_view bytes, Encoding encoding, std::string& text);

/// The Latin capital that a Cyrillic capital or small letter looks like (Х → X), or 0.
char look_alike(char32_t letter);

}  // namespace kadr
