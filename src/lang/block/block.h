#pragma once
// Block: one parsed block of a part program, with the values and places of its words.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "base/alarm.h"
#include "base/span.h"
#include "lang/block/grammar.h"
#include "lang/expression/operation.h"

namespace kadr {

/// A step of a compiled expression: an instruction of a stack machine (lang/expression/expression).

struct Instruction {
  Op op;
  double number = 0;  // operand of the operations `number` and `scale`; for `parameter`: index of the formal parameter
  Span where;         // location in the block's text, for the alarm if the step fails
};

/// A range of the block's instructions; empty if there is no expression.
struct Expression {
  std::uint16_t begin = 0;
  std::uint16_t end = 0;
  explicit operator bool() const { return end > begin; }
};

/// A word: an address and a value. The value is in the unit in which the program writes it (mm or inch, degrees, …).
struct Word {
  double value = 0;
  double second = std::numeric_limits<double>::quiet_NaN();  // the second number of `L2 15`; NaN if there is none
  Span where;
  Expression expression;   // the expression that gives the value when the block is executed; empty: the value is known
  Expression axis;         // number of the axis in AX[n]=…
  std::int32_t code = -1;  // for G and M: ten times the number (G54.1 = 541); -1: not a code
  char address = 0;
  std::uint8_t digits = 0;   // number of digits written
  std::uint8_t counted = 0;  // number of decimals by which a number without a decimal point was scaled down
  bool has_point = false;
  bool incremental = false;  // written with the operator I: the value is an increment
  bool bare = false;         // written without a number
  char written = 0;          // letter of the address as written; `address` is 0 while the value of the word is vacant
};

/// The statements of the macro language, each alone in its block (nct 23.2, 23.5).
enum class StatementKind : std::uint8_t {
  none,
  words,  // IF[…] THEN with words of an NC block, which are executed if the conditions are true
  assign,
  message,  // #3000=n(text) and similar: the text is the first comment of the block
  go_to,
  loop,  // WHILE[…] DOm or DOm
  loop_end,
  open_port,
  close_port,
  open_file,
  close_file,
  print_binary,
  print_decimal,
  names,   // SETVN n[NAME,…]: has no effect at run time (spec/fanuc 5.1)
  o_word,  // a line of flow control or a call (spec/linuxcnc 6)
  system,  // a line of Grbl: `$H`, `$110=500`, `$J=X10 F100`; the words after `$J=` become words of the block (spec/grbl 9, 11)
};

/// The commands of an O line (spec/linuxcnc 6.1).
enum class OWord : std::uint8_t {
  label,  // O100 alone in its line
  sub,
  endsub,
  call,
  return_,
  do_,
  while_,
  endwhile,
  repeat,
  endrepeat,
  if_,
  elseif,
  else_,
  endif,
  break_,
  continue_
};
std::string_view name_of(OWord word);

struct Statement {
  StatementKind kind = StatementKind::none;
  std::uint8_t loop = 0;             // m of DOm, ENDm
  std::uint8_t condition_count = 0;  // number of conditions of IF or WHILE: all must be true
  bool with_if = false;
  bool words_follow = false;  // words of the block follow an assignment after IF (spec/haas 2.3)
  std::array<Expression, limits::conditions> conditions{};
  Expression target;   // assign: number of the variable
  Expression value;    // assign: the value; go_to: the block number; ports and files: the number n written after the keyword
  Expression program;  // number of the program in FOPENn P…
  Span where;
  Span text;  // text in the brackets of DPRNT, BPRNT; label of an O line, if it is a name (a number is in `value`); text of a system line
  OWord o_word = OWord::label;
  Span label_where;  // location of the label of an O line
};

/// An assignment: #n = expression, or R2+50.
struct Assignment {
  Expression target;  // number of the variable or parameter
  Expression value;
  Span where;
};

enum class Marker : std::uint8_t {
  none,
  program_start,  // '%'
  label,          // Onnnn alone: starts a subprogram or names the program
  section,        // `L` alone: subprograms follow (2С42 6.3.5)
};

/// The addresses of a plain block in order, and its codes: blocks with the same shape call the same functions (lang/block/plain_block).
struct BlockShape {
  std::uint64_t first = 0, second = 0;  // letters and codes, packed; the last word is in the lowest bits
  friend bool operator==(const BlockShape&, const BlockShape&) = default;
  /// Returns false if the block is not plain, has no words, or has too many words.
  explicit operator bool() const { return first != 0; }

  /// Adds a word. `code`: the code of a G or M word; else -1.
  void add(char letter, std::int32_t code) {
    constexpr unsigned letter_bits = 7, code_bits = 17;
    const unsigned bits = code >= 0 ? letter_bits + code_bits : letter_bits;
    if (second >> (64 - bits) != 0) return void(*this = {0, ~std::uint64_t{0}});  // too many words: the shape stays invalid
    const std::uint64_t item = (code >= 0 ? static_cast<std::uint64_t>(code) << letter_bits : 0) | static_cast<std::uint64_t>(letter);
    second = second << bits | first >> (64 - bits);
    first = first << bits | item;
  }
};

struct Block {
  std::string_view text;  // UTF-8 text of the line that the block is in; valid until the next block is read
  Position position;
  Span where;         // location of the whole block in `text`
  Span number_where;  // location of the word N10
  Marker marker = Marker::none;
  bool has_number = false;
  bool main_block = false;  // ':'
  std::uint8_t number_digits = 0;
  std::uint8_t skip = 0;     // block skip; 0: the block has no slash; else the number of the switch, 1..9
  std::uint32_t number = 0;  // block number, written after N or ':'
  std::uint32_t label = 0;   // number written after O or '%'
  std::uint32_t word_count = 0;
  std::uint64_t letters = 0;                     // the bit (address - 'A') is set for each address in the block
  std::array<std::uint8_t, max_addresses> at{};  // index of the first word with each address that is present
  std::array<Word, limits::block_words> words;
  BlockShape shape;
  std::vector<Instruction> code;
  std::vector<Assignment> assignments;
  std::vector<Expression> arguments;  // arguments of O100 call [1] [2] …
  std::vector<Span> comments;         // locations of the texts in comment brackets
  std::vector<Alarm> warnings;        // warnings of the block, such as look-alike letters
  Statement statement;
  Span file_name;               // location of the name between < and >
  std::optional<Alarm> broken;  // a fault after the words; faults of the words themselves are reported first (spec/grbl 1.3)
  bool evaluates = false;       // the value of at least one word is an expression
  bool codes_vary = false;      // the number of at least one code is an expression
  bool kept = false;            // the block stays at its place in memory, because a loop executes it again
  bool no_clock = false;        // a check has found that no expression of the block reads a clock
  std::uint64_t checked = 0;    // value of `letters` when the words were last checked and found correct; 0: not checked
  bool calls_macro = false;     // that check has found that the block calls a macro
  bool altered = false;         // words were removed during execution; the address of a removed word is 0

  bool has(char letter) const { return (letters >> (letter - 'A') & 1u) != 0; }
  /// Returns the first word with this address, or nullptr.
  const Word* find(char letter) const { return has(letter) ? &words[at[static_cast<std::size_t>(letter - 'A')]] : nullptr; }
  bool empty() const {
    return word_count == 0 && assignments.empty() && marker == Marker::none && statement.kind == StatementKind::none &&
           file_name.end == 0 && !broken;
  }
  std::string_view text_of(Span s) const { return text.substr(s.begin, s.end - s.begin); }

  /// Clears the block, so that the next one can be read into it. The lists keep their allocated memory.
  void clear() {
    marker = Marker::none;
    has_number = main_block = evaluates = altered = codes_vary = kept = no_clock = false;
    checked = 0;
    file_name = {};
    broken.reset();
    if (statement.kind != StatementKind::none || statement.condition_count != 0 || statement.with_if)
      statement = {};  // the kind alone does not decide: a faulty IF has conditions but no kind yet
    number_digits = skip = 0;
    number = label = word_count = 0;
    letters = 0;
    shape = {};
    code.clear();
    assignments.clear();
    arguments.clear();
    comments.clear();
    warnings.clear();
  }
};

/// Returns the bit of an address in Block::letters.
constexpr std::uint64_t letter_bit(char letter) { return std::uint64_t{1} << (letter - 'A'); }

}  // namespace kadr
