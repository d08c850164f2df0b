#pragma once
// Punched tape: rows of eight tracks in the ISO 7-bit code with even parity, and text (2С42 6.1, GOST 20999-83).

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace kadr {

/// The byte of one row: seven bits of code and the eighth track that makes the number of holes even.
std::uint8_t with_even_parity(std::uint8_t code);
bool has_even_parity(std::uint8_t row);

enum class TapeCode : std::uint8_t {
  iso,  // ISO 7-bit, even parity in the eighth track; Russian letters in its other register (KOI-7 Н1)
  eia,  // EIA RS-244, odd parity in the fifth
};

/// The code of a tape as text, a row after the other; remembers which register SO and SI have set. Each line begins
/// with Latin letters, so that a line can be read alone.
class TapeLetters {
 public:
  /// Appends the character of one row without its eighth track; NUL, DEL, CR, SO and SI give none.
  void append(std::uint8_t code, std::string& text);

 private:
  bool russian_ = false;
};

/// A row that cannot be read.
struct TapeFault {
  std::uint64_t row;  // counted from 1
  std::uint8_t byte;
};

struct TapeText {
  std::string text;               // UTF-8, a line a block
  std::vector<TapeFault> faults;  // rows of the wrong parity or without a character, at most 1000; their characters are '?' in the text
};

/// Rows → text. NUL (blank tape) and DEL (deleted row) are left out, CR too; SO and SI switch to Russian letters and back.
TapeText decode_tape(std::string_view rows, TapeCode code = TapeCode::iso);

/// UTF-8 text → rows, with a leader and trailer of blank tape. The end of a line, a literal ПС or LF at its end become
/// one LF; a last line without its end gets one. Russian letters stand between SO and SI;
/// in EIA code small letters become capitals.
///   alarms  not a character of the code: bad_encoding, with its place in the text and the character (Ё and Ъ have no
///           code; NUL, DEL, SO, SI and CR within a line would be lost in reading; EIA has no ':' and no Russian letters)
///   law     decode_tape(encode_tape(t)) == t for text of the code with one line end a block
Result<std::string> encode_tape(std::string_view text, std::size_t leader_rows, TapeCode code = TapeCode::iso);

}  // namespace kadr
