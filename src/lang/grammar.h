#pragma once
// How a control writes blocks and words: the form only, never what a code means.
// Filled from the control's file (config/control_file); descriptor strings: lang/format.

#include <array>
#include <cstdint>
#include <string>

namespace kadr {

/// How the digits of one address are written (ISO 6983 / GOST 20999-83 format descriptor, spec/gost 3).
struct WordFormat {
  bool known = false;                // the control has this address
  bool sign = false;                 // a sign may stand before the digits
  bool drop_zeros = true;            // leading zeros may be dropped; if not, every digit must be written
  bool point = false;                // an explicit decimal point is understood
  bool implied = false;              // without a point the last `fraction_digits` digits are the fraction
  std::uint8_t whole_digits = 0;     // at most, before the point; 0 = free
  std::uint8_t fraction_digits = 0;  // at most, after the point; with whole_digits 0: free
  std::uint8_t at_most = 1;          // words of this address in a block; 0 = any number
  bool code = false;                 // G and M: the number names a code (leading zeros mean nothing)
  bool second_number = false;        // a second number may follow: `L2 15` (spec/correctors 1)
  bool parameter = false;            // takes a formal parameter: `X+R1`, `Z-1200+R2` (spec/s2c42 3)
};

enum class EndOfBlock : std::uint8_t {
  line,       // the end of the line; a literal ПС or LF is understood too
  line_only,  // nothing but the end of the line
};

struct Grammar {
  std::array<WordFormat, 26> words{};  // by letter, A..Z
  EndOfBlock end_of_block = EndOfBlock::line;
  bool mark_everywhere = true;         // where one block of the file ends with ПС or LF, all must
  bool block_number_required = false;  // every block begins with N or ':' (2С42 6.2)
  bool main_blocks = false;            // ':' + number
  bool percent_ignored = false;        // a line of '%' means nothing (Mach3)
  bool percent_number = false;         // the program's number may follow '%'
  std::uint8_t percent_digits = 5;
  bool program_start_required = false;  // the main program begins with '%'
  bool skip_levels = false;             // '/n' as well as '/'
  bool semicolon_comments = false;      // ';' to the end of the line
  bool slash_comments = false;          // '//' to the end of the line
  std::string comment_forbidden;        // characters that must not stand in ( )
  bool expressions = false;             // #n, [expr], #n=expr (Mach3)
  bool lower_case = true;               // small letters mean the same
  char parameter_address = 0;           // 'R' where R0..R9 are formal parameters (2С42 6.3.7)
  char label_address = 0;               // 'O' where Onnnn begins a subprogram (Mach3)
  char section_address = 0;             // 'L' where `L` alone begins a section of subprograms (2С42 6.3.5)
  bool zero_between_slashes = false;    // G92 /2/: the number is a word of address A (2С42, last section)
  std::uint32_t block_length = 0;       // most characters in a block, 0 = free
  std::uint32_t variables = 0;          // highest #n
  bool macro = false;                   // statements of macros: IF, WHILE, DO, GOTO, DPRNT, symbols #_NAME[n] (nct 23)
  bool operator_i = false;              // XI-40: that word alone is incremental (nct 5.1)
  bool comments_span_lines = false;     // ( ) may hold ends of lines (nct 14.3)
  bool comma_words = false;             // ,C ,R ,A (nct 17)
  bool file_names = false;              // < > hold the name of a file (nct 14.4.2)

  const WordFormat& word(char letter) const { return words[static_cast<std::size_t>(letter - 'A')]; }
  WordFormat& word(char letter) { return words[static_cast<std::size_t>(letter - 'A')]; }
};

/// Limits that hold for every control, so that no input can take memory or time without end.
namespace limits {
inline constexpr std::uint32_t line_bytes = 64 * 1024;  // a longer line is an alarm and is passed over
inline constexpr std::uint32_t block_words = 64;
inline constexpr std::uint32_t expression_depth = 64;    // nested brackets
inline constexpr std::uint32_t expression_steps = 1024;  // instructions of all expressions of a block
inline constexpr std::uint32_t block_assignments = 32;   // #n=… in one block
}  // namespace limits

}  // namespace kadr
