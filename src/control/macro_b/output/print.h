#pragma once
// Formats the text that DPRNT and BPRNT print, and variables inside the text of #3107 (nct 23.2.13, 23.1.8). parse_print() parses the
// brackets of a print statement once; decimal() and binary() insert the values each time the statement is executed.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace kadr::macro_b {

/// One element of a print statement: fixed characters, or the value of a variable.
struct PrintPiece {
  std::string text;                 // fixed characters as they are printed; empty if the element is a value
  std::optional<std::size_t> slot;  // index in PrintValues of the variable to print; nullopt if the element is fixed text
  std::uint8_t before = 0;          // digits before the decimal point (DPRNT only)
  std::uint8_t after = 0;           // digits after the decimal point
  friend bool operator==(const PrintPiece&, const PrintPiece&) = default;
};
struct PrintText {
  std::vector<PrintPiece> pieces;
  std::size_t size = 0;  // length of the parsed text in characters, both brackets included
};

enum class PrintKind : std::uint8_t { decimal, binary };

/// The character that fills the unused leading positions of a number, as parameter N1757 Print Contr, bit #0 PNT, selects it.
enum class PrintFill : std::uint8_t {
  spaces,  // bit PNT is 0: a space is printed for the sign `+` and for each leading zero
  none,    // bit PNT is 1: neither the sign `+` nor leading zeros are printed
};

// values of the variables to print, indexed by PrintPiece::slot; nullopt for an empty variable
using PrintValues = std::span<const std::optional<double>>;

/// Reads the reference to a variable (`#130`, `#[#1+2]`, `#_OFSX[1]`) at the start of `rest`, and returns the length of the reference in
/// characters. The n-th successful call, counted from 0, reads the variable of slot n.
using ReadVariable = std::function<Result<std::size_t>(std::string_view rest)>;

/// Parses the bracketed text of a print statement, `[X#130[53]Y#500[53]T#10[20]]`.
///   text     starts at the opening bracket
///   kind     decimal: `#v[cd]` or `#v[c]` prints variable v with c digits before and d after the decimal point, 0 < c + d < 16;
///            binary: `#v[c]` with c = 0…8 digits after the point
///   alarms   print_format (the faulty text): a character that cannot be printed, or an invalid format; bracket_not_closed;
///            the alarms of read_variable, unchanged. Spans count from the start of `text`
///   manual   23.2.13. Letters, digits, `/ + -` are printed, `*` is printed as a space. Inferred: c and d are one digit each; small letters
///            are printed as capitals; blanks in the text are not printed
Result<PrintText> parse_print(std::string_view text, PrintKind kind, const ReadVariable& read_variable);

/// Parses the text of a message. `#v[cd]` is the value of variable v with c digits before and d after the decimal point, and `\n` is a line
/// break. All other characters are unchanged (inferred: also a `#` without format, and `*`). The function raises no alarm.
///   manual   23.1.8
PrintText parse_message(std::string_view text, const ReadVariable& read_variable);

/// Formats one value; an empty variable is formatted as 0.
///   before   c, number of digits before the decimal point
///   after    d, number of digits after the decimal point
///   returns  the value rounded to `after` decimals, ties away from zero, trailing zeros included; without a decimal point if `after` is 0.
///            With fill `spaces`: one character for the sign, `-` or space, then at least `before` characters
///   manual   23.2.13. Inferred: a value that rounds to 0 has no sign; a value below 1 has a single zero before the decimal point,
///            or none if c = 0; a whole part longer than c digits is printed in full
///   law      except for ties, the digits are those that printf prints
std::string decimal_number(std::optional<double> value, int before, int after, PrintFill fill);

/// Joins the elements, with the values inserted. The result is the text of a message, or a file name.
std::string joined(const std::vector<PrintPiece>& pieces, PrintValues values, PrintFill fill);

/// Returns the line that DPRNT prints: the elements with the values inserted, then CR LF.
std::string decimal(const std::vector<PrintPiece>& pieces, PrintValues values, PrintFill fill);

/// Returns the bytes that BPRNT prints, ending with CR LF. Text is unchanged. Each value is multiplied by 10^after, rounded (ties away from
/// zero), and printed as four bytes, the most significant first. An empty variable counts as 0. Inferred: negative values are in two's
/// complement.
///   alarms   value_limit (value): the value does not fit into 32 bits (inferred)
Result<std::string> binary(const std::vector<PrintPiece>& pieces, PrintValues values);

}  // namespace kadr::macro_b
