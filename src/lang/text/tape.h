#pragma once
// Converts between punched tape, which has rows of eight tracks in the ISO 7-bit code with even parity, and text (2С42 6.1, GOST 20999-83).

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace kadr {

/// Returns the byte of one row. Seven bits are the code; the eighth track makes the number of punched holes even.
std::uint8_t with_even_parity(std::uint8_t code);
bool has_even_parity(std::uint8_t row);

enum class TapeCode : std::uint8_t {
  iso,  // ISO 7-bit code, with even parity by the eighth track; SO switches to Russian letters (KOI-7 Н1)
  eia,  // EIA RS-244, with odd parity by the fifth track
};

/// Converts the rows of a tape to text, row by row. SO and SI select the register: Russian or Latin letters. The selected register remains
/// in force up to the end of the line. Each line starts with Latin letters, so that a line can be read without the lines before it.
class TapeLetters {
 public:
  /// Appends the character of one row; `code` is the row without its eighth track. Nothing is appended for NUL, DEL, CR, SO and SI.
  void append(std::uint8_t code, std::string& text);

 private:
  bool russian_ = false;
};

/// A row of the tape that cannot be read.
struct TapeFault {
  std::uint64_t row;  // number of the row, counted from 1
  std::uint8_t byte;
};

struct TapeText {
  std::string text;               // text of the tape in UTF-8, one line per block
  std::vector<TapeFault> faults;  // at most 1000 rows that have wrong parity or no character; `text` has '?' in their place
};

/// Converts rows to text. NUL (blank tape), DEL (deleted row) and CR are omitted. SO and SI switch to Russian letters and back.
TapeText decode_tape(std::string_view rows, TapeCode code = TapeCode::iso);

/// Converts UTF-8 text to rows, with a leader and trailer of blank tape. Each end of line, together with a literal ПС or LF before it,
/// becomes one row LF; a last line without an end also gets a row LF. Russian letters are put between SO and SI; in EIA code small letters
/// become capitals.
///   alarms  bad_encoding for a character that the code does not have, with the location of the character in the text. Ё and Ъ have no
///     code; NUL, DEL, SO, SI and CR within a line would be lost in reading; EIA has no ':' and no Russian letters
///   law     decode_tape(encode_tape(t)) == t for text of the code with one line end per block
Result<std::string> encode_tape(std::string_view text, std::size_t leader_rows, TapeCode code = TapeCode::iso);

}  // namespace kadr
