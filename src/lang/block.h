#pragma once
// One block of a part program, parsed: words with their values, and where each stands.

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "base/alarm.h"
#include "base/span.h"
#include "lang/grammar.h"

namespace kadr {

/// Step of a compiled expression: a stack machine's instruction (lang/expression).
enum class Op : std::uint8_t {
  number,
  variable,
  parameter,  // push; `variable` replaces the top by #top
  add,
  subtract,
  multiply,
  divide,
  modulo,
  power,
  negate,
  logic_and,
  logic_or,
  logic_xor,
  equal,
  not_equal,
  greater,
  greater_equal,
  less,
  less_equal,
  abs,
  acos,
  asin,
  atan,
  cos,
  exp,
  fix,
  fup,
  ln,
  round,
  sin,
  sqrt,
  tan,
  scale  // divides by `number`: raw digits to the unit of the address
};

struct Instruction {
  Op op;
  double number = 0;  // of `number`, `scale`; index of `parameter`
  Span where;         // for the alarm, if the step fails
};

/// A piece of the block's instructions; empty: no expression.
struct Expression {
  std::uint16_t begin = 0;
  std::uint16_t end = 0;
  explicit operator bool() const { return end > begin; }
};

/// Address and value. The value is in the unit of the address as written (mm or inch, degrees, …).
struct Word {
  double value = 0;
  double second = std::numeric_limits<double>::quiet_NaN();  // of `L2 15`
  Span where;
  Expression expression;   // the value is known only when the block is carried out
  std::int32_t code = -1;  // of G and M: ten times the number (G54.1 = 541); -1: not a code
  char address = 0;
  std::uint8_t digits = 0;  // digits written
  bool has_point = false;
};

/// #n = expression, or R2+50.
struct Assignment {
  Expression target;  // number of the variable
  Expression value;
  Span where;
};

enum class Marker : std::uint8_t {
  none,
  program_start,  // '%'
  label,          // Onnnn alone begins a subprogram or names the program
  section,        // `L` alone: subprograms follow (2С42 6.3.5)
};

struct Block {
  std::string_view text;  // UTF-8 text of its line; valid until the next block is read
  Position position;
  Span where;         // of the whole block in `text`
  Span number_where;  // N10
  Marker marker = Marker::none;
  bool has_number = false;
  bool main_block = false;  // ':'
  std::uint8_t number_digits = 0;
  std::uint8_t skip = 0;     // 0: not to be skipped; else the switch, 1..9
  std::uint32_t number = 0;  // of N, ':'
  std::uint32_t label = 0;   // of O, of '%'
  std::uint32_t word_count = 0;
  std::uint32_t letters = 0;          // bit (letter - 'A') for each address present
  std::array<std::uint8_t, 26> at{};  // first word of each present address
  std::array<Word, limits::block_words> words;
  std::vector<Instruction> code;
  std::vector<Assignment> assignments;
  std::vector<Span> comments;   // the text between the brackets
  std::vector<Alarm> warnings;  // look-alike letters

  bool has(char letter) const { return letters >> (letter - 'A') & 1u; }
  /// The first word of that address, or nullptr.
  const Word* find(char letter) const { return has(letter) ? &words[at[static_cast<std::size_t>(letter - 'A')]] : nullptr; }
  bool empty() const { return word_count == 0 && assignments.empty() && marker == Marker::none; }
  std::string_view text_of(Span s) const { return text.substr(s.begin, s.end - s.begin); }

  /// Ready for the next block; keeps the memory of the lists.
  void clear() {
    marker = Marker::none;
    has_number = main_block = false;
    number_digits = skip = 0;
    number = label = word_count = letters = 0;
    code.clear();
    assignments.clear();
    comments.clear();
    warnings.clear();
  }
};

/// Bit of a letter in Block::letters.
constexpr std::uint32_t letter_bit(char letter) { return 1u << (letter - 'A'); }

}  // namespace kadr
