#pragma once
// NamedBlock: one block of a control whose blocks are statements with names, types and expressions (spec/sinumerik 2, 3, 7). The reader
// leaves the meaning of a name open: only when the block is executed is it known whether X is an axis or a variable of the program.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/span.h"

namespace kadr {

/// The operators of an expression, in the order of their binding: the first one binds strongest (spec/sinumerik 7.1).
enum class NamedOp : std::uint8_t {
  negate,
  logic_not,
  bit_not,
  multiply,
  divide,
  whole_divide,  // DIV
  modulo,        // MOD
  add,
  subtract,
  bit_and,  // B_AND
  bit_xor,
  bit_or,
  logic_and,
  logic_xor,
  logic_or,
  join,  // << joins texts
  equal,
  not_equal,
  greater,
  less,
  greater_equal,
  less_equal,
  chain  // ':' chains frames
};
std::string_view written(NamedOp op);

/// One step of an expression for a stack machine.
struct NamedStep {
  enum class Kind : std::uint8_t {
    real,       // pushes `number`
    integer,    // pushes `number`
    boolean,    // pushes `number`
    text,       // pushes the text `name`
    name,       // pushes the value of the variable `name`, of its element if `operands` is not 0; or the axis or component with this name
    parameter,  // pushes R[n]; the index is on the stack, unless `operands` is 0 and `number` is the index
    call,       // calls the function `name` with `operands` operands
    apply,      // applies `op`
    omitted     // an argument that is left out
  };
  Kind kind = Kind::real;
  NamedOp op = NamedOp::add;
  std::uint16_t operands = 0;
  double number = 0;
  std::string name;  // in upper case, except texts
  Span where;
};

/// A range of steps in NamedBlock::code that computes one expression; empty if there is no expression.
struct NamedExpression {
  std::uint32_t begin = 0, end = 0;
  explicit operator bool() const { return end > begin; }
};

/// The form in which the value of a word is written: X=AC(10).
enum class WordForm : std::uint8_t { plain, absolute, incremental, direct, positive, negative, quick };

/// An item of a block, in the order of the text.
struct NamedItem {
  enum class Kind : std::uint8_t {
    word,      // X10, G1, X=R1, CR=5, R1=10, X1=5, POS[X]=5, $P_UIFR[1,X,TR]=0: `name`, and after it a number or =
    name,      // STOPRE, TRANS, CYCLE81(…), M30 has the kind `word`
    jump,      // GOTOF, GOTOB, GOTO, GOTOC, GOTOS: `name`, with the target in `value` or in `text`
    condition  // IF, WHILE, UNTIL, CASE: `name`, with the expression in `value`
  };
  Kind kind = Kind::name;
  WordForm form = WordForm::plain;
  bool has_equals = false;                 // word: the value follows =
  bool has_arguments = false;              // name: parentheses follow, even if they are empty
  std::int32_t extension = -1;             // word: number between the letter and =, as in X1=5; -1: none
  std::vector<NamedExpression> arguments;  // name: arguments; word: indices in brackets; jump of CASE: the constants
  NamedExpression value;                   // word, condition; jump whose target is a text
  double number = 0;                       // word: value if it is written as a number directly after the letter
  std::string name;                        // in upper case
  std::string text;                        // jump: label or block number as written, in upper case
  Span where;
};

/// A variable of DEF, or a parameter of PROC.
struct NamedDefinition {
  std::string name;
  std::vector<NamedExpression> sizes;    // array
  std::vector<NamedExpression> initial;  // values after =; of REP(v, n) only v
  NamedExpression repeated;              // n of REP(v, n): number of elements that get the value; empty: all of them
  bool repeats = false;                  // REP(v) or REP(v, n)
  bool by_reference = false;
  Span where;
};

/// What a statement that stands alone in its block is.
enum class NamedKind : std::uint8_t { items, definition, procedure, external, macro, passed_over };

struct NamedBlock {
  NamedKind kind = NamedKind::items;
  std::vector<NamedItem> items;
  std::string name;                          // PROC, EXTERN: name of the program; DEFINE: name of the macro
  std::string text;                          // DEFINE: the text that replaces the name
  bool global = false;                       // DEF NCK, DEF CHAN: global data, which only definition files may have
  std::vector<std::string> types;            // DEF: one type; PROC, EXTERN: the type of each parameter
  std::vector<NamedDefinition> definitions;  // DEF, PROC
  std::vector<std::string> attributes;       // PROC: SAVE …
  std::vector<NamedStep> code;
};

}  // namespace kadr
