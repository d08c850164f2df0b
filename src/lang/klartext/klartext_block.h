#pragma once
// KlartextBlock: one conversational block, read once into words with numbers and compiled expressions (spec/heidenhain 1 to 12). The same
// object is executed as often as the program comes to the block.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/span.h"

namespace kadr {

/// Operations of an expression (spec/heidenhain 10.2, 10.4). Operands are on a stack.
enum class KlartextOp : std::uint8_t {
  number,     // pushes `number`
  parameter,  // pushes the Q parameter `family`, `index`
  negate,
  add,
  subtract,
  multiply,
  divide,
  remainder,
  power,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  square,
  square_root,
  natural_log,
  log,
  exp,
  negative,  // NEG
  integer,
  absolute,
  fraction,
  sign,
  length,        // FN 8: LEN
  angle,         // FN 13: ANG
  text_length,   // STRLEN of the text parameter `index`
  text_number,   // TONUMB
  text_find,     // INSTR of `index` and `second`; the place of the beginning is on the stack
  text_compare,  // STRCOMP
  undefined      // 1 if the parameter has no value
};

enum class ParameterFamily : std::uint8_t { q, ql, qr, qs };

struct KlartextStep {
  KlartextOp op = KlartextOp::number;
  ParameterFamily family = ParameterFamily::q;
  std::uint16_t index = 0, second = 0;
  double number = 0;
  Span where;
};

/// A range of steps in KlartextBlock::code; empty if there is no expression.
struct KlartextExpression {
  std::uint16_t begin = 0, end = 0;
  explicit operator bool() const { return end > begin; }
};

/// The name of a word as a number, so that names are compared in one step. At most eight letters.
constexpr std::uint64_t word_name(std::string_view text) {
  std::uint64_t name = 0;
  for (const char c : text.substr(0, 8)) name = name << 8U | static_cast<unsigned char>(c);
  return name;
}

/// A word: a name and a value. `+` and `-` behind DR, R, SEQ … without a number have the values 1 and -1, and `bare` is set.
struct KlartextWord {
  std::uint64_t name = 0;
  bool incremental = false;
  bool bare = false;
  double number = 0;
  KlartextExpression value;  // empty: `number` is the value
  std::string text;          // "…" behind the name
  Span where;
};

enum class KlartextKind : std::uint8_t {
  words,  // a block of M functions alone
  begin_program,
  end_program,
  blank_form,
  line,
  polar_line,
  normal_line,
  centre,
  circle,
  polar_circle,
  radius_circle,
  tangent_circle,
  polar_tangent_circle,
  chamfer,
  rounding,
  approach,
  departure,
  stop,
  label,
  call_label,
  call_program,
  select_program,
  call_selected,
  tool_call,
  tool_definition,
  cycle_definition,
  cycle_call,
  assignment,
  jump,
  circle_data,  // FN 23, FN 24
  error,        // FN 14
  print,        // FN 15, FN 16
  read_system,  // FN 18
  text_assignment,
  plane,
  tip_control,  // FUNCTION TCPM, FUNCTION RESET TCPM
  datum,        // TRANS DATUM
  pattern,
  free_contour,    // FL, FC …
  probe,           // TCH PROBE
  select_table,    // SEL TABLE
  select_pattern,  // SEL PATTERN
  export_locals,   // FN 37
  passed_over,     // accepted, without an effect on the run
  not_available,   // `name` says what
};

/// A piece of a text value (spec/heidenhain 10.7).
struct TextPiece {
  enum class Kind : std::uint8_t { literal, parameter, part, number };
  Kind kind = Kind::literal;
  std::string text;
  std::uint16_t index = 0;           // QS parameter
  KlartextExpression first, second;  // part: begin and length; number: value and decimals
};

/// A point or a row of PATTERN DEF: the words within its brackets.
struct PatternRow {
  std::string name;
  std::vector<KlartextWord> words;
  Span where;
};

struct KlartextBlock {
  static constexpr std::int16_t global_definition = -2;  // `part` of GLOBAL DEF

  KlartextKind kind = KlartextKind::words;
  std::string name;          // label; path of a program; name of a refused statement; form of APPR, PLANE
  std::uint16_t number = 0;  // cycle, FN
  std::int16_t part = -1;    // n of CYCL DEF 7.n; -1: all in one block
  std::vector<KlartextWord> words;
  std::vector<KlartextStep> code;
  KlartextStep target;               // assignment: the parameter
  KlartextExpression value, second;  // assignment; both sides of a comparison
  std::vector<TextPiece> pieces;
  std::vector<PatternRow> rows;
  std::string text;  // text of a line of an old cycle
  Span where;

  const KlartextWord* find(std::uint64_t name_of_word) const {
    for (const KlartextWord& word : words)
      if (word.name == name_of_word) return &word;
    return nullptr;
  }
  const KlartextWord* find(std::string_view name_of_word) const { return find(word_name(name_of_word)); }
};

}  // namespace kadr
