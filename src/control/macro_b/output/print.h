#pragma once
// Formats what DPRNT and BPRNT send, and variables inside the text of #3107 (nct 23.2.13, 23.1.8).
// parse_print() parses the bracket once; decimal() and binary() insert the values each time the statement is executed.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace kadr::macro_b {

/// Fixed characters, or the value of a variable.
struct PrintPiece {
  std::string text;                 // as it is sent; empty for a value
  std::optional<std::size_t> slot;  // index of the value
  std::uint8_t before = 0;          // digits before the point (decimal)
  std::uint8_t after = 0;           // decimals
  friend bool operator==(const PrintPiece&, const PrintPiece&) = default;
};
struct PrintText {
  std::vector<PrintPiece> pieces;
  std::size_t size = 0;  // length of the parsed text, both brackets included
};

enum class PrintKind : std::uint8_t { decimal, binary };

/// N1757 Print Contr, bit #0 PNT.
enum class PrintFill : std::uint8_t {
  spaces,  // 0: a space for the sign `+` and for each leading zero
  none,    // 1: neither is sent
};

using PrintValues = std::span<const std::optional<double>>;  // by slot; nullopt: an empty variable

/// Reads the reference to a variable (`#130`, `#[#1+2]`, `#_OFSX[1]`) at the start of `rest`; returns how long it is.
/// Slots count the calls that succeeded, from 0.
using ReadVariable = std::function<Result<std::size_t>(std::string_view rest)>;

/// Parses `[X#130[53]Y#500[53]T#10[20]]`, from its bracket on.
///   kind     decimal: #v[cd], #v[c], 0 < c + d < 16; binary: #v[c], c = 0…8, decimals
///   alarms   print_format (the piece): a character that cannot be sent, or an invalid format; bracket_not_closed;
///            the alarms of read_variable, unchanged. Spans count from the start of `text`
///   manual   23.2.13. Letters, digits, `/ + -` are sent, `*` as a space. Inferred: c and d are a digit each; small letters are
///            sent as capitals; blanks are ignored
Result<PrintText> parse_print(std::string_view text, PrintKind kind, const ReadVariable& read_variable);

/// Parses the text of a message: `#v[cd]` is a value, `\n` a line break; all else stays as it is (inferred: also a `#` without
/// format, and `*`). Gives no alarm.
///   manual   23.1.8
PrintText parse_message(std::string_view text, const ReadVariable& read_variable);

/// Formats one value; an empty one as 0.
///   before, after  digits (c, d)
///   returns  the value rounded to `after` decimals, half away from zero, with all of them; without decimals there is no point. Fill
///            `spaces`: one character for the sign, `-` or space, then `before` characters
///   manual   23.2.13. Inferred: a value that rounds to 0 has no sign; below 1 a single zero is sent before the point,
///            none with c = 0; a whole part longer than c is sent in full
///   law      the same number that printf rounds to, except for ties
std::string decimal_number(std::optional<double> value, int before, int after, PrintFill fill);

/// Concatenates the pieces: the text of a message, or a file name.
std::string joined(const std::vector<PrintPiece>& pieces, PrintValues values, PrintFill fill);

/// What DPRNT sends: the pieces, then CR LF.
std::string decimal(const std::vector<PrintPiece>& pieces, PrintValues values, PrintFill fill);

/// What BPRNT sends: text as it is; each value · 10^after, rounded half away from zero, as four bytes, the most significant first; then
/// CR LF. An empty variable is 0. Inferred: two's complement.
///   alarms   value_limit (value): it does not fit into 32 bits (inferred)
Result<std::string> binary(const std::vector<PrintPiece>& pieces, PrintValues values);

}  // namespace kadr::macro_b
