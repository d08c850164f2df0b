#pragma once
// Grammar: the form in which blocks and words are written for a control, without the meaning of the codes. The grammar is read from the
// control's file (config/control/control_file). lang/block/format reads the format descriptors of that file.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lang/expression/expression_rules.h"
#include "lang/expression/variable_names.h"

namespace kadr {

/// An address is stored as one character. A to Z stand for themselves. Further characters stand for words with a comma (`,C`) and for names
/// of several characters (`XDE`, `S2`).
inline constexpr std::size_t max_addresses = 63;
inline constexpr char comma_chamfer = '[';    // ,C
inline constexpr char comma_rounding = '\\';  // ,R
inline constexpr char comma_angle = ']';      // ,A
inline constexpr char comma_vector = '^';     // ,L
inline constexpr char indirect_axis = '_';    // address of the word AX[n]=… until the block is executed; then the axis n is known
// Address of the first name in Grammar::names; the addresses of the other names follow, up to '\x7f'.
inline constexpr char first_name = '`';

/// Returns the address of `,C` and similar words, or 0.
constexpr char comma_address(char letter) {
  return letter == 'C' ? comma_chamfer : letter == 'R' ? comma_rounding : letter == 'A' ? comma_angle : letter == 'L' ? comma_vector : '\0';
}

/// Returns an address in the form in which a program writes it: `X`, `,C`. Not to be used for the addresses of Grammar::names.
inline std::string address_written(char address) {
  for (const char letter : {'C', 'R', 'A', 'L'})
    if (comma_address(letter) == address) return {',', letter};
  return {address};
}

/// A name of several characters (nct 2.2, 11.1.1).
struct AddressName {
  std::string text;  // text of the name in upper case, as a program may write it
  char address = first_name;
};

/// Formal parameters are R0 to R9 on the 2С42. On controls with several parameter letters they have two or three digits. Each letter has a
/// thousand indices: index = 1000 · (position of the letter in Grammar::long_parameters) + number.
inline constexpr int parameters_a_letter = 1000;
inline constexpr std::size_t max_long_parameters = 8;
/// Formal parameters may have a special sign instead of a letter (spec/correctors 3).
constexpr bool is_parameter_sign(char c) { return c == '#' || c == '@' || c == '$' || c == '&'; }

/// The name of a system variable, such as `#_ABSIO[n]` (nct 23.1.1).
struct VariableName {
  std::string text;
  std::uint32_t number = 0;  // number of the variable with the lowest index (first_index in control_def.h)
  std::uint32_t count = 1;
  std::uint32_t first_index = 1;
  bool indexed = false;  // an index [n] must follow the name
};

/// The format of the digits of one address (format descriptor of ISO 6983 and GOST 20999-83; spec/gost 3).
struct WordFormat {
  bool known = false;      // true: the control has words with this address
  bool sign = false;       // a sign is allowed before the digits
  bool drop_zeros = true;  // leading zeros may be omitted; if not, every digit must be written
  bool point = false;      // an explicit decimal point is allowed
  // Exponent of the power of ten by which a number without a point is divided, unless a variable gives it (spec/fanuc 1.3).
  std::uint8_t counted = 0;
  bool implied = false;              // in a number without a decimal point the last `fraction_digits` digits are the fraction
  std::uint8_t whole_digits = 0;     // greatest number of digits before the decimal point; 0: any number
  std::uint8_t fraction_digits = 0;  // greatest number of digits after the decimal point; if whole_digits is 0: any number
  std::uint8_t at_most = 1;          // greatest number of words with this address in a block; 0: any number
  bool code = false;                 // the number is that of a code (G and M), so leading zeros mean nothing
  // number of digits with which G and M codes are to be written; a code with fewer digits gives a warning; 0: any number
  std::uint8_t code_digits = 0;
  bool second_number = false;  // a second number may follow: `L2 15` (spec/correctors 1)
  bool parameter = false;      // the value may have a formal parameter: `X+R1`, `Z-1200+R2` (spec/s2c42 3)
  bool increment = false;      // the operator I, for an increment, is allowed before the number (nct 5.1)
  bool one_more = false;       // an additional leading digit is allowed and means that the tool is in the spindle: T112 (spec/s2c42 6.4.4)
  bool bare = false;           // the address is allowed without a number: `G17 X` (nct 10.4)
};

enum class EndOfBlock : std::uint8_t {
  line,       // the end of the line ends the block; a literal ПС or LF before it is accepted too
  line_only,  // only the end of the line ends the block
};

struct Grammar {
  std::array<WordFormat, max_addresses> words{};  // by address
  EndOfBlock end_of_block = EndOfBlock::line;
  bool mark_everywhere = true;         // if one block of the file ends with ПС or LF, every block must end with ПС or LF
  bool block_number_required = false;  // every block must begin with N or `:` (2С42 6.2)
  bool main_blocks = false;            // a main block, written as ':' and a number, is allowed
  bool percent_ignored = false;        // a line with `%` has no effect (Mach3)
  bool percent_number = false;         // the number of the program may follow `%`
  std::uint8_t percent_digits = 5;
  bool program_start_required = false;  // the main program must begin with `%`
  bool skip_levels = false;             // block skip may have a level: `/n` is allowed as well as `/`
  bool semicolon_comments = false;      // a comment may be written from `;` to the end of the line
  bool slash_comments = false;          // a comment may be written from `//` to the end of the line
  std::string comment_forbidden;        // characters that are not allowed in a comment in brackets
  bool expressions = false;             // #n and [expr] are allowed in words, and #n=expr is allowed in a block (Mach3)
  ExpressionRules expression;           // operators and functions that expressions may contain
  bool lower_case = true;               // small letters are accepted, and read as capitals
  char parameter_address = 0;           // 'R' if R0..R9 are formal parameters (2С42 6.3.7); 0: no formal parameters
  // Letters of formal parameters: with "RPE#", R01, P123 and #12 are parameters if a sign or = follows (spec/correctors 3).
  std::string long_parameters;
  char label_address = 0;    // 'O' if Onnnn starts a subprogram (Mach3); 0: no labels
  char section_address = 0;  // 'L' if an L without a number starts the part of the file with the subprograms (2С42 6.3.5); 0: no such part
  bool zero_between_slashes = false;  // the number between slashes, as in G92 /2/, is a word with the address A (2С42, last section)
  std::uint32_t block_length = 0;     // greatest number of characters in a block; 0: any number
  std::uint32_t variables = 0;        // greatest number n of a variable #n; 0: no variables
  // ---- RS274/NGC as in LinuxCNC (spec/linuxcnc)
  bool o_words = false;           // O lines are allowed, such as O100 while […] (spec/linuxcnc 6)
  bool percent_encloses = false;  // a line with only `%` starts the program, the next one ends it (spec/linuxcnc 2.1)
  // true: a computed code, such as G[10*0.1], may differ from the code's number by 0.001, and N may have a decimal point (spec/linuxcnc
  // 2.2, 2.3)
  bool code_by_rounding = false;
  std::shared_ptr<VariableNames> named_variables;  // numbers of the names #<name>; nullptr if the control has no named variables
  bool filtered_lines = false;  // each line is read separately, without its blanks, `/` and control characters (spec/grbl 1.2)
  // ---- statements and words with names, as on a Sinumerik (spec/sinumerik 2, 3)
  bool named_blocks = false;     // blocks have names, assignments and calls: R1=5, X=IC(R1), CYCLE81(…); lang/named reads them
  bool klartext_blocks = false;  // blocks are conversational: L X+10 R0 FMAX, CYCL DEF 200 …; lang/klartext reads them (spec/heidenhain 1)
  // ---- custom macros and names of several characters (nct)
  bool custom_macros = false;         // expressions are those of custom macros (nct 23), not those of RS274/NGC
  bool operator_i = false;            // in XI-40 the operator I means that the value of the word is an increment (nct 5.1)
  bool comments_span_lines = false;   // a comment in (…) may contain ends of lines (nct 14.3)
  bool comma_words = false;           // ,C ,R ,A are addresses (nct 17)
  bool file_names = false;            // a file may be called by its name: M98 <name> (nct 14.4.2)
  bool short_words = false;           // the first two letters of a keyword or function are enough: WH[…], SI[30] (spec/fanuc 5.4)
  bool colon_is_label = false;        // `:0100` is the label O0100 (spec/fanuc 1.1)
  bool condition_alone = false;       // a condition may be written without the word IF: `[#1 LT 10] M99 P10` (spec/haas 2.3)
  bool conditions_are_values = true;  // a condition has the value 1 or 0, as in #1=[#2 EQ 3] and IF[#1]; not allowed by spec/fanuc 5.3, 5.4
  bool condition_words = true;        // words of a block may follow a condition, as in IF[…] G0 X1; not allowed by spec/fanuc 5.4
  bool assignment_and_words = false;  // words may follow an assignment after a condition, as in IF[…] THEN #7=1 S800 (spec/haas 2.3)
  bool ports_without_number = false;  // POPEN and PCLOS are written without a number (spec/fanuc 5.9)
  bool programs_by_label = false;     // a label O… starts the next program of the file (spec/fanuc 1.1, 5.4)
  bool percent_frames = false;        // a program starts after the first % and ends at the next % (spec/fanuc 1.1)
  // Names that SETVN gives to variables, read as [#NAME] (spec/fanuc 5.1); nullptr: the control has no SETVN.
  std::shared_ptr<VariableNames> given_names;
  bool rounds_in_address = false;  // ROUND in the value of a word rounds to 0.001 mm or 0.0001 in (spec/haas 2.2)
  bool semicolon_ends = false;     // `;` ends the block, and another block may follow in the same line (spec/fanuc 1.2)
  // Addresses whose numbers are in units of 0.001 if they are written without a decimal point (spec/fanuc 1.3).
  std::string least_increments;
  std::vector<AddressName> names;                          // names of several characters, in the order of their addresses
  std::uint32_t named = 0;                                 // first letters of the names in `names`, one bit for each letter
  std::vector<VariableName> symbols;                       // sorted by text
  std::array<std::uint8_t, max_addresses> axis_numbers{};  // number of each axis address across all channels; 0: the address is not an axis

  // ---- features of custom macros that RS274/NGC expressions do not have

  /// Returns true if the control has statements such as IF, WHILE, GOTO, DPRNT. On such a control an assignment in a block without words is
  /// a statement too.
  bool has_statements() const { return custom_macros; }
  /// Returns true if each call has its own variables #1 to #33, and a variable may be vacant. A word with a vacant value counts as not
  /// written.
  bool has_vacant_variables() const { return custom_macros; }
  /// Returns true if sums without brackets are allowed, such as `#1=#2+3`. RS274/NGC requires `#1=[#2+3]`.
  bool sums_without_brackets() const { return custom_macros; }
  /// Returns true if the value of a code that is written as an expression is rounded to the nearest whole number. This applies if the
  /// address accepts only whole numbers (nct 23.1.1).
  bool rounds_codes_of_expressions() const { return custom_macros; }

  const WordFormat& word(char letter) const { return words[static_cast<std::size_t>(letter - 'A')]; }
  WordFormat& word(char letter) { return words[static_cast<std::size_t>(letter - 'A')]; }
};

/// The limits that apply to every control, so that no input can use unlimited memory or time.
namespace limits {
inline constexpr std::uint32_t line_bytes = 64 * 1024;  // greatest length of a line in bytes; a longer line raises an alarm and is skipped
inline constexpr std::uint32_t block_words = 64;
inline constexpr std::uint32_t expression_depth = 64;    // greatest depth of nested brackets in an expression
inline constexpr std::uint32_t expression_steps = 1024;  // greatest number of instructions of all expressions in a block
inline constexpr std::uint32_t block_assignments = 32;   // greatest number of assignments #n=… in one block
inline constexpr std::uint32_t comment_bytes = 4096;     // number of bytes that are stored of a comment over several lines
inline constexpr std::uint32_t long_comments = 64;       // greatest number of comments over several lines in one block
inline constexpr std::uint32_t conditions = 4;           // greatest number of conditions in a block: IF[…] IF[…] …
inline constexpr std::uint32_t call_arguments = 30;  // greatest number of arguments of a call: O100 call [1] [2] … (spec/linuxcnc 6.2)
}  // namespace limits

}  // namespace kadr
