#pragma once
// Block: one parsed block of a part program, with the values and locations of its words.

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

/// A step of a compiled expression, which is an instruction for a stack machine (lang/expression/expression).

struct Instruction {
  Op op;
  double number = 0;  // operand of the operations `number` and `scale`; for `parameter`: index of the formal parameter
  Span where;         // location in the block's text, for the alarm if the step fails
};

/// The range of instructions in a block that computes one expression; the range is empty if there is no expression.
struct Expression {
  std::uint16_t begin = 0;
  std::uint16_t end = 0;
  explicit operator bool() const { return end > begin; }
};

/// A word: an address and a value. The value is in the unit of the program (mm or inch, degrees, …).
struct Word {
  double value = 0;
  double second = std::numeric_limits<double>::quiet_NaN();  // second number of a word such as `L2 15`; NaN if the word has only one number
  Span where;
  Expression expression;   // expression that gives the value when the block is executed; empty: the value is known
  Expression axis;         // number of the axis for a word of the form AX[n]=…
  std::int32_t code = -1;  // ten times the number of a G or M code (G54.1 is 541); -1: the word is not a code
  char address = 0;
  std::uint8_t digits = 0;   // number of digits with which the value is written
  std::uint8_t counted = 0;  // number of decimals by which a value written without a decimal point was divided
  bool has_point = false;
  bool incremental = false;  // the word is written with the operator I, so the value is an increment
  bool bare = false;         // the word is written without a number
  char written = 0;          // letter of the address as written; kept while `address` is 0 because the value of the word is vacant
};

/// The statements of the macro language. Each statement is alone in its block (nct 23.2, 23.5).
enum class StatementKind : std::uint8_t {
  none,
  words,  // IF[…] THEN with words of an NC block; the words are executed if the conditions are true
  assign,
  message,  // an assignment that shows a message, such as #3000=n(text); the text is the first comment of the block
  go_to,
  loop,  // WHILE[…] DOm or DOm
  loop_end,
  open_port,
  close_port,
  open_file,
  close_file,
  print_binary,
  print_decimal,
  names,     // SETVN n[NAME,…] gives names to variables; it has no effect during execution (spec/fanuc 5.1)
  o_word,    // a line of flow control or a call (spec/linuxcnc 6)
  system,    // a line of Grbl: `$H`, `$110=500`, `$J=X10 F100`; the words after `$J=` become words of the block (spec/grbl 9, 11)
  named,     // a block with names; `text` is the block without its number and label, which lang/named reads when it is executed
             // (spec/sinumerik)
  klartext,  // a conversational block; `text` is the block without its number, which lang/klartext reads when it is executed
             // (spec/heidenhain)
};

/// The commands of an O line (spec/linuxcnc 6.1).
enum class OWord : std::uint8_t {
  label,  // O100 without a command in its line
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
  std::uint8_t loop = 0;             // number m of a loop, in DOm and ENDm
  std::uint8_t condition_count = 0;  // number of conditions of IF or WHILE, all of which must be true
  bool with_if = false;
  bool words_follow = false;  // true: words of the block follow the assignment in IF[…] THEN #n=… (spec/haas 2.3)
  std::array<Expression, limits::conditions> conditions{};
  Expression target;   // number of the variable that is assigned (`assign`)
  Expression value;    // `assign`: the value; `go_to`: the block number; ports and files: the number n after the keyword
  Expression program;  // number of the program in FOPENn P…
  Span where;
  Span text;  // location of the text of DPRNT or BPRNT, of the name of an O line (a number is in `value`), or of a system line
  OWord o_word = OWord::label;
  Span label_where;  // location of the label of an O line
};

/// An assignment: #n = expression, or R2+50, which sets R2 to 50.
struct Assignment {
  Expression target;  // number of the variable or parameter to which the value is assigned
  Expression value;
  Span where;
};

enum class Marker : std::uint8_t {
  none,
  program_start,  // '%'
  label,          // Onnnn alone in its block: starts a subprogram or names the program
  section,        // `L` alone in its block: subprograms follow (2С42 6.3.5)
};

/// The addresses of a plain block in their order, and its codes. Blocks with the same shape call the same functions
/// (lang/block/plain_block).
struct BlockShape {
  std::uint64_t first = 0, second = 0;  // letters and codes in packed form; the last word is in the lowest bits
  friend bool operator==(const BlockShape&, const BlockShape&) = default;
  /// Returns false if the block is not plain, has no words, or has too many words.
  explicit operator bool() const { return first != 0; }

  /// Adds a word to the shape. `code`: the code of a G or M word; -1 for other words.
  void add(char letter, std::int32_t code) {
    constexpr unsigned letter_bits = 7, code_bits = 17;
    const unsigned bits = code >= 0 ? letter_bits + code_bits : letter_bits;
    // A block with too many words makes the shape invalid.
    if (second >> (64 - bits) != 0) return void(*this = {0, ~std::uint64_t{0}});
    const std::uint64_t item = (code >= 0 ? static_cast<std::uint64_t>(code) << letter_bits : 0) | static_cast<std::uint64_t>(letter);
    second = second << bits | first >> (64 - bits);
    first = first << bits | item;
  }
};

struct Block {
  std::string_view text;  // UTF-8 text of the line with the block; valid until the next block is read
  Position position;
  Span where;         // location of the whole block in `text`
  Span number_where;  // location of the word with the block number, such as N10
  Marker marker = Marker::none;
  bool has_number = false;
  bool main_block = false;  // ':'
  std::uint8_t number_digits = 0;
  std::uint8_t skip = 0;     // number of the skip switch, 1..9; 0: the block has no slash
  std::uint32_t number = 0;  // block number, written after N or `:`
  std::uint32_t label = 0;   // number written after O or '%': the label of the block
  std::uint32_t word_count = 0;
  std::uint64_t letters = 0;                     // addresses of the block: the bit (address - 'A') is set for each of them
  std::array<std::uint8_t, max_addresses> at{};  // by address: index of the first word with the address; valid if the block has the address
  std::array<Word, limits::block_words> words;
  BlockShape shape;
  std::vector<Instruction> code;
  std::vector<Assignment> assignments;
  std::vector<Expression> arguments;  // arguments of `O100 call [1] [2] …`
  std::vector<Span> comments;         // locations of the comments, without their brackets
  std::vector<Alarm> warnings;        // warnings about the block, for example about look-alike letters
  Statement statement;
  Span file_name;  // location of a file name between < and >
  // a fault that was found after some words of the block; the control reports faults of these words first (spec/grbl 1.3)
  std::optional<Alarm> broken;
  bool evaluates = false;   // the value of at least one word is an expression
  bool codes_vary = false;  // the number of at least one code is an expression
  bool repeated = false;    // the block remains in memory at this address, because a loop executes it again
  bool no_clock = false;    // true: a check has found that no expression of the block reads a clock
  // set of addresses (`letters`) with which the last check found the words correct; 0: the words have not been checked
  std::uint64_t checked = 0;
  bool calls_macro = false;  // true: the last check of the words has found that the block calls a macro
  bool altered = false;      // words were removed from the block during execution; a removed word has the address 0

  bool has(char letter) const { return (letters >> (letter - 'A') & 1u) != 0; }
  /// Returns the first word with this address; nullptr if the block has no such word.
  const Word* find(char letter) const { return has(letter) ? &words[at[static_cast<std::size_t>(letter - 'A')]] : nullptr; }
  bool empty() const {
    return word_count == 0 && assignments.empty() && marker == Marker::none && statement.kind == StatementKind::none &&
           file_name.end == 0 && !broken;
  }
  std::string_view text_of(Span s) const { return text.substr(s.begin, s.end - s.begin); }

  /// Clears the block, so that the next block can be read into it. The lists keep their allocated memory.
  void clear() {
    marker = Marker::none;
    has_number = main_block = evaluates = altered = codes_vary = repeated = no_clock = false;
    checked = 0;
    file_name = {};
    broken.reset();
    if (statement.kind != StatementKind::none || statement.condition_count != 0 || statement.with_if)
      statement = {};  // the conditions are examined in addition to the kind, because a faulty IF has conditions but no kind yet
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

/// Returns the bit of an address in the set Block::letters.
constexpr std::uint64_t letter_bit(char letter) { return std::uint64_t{1} << (letter - 'A'); }

}  // namespace kadr
