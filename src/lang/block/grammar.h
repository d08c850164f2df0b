#pragma once
// Grammar: the form in which a control writes blocks and words; it does not contain the meaning of a code. It is filled from the control's
// file (config/control/control_file). lang/block/format reads the format descriptors of that file.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lang/expression/expression_rules.h"
#include "lang/expression/variable_names.h"

namespace kadr {

/// An address is stored as one character: A to Z as they are; further characters stand for words with a comma (`,C`) and for names of
/// several characters (`XDE`, `S2`).
inline constexpr std::size_t max_addresses = 63;
inline constexpr char comma_chamfer = '[';    // ,C
inline constexpr char comma_rounding = '\\';  // ,R
inline constexpr char comma_angle = ']';      // ,A
inline constexpr char comma_vector = '^';     // ,L
inline constexpr char indirect_axis = '_';    // address of the word AX[n]=… until the block is executed, when the axis n is known
inline constexpr char first_name = '`';       // address of the first name in Grammar::names; those of the other names follow, up to '\x7f'

/// Returns the address of `,C` and similar words, or 0.
constexpr char comma_address(char letter) {
  return letter == 'C' ? comma_chamfer : letter == 'R' ? comma_rounding : letter == 'A' ? comma_angle : letter == 'L' ? comma_vector : '\0';
}

/// Returns an address as a program writes it: `X`, `,C`. Not for Grammar::names.
inline std::string address_written(char address) {
  for (const char letter : {'C', 'R', 'A', 'L'})
    if (comma_address(letter) == address) return {',', letter};
  return {address};
}

/// A name of several characters (nct 2.2, 11.1.1).
struct AddressName {
  std::string text;  // the name in upper case
  char address = first_name;
};

/// Formal parameters are R0 to R9 on the 2С42. On controls with several parameter letters they have two or three digits, and each letter
/// has a thousand indices: index = 1000 · (place of the letter in Grammar::long_parameters) + number.
inline constexpr int parameters_a_letter = 1000;
inline constexpr std::size_t max_long_parameters = 8;
/// Formal parameters may have a special sign instead of a letter (spec/correctors 3).
constexpr bool is_parameter_sign(char c) { return c == '#' || c == '@' || c == '$' || c == '&'; }

/// The name of a system variable: `#_ABSIO[n]` (nct 23.1.1).
struct VariableName {
  std::string text;
  std::uint32_t number = 0;  // number of the variable with the index first_index
  std::uint32_t count = 1;
  std::uint32_t first_index = 1;
  bool indexed = false;  // [n] must follow
};

/// The format of the digits of one address (ISO 6983 / GOST 20999-83 format descriptor, spec/gost 3).
struct WordFormat {
  bool known = false;             // true if the control has this address
  bool sign = false;              // a sign is allowed before the digits
  bool drop_zeros = true;         // leading zeros may be dropped; if not, every digit must be written
  bool point = false;             // an explicit decimal point is allowed
  std::uint8_t counted = 0;       // a number without a point is divided by ten to this power, unless a variable gives it (spec/fanuc 1.3)
  bool implied = false;           // a number without a decimal point: its last `fraction_digits` digits are the fraction
  std::uint8_t whole_digits = 0;  // maximum number of digits before the decimal point; 0 = any number
  std::uint8_t fraction_digits = 0;  // maximum number of digits after the decimal point; with whole_digits 0: any number
  std::uint8_t at_most = 1;          // maximum number of words with this address in a block; 0 = any number
  bool code = false;                 // G and M: the number names a code (leading zeros mean nothing)
  std::uint8_t code_digits = 0;      // for a code: digits in the format; fewer give a warning; 0 = any number
  bool second_number = false;        // a second number may follow: `L2 15` (spec/correctors 1)
  bool parameter = false;            // the value may be a formal parameter: `X+R1`, `Z-1200+R2` (spec/s2c42 3)
  bool increment = false;            // the operator I is allowed before the number (nct 5.1)
  bool one_more = false;             // an additional leading digit means that the tool is in the spindle: T112 (spec/s2c42 6.4.4)
  bool bare = false;                 // allowed without a number: `G17 X` (nct 10.4)
};

enum class EndOfBlock : std::uint8_t {
  line,       // the end of the line; a literal ПС or LF is accepted too
  line_only,  // the end of the line only
};

struct Grammar {
  std::array<WordFormat, max_addresses> words{};  // by address
  EndOfBlock end_of_block = EndOfBlock::line;
  bool mark_everywhere = true;         // if one block of the file ends with ПС or LF, every block must end so
  bool block_number_required = false;  // every block begins with N or ':' (2С42 6.2)
  bool main_blocks = false;            // a main block, written as ':' and a number, is allowed
  bool percent_ignored = false;        // a line of '%' has no meaning (Mach3)
  bool percent_number = false;         // the program's number may follow '%'
  std::uint8_t percent_digits = 5;
  bool program_start_required = false;  // the main program begins with '%'
  bool skip_levels = false;             // block skip may have a level: '/n' as well as '/'
  bool semicolon_comments = false;      // comments from ';' to the end of the line
  bool slash_comments = false;          // comments from '//' to the end of the line
  std::string comment_forbidden;        // characters that are not allowed in ( )
  bool expressions = false;             // #n and [expr] are allowed in words, and #n=expr in a block (Mach3)
  ExpressionRules expression;           // operators and functions that expressions may contain
  bool lower_case = true;               // small letters are read as capitals
  char parameter_address = 0;           // 'R' if R0..R9 are formal parameters (2С42 6.3.7)
  std::string long_parameters;          // "RPE#": R01, P123, #12 are formal parameters if a sign or = follows (spec/correctors 3)
  char label_address = 0;               // 'O' if Onnnn starts a subprogram (Mach3)
  char section_address = 0;             // 'L' if an L without a number starts the part of the file with subprograms (2С42 6.3.5)
  bool zero_between_slashes = false;    // G92 /2/: the number between slashes is a word with the address A (2С42, last section)
  std::uint32_t block_length = 0;       // maximum number of characters in a block, 0 = any number
  std::uint32_t variables = 0;          // greatest number n of a variable #n
  // ---- RS274/NGC as in LinuxCNC (spec/linuxcnc)
  bool o_words = false;           // O lines are allowed: O100 while […] (spec/linuxcnc 6)
  bool percent_encloses = false;  // `%` alone in its line starts the program and ends it (spec/linuxcnc 2.1)
  bool code_by_rounding = false;  // a computed code, G[10*0.1], may be off by 0.001; N may have a decimal point (spec/linuxcnc 2.2, 2.3)
  std::shared_ptr<VariableNames> named_variables;  // numbers of the names #<name>; nullptr if the control has none
  bool filtered_lines = false;                     // each line is read alone, without blanks, `/` and control characters (spec/grbl 1.2)
  // ---- custom macros and names of several characters (nct)
  bool custom_macros = false;                  // expressions are those of custom macros (nct 23), not of RS274/NGC: see the functions below
  bool operator_i = false;                     // XI-40: the value of this word is an increment (nct 5.1)
  bool comments_span_lines = false;            // (…) may contain ends of line (nct 14.3)
  bool comma_words = false;                    // ,C ,R ,A are addresses (nct 17)
  bool file_names = false;                     // M98 <name> calls a file (nct 14.4.2)
  bool short_words = false;                    // WH[…], SI[30]: the first two letters are enough (spec/fanuc 5.4)
  bool colon_is_label = false;                 // `:0100` is O0100 (spec/fanuc 1.1)
  bool condition_alone = false;                // `[#1 LT 10] M99 P10`: a condition without the word IF (spec/haas 2.3)
  bool conditions_are_values = true;           // a condition has the value 1 or 0: #1=[#2 EQ 3], IF[#1] (spec/fanuc 5.3, 5.4: not allowed)
  bool condition_words = true;                 // words of a block may follow a condition: IF[…] G0 X1 (spec/fanuc 5.4: not allowed)
  bool assignment_and_words = false;           // words may follow an assignment after a condition: IF[…] THEN #7=1 S800 (spec/haas 2.3)
  bool ports_without_number = false;           // POPEN, PCLOS have no number (spec/fanuc 5.9)
  bool programs_by_label = false;              // O… starts the next program of the file (spec/fanuc 1.1, 5.4)
  bool percent_frames = false;                 // a program starts after the first % and ends at the next (spec/fanuc 1.1)
  std::shared_ptr<VariableNames> given_names;  // names that SETVN gives to variables, [#NAME] (spec/fanuc 5.1); nullptr: no SETVN
  bool rounds_in_address = false;              // ROUND in a word's value rounds to 0.001 mm, 0.0001 in (spec/haas 2.2)
  bool semicolon_ends = false;                 // `;` ends the block; another block may follow in the same line (spec/fanuc 1.2)
  std::string least_increments;       // addresses whose numbers are in units of 0.001 if written without a decimal point (spec/fanuc 1.3)
  std::vector<AddressName> names;     // names of several characters, in the order of their addresses
  std::uint32_t named = 0;            // one bit for each letter: set if a name in `names` starts with this letter
  std::vector<VariableName> symbols;  // sorted by text
  std::array<std::uint8_t, max_addresses> axis_numbers{};  // control-wide number of each axis address, 0: not an axis

  // ---- features of custom macros that RS274/NGC expressions do not have
  /// Returns true if the control has statements: IF, WHILE, GOTO, DPRNT, … An assignment is then a statement too, in a block without words.
  bool has_statements() const { return custom_macros; }
  /// Returns true if each call has its own #1 to #33, and a variable may be vacant. A word with a vacant value counts as not written.
  bool has_vacant_variables() const { return custom_macros; }
  /// Returns true if `#1=#2+3` is allowed; RS274/NGC requires `#1=[#2+3]`.
  bool sums_without_brackets() const { return custom_macros; }
  /// Returns true if a code that is written as an expression is rounded to the nearest whole number, provided that its address accepts only
  /// whole numbers (nct 23.1.1).
  bool rounds_codes_of_expressions() const { return custom_macros; }

  const WordFormat& word(char letter) const { return words[static_cast<std::size_t>(letter - 'A')]; }
  WordFormat& word(char letter) { return words[static_cast<std::size_t>(letter - 'A')]; }
};

/// Limits for every control, so that no input can use unlimited memory or time.
namespace limits {
inline constexpr std::uint32_t line_bytes = 64 * 1024;  // greatest length of a line; a longer line raises an alarm and is skipped
inline constexpr std::uint32_t block_words = 64;
inline constexpr std::uint32_t expression_depth = 64;    // greatest depth of nested brackets
inline constexpr std::uint32_t expression_steps = 1024;  // greatest number of instructions of all expressions in a block
inline constexpr std::uint32_t block_assignments = 32;   // greatest number of assignments #n=… in a block
inline constexpr std::uint32_t comment_bytes = 4096;     // stored length of a comment over several lines
inline constexpr std::uint32_t long_comments = 64;       // maximum number of comments over several lines in one block
inline constexpr std::uint32_t conditions = 4;           // greatest number of conditions in a block: IF[…] IF[…] …
inline constexpr std::uint32_t call_arguments = 30;  // greatest number of arguments of a call: O100 call [1] [2] … (spec/linuxcnc 6.2)
}  // namespace limits

}  // namespace kadr
