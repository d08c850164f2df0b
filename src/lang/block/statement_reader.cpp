// Reads statements of custom macros: IF, WHILE, DO, END, GOTO, #n=…, output (spec/nct/23 23.2, 23.5). Used by lang/block/lexer.

#include "lang/block/statement_reader.h"

#include <algorithm>
#include <cmath>

#include "base/ascii.h"
#include "lang/block/odd_characters.h"
#include "lang/block/word_reader.h"
#include "lang/text/encoding.h"

namespace kadr {
namespace {

struct KeywordRow {
  std::string_view text;
  Keyword keyword;
};
constexpr KeywordRow keywords[] = {
    {"IF", Keyword::if_},           {"WHILE", Keyword::while_},       {"DO", Keyword::do_},
    {"END", Keyword::end_},         {"GOTO", Keyword::goto_},         {"THEN", Keyword::then_},
    {"POPEN", Keyword::open_port},  {"PCLOS", Keyword::close_port},   {"FOPEN", Keyword::open_file},
    {"FCLOS", Keyword::close_file}, {"BPRNT", Keyword::print_binary}, {"DPRNT", Keyword::print_decimal},
    {"PRM", Keyword::prm},          {"SETVN", Keyword::names},
};

/// Returns true if #number is a variable that shows a message when a program assigns a value to it (nct 23.1.8).
bool is_message(double number) { return number == 3000 || number == 3006 || number == 3106 || number == 3107; }

}  // namespace

Keyword StatementReader::keyword_here() const {
  std::size_t length = 0;
  return keyword_here(length);
}

Keyword StatementReader::keyword_here(std::size_t& length) const {
  const std::string_view rest = cursor_.text.substr(std::min(cursor_.at, cursor_.text.size()));
  constexpr std::size_t least_of_short = 2;
  for (const KeywordRow& row : keywords) {
    length = 0;
    while (length < row.text.size() && length < rest.size() && to_upper(rest[length]) == row.text[length]) ++length;
    if (length == row.text.size() || (grammar_.short_words && length >= least_of_short)) return row.keyword;
  }
  return Keyword::none;
}

Status StatementReader::read(Keyword keyword) {
  const std::size_t begin = cursor_.at;
  if (block_.word_count != 0 || block_.statement.words_follow ||
      (block_.statement.kind != StatementKind::none && block_.statement.condition_count == 0))
    return fail(alarm(AlarmId::statement_not_alone, span(begin, begin + 2)));
  std::size_t length = 0;
  (void)keyword_here(length);
  cursor_.at += length;
  block_.statement.where.begin = static_cast<std::uint32_t>(begin);
  switch (keyword) {
    case Keyword::if_: return branch();
    case Keyword::while_: return loop_while(begin);
    case Keyword::do_: return loop_do(begin);
    case Keyword::end_: return loop_end(begin);
    case Keyword::goto_: return jump(begin);
    case Keyword::print_binary:
    case Keyword::print_decimal: return print(keyword, begin);
    // A machine parameter (PRM) is allowed only on the right of = (nct 24.2).
    case Keyword::prm: return fail(alarm(AlarmId::illegal_address, span(begin, cursor_.at), "PRM"));
    case Keyword::names: return variable_names(begin);
    case Keyword::then_: return fail(alarm(AlarmId::expression_syntax, span(begin, cursor_.at), "THEN"));
    default: return device(keyword, begin);
  }
}

/// Reads IF[…] GOTOn, and IF[…] with or without THEN and a statement or words (nct 23.2.9, 23.2.10). The words themselves are read by the
/// lexer.
Status StatementReader::branch() {
  block_.statement.with_if = true;
  KADR_TRY(condition());
  cursor_.skip_blanks();
  std::size_t length = 0;
  if (keyword_here(length) == Keyword::then_) cursor_.at += length;
  cursor_.skip_blanks();
  if (cursor_.peek() == '#') {
    const std::size_t at = cursor_.at++;
    return assignment(at);
  }
  const Keyword next = keyword_here();
  if (next == Keyword::then_) return syntax(cursor_.at);
  if (next != Keyword::none) return read(next);
  const char c = cursor_.peek();
  const bool ends = c == '\0' || c == '(';
  if (ends && grammar_.condition_alone) {  // spec/haas 2.3: a condition may be alone in its block; then it has no effect
    block_.statement.kind = StatementKind::words;
    return {};
  }
  if (!is_letter(c) && c != ',' && !is_high(c)) return syntax(cursor_.at);
  if (!grammar_.condition_words) return fail(alarm(AlarmId::statement_not_alone, span(cursor_.at, cursor_.at + 1)));
  // nct 23.2.10 does not state what may follow the condition; words of a block are accepted, as on a Fanuc.
  block_.statement.kind = StatementKind::words;
  return {};
}

Status StatementReader::condition() {
  Statement& s = block_.statement;
  if (s.condition_count == limits::conditions)
    return fail(alarm(AlarmId::nesting_too_deep, span(cursor_.at, cursor_.at + 1), double{limits::conditions}));
  const auto compiled = compile_condition(cursor_, grammar_, block_);
  if (!compiled) return fail(compiled.error());
  s.conditions[s.condition_count++] = *compiled;
  return {};
}

Status StatementReader::loop_while(std::size_t begin) {
  // In IF[…] WHILE the loop is an error, because a loop cannot follow a condition of IF.
  if (block_.statement.condition_count != 0) return syntax(begin);
  KADR_TRY(condition());
  cursor_.skip_blanks();
  if (keyword_here() != Keyword::do_) return fail(alarm(AlarmId::while_without_do, span(begin, cursor_.at)));
  const std::size_t at = cursor_.at;
  cursor_.at += 2;
  return loop_do(at);
}

Status StatementReader::loop_do(std::size_t begin) {
  if (block_.statement.with_if) return syntax(begin);
  KADR_TRY(loop_number(begin));
  block_.statement.kind = StatementKind::loop;
  return ended(begin);
}

Status StatementReader::loop_end(std::size_t begin) {
  if (block_.statement.with_if) return syntax(begin);
  KADR_TRY(loop_number(begin));
  block_.statement.kind = StatementKind::loop_end;
  return ended(begin);
}

/// Reads the number of a loop: 1, 2 or 3 (nct 23.2.11).
Status StatementReader::loop_number(std::size_t begin) {
  cursor_.skip_blanks();
  Number read;
  if (!is_digit(cursor_.peek())) return syntax(cursor_.at);
  if (!read_number(cursor_, read) || read.has_point) return syntax(begin);
  if (!(read.value >= 1 && read.value <= 3)) return fail(alarm(AlarmId::do_number, span(begin, cursor_.at), read.value));
  block_.statement.loop = static_cast<std::uint8_t>(read.value);
  return {};
}

Status StatementReader::jump(std::size_t begin) {
  cursor_.skip_blanks();
  const auto number = compile_macro_value(cursor_, grammar_, block_, MacroValue::operand);
  if (!number) return fail(number.error());
  block_.statement.kind = StatementKind::go_to;
  block_.statement.value = *number;
  return ended(begin);
}

Status StatementReader::bracket() {
  if (grammar_.given_names != nullptr && given_name_follows(cursor_)) return assignment(cursor_.at);
  return grammar_.condition_alone ? read(Keyword::if_) : Status(fail(unexpected_at(cursor_.text, cursor_.at)));
}

Status StatementReader::assignment(std::size_t begin) {
  Statement& s = block_.statement;
  if (block_.word_count != 0 || s.words_follow || (s.kind != StatementKind::none && s.condition_count == 0))
    return fail(alarm(AlarmId::statement_not_alone, span(begin, begin + 1)));
  s.where.begin = static_cast<std::uint32_t>(begin);
  const auto target = compile_macro_target(cursor_, grammar_, block_);
  if (!target) return fail(target.error());
  s.target = *target;
  cursor_.skip_blanks();
  if (cursor_.peek() != '=') return syntax(cursor_.at);
  ++cursor_.at;
  cursor_.skip_blanks();
  const bool constant = s.target.end - s.target.begin == 1;
  const bool message = constant && is_message(block_.code[s.target.begin].number);
  s.kind = message ? StatementKind::message : StatementKind::assign;
  if (message && (cursor_.peek() == '(' || cursor_.at >= cursor_.text.size())) return ended(begin);
  const auto value = compile_macro_value(cursor_, grammar_, block_, MacroValue::assigned);
  if (!value) return fail(value.error());
  s.value = *value;
  if (grammar_.assignment_and_words && s.with_if && !message && words_here()) {
    s.words_follow = true;
    s.where = span(s.where.begin, cursor_.at);
    return {};
  }
  Cursor ahead = cursor_;
  ahead.skip_blanks();
  if (grammar_.assignment_and_words && ahead.peek() == '#')  // spec/haas 10: a second assignment raises alarm 501
    return fail(alarm(AlarmId::statement_not_alone, span(ahead.at, ahead.at + 1)));
  return ended(begin);
}

bool StatementReader::words_here() {
  cursor_.skip_blanks();
  return is_letter(cursor_.peek());
}

/// Reads SETVN n[NAME,NAME]: gives names to #n, #n+1 … (spec/fanuc 5.1).
Status StatementReader::variable_names(std::size_t begin) {
  cursor_.skip_blanks();
  Number first;
  if (!is_digit(cursor_.peek()) || !read_number(cursor_, first) || first.has_point) return syntax(cursor_.at);
  cursor_.skip_blanks();
  const std::size_t close = cursor_.text.find(']', cursor_.at);
  if (cursor_.peek() != '[' || close == std::string_view::npos) return syntax(cursor_.at);
  block_.statement.text = span(cursor_.at + 1, close);
  block_.statement.value.begin = static_cast<std::uint16_t>(block_.code.size());
  block_.code.push_back({Op::number, first.value, span(begin, cursor_.at)});
  block_.statement.value.end = static_cast<std::uint16_t>(block_.code.size());
  cursor_.at = close + 1;
  block_.statement.kind = StatementKind::names;
  return ended(begin);
}

/// Reads POPENn, PCLOSn, FOPENn Pp or <name>, FCLOS (nct 23.2.13).
Status StatementReader::device(Keyword keyword, std::size_t begin) {
  Statement& s = block_.statement;
  s.kind = keyword == Keyword::open_port    ? StatementKind::open_port
           : keyword == Keyword::close_port ? StatementKind::close_port
           : keyword == Keyword::open_file  ? StatementKind::open_file
                                            : StatementKind::close_file;
  if (keyword == Keyword::close_file) return ended(begin);
  cursor_.skip_blanks();
  const bool bare = cursor_.peek() == '\0' || cursor_.peek() == '(' || cursor_.peek() == ';';
  if (bare && grammar_.ports_without_number && keyword != Keyword::open_file) return ended(begin);
  const auto number = compile_macro_value(cursor_, grammar_, block_, MacroValue::operand);
  if (!number) return fail(number.error());
  s.value = *number;
  if (keyword == Keyword::open_file) KADR_TRY(file_of_program());
  return ended(begin);
}

Status StatementReader::file_of_program() {
  cursor_.skip_blanks();
  const std::size_t begin = cursor_.at;
  if (cursor_.peek() == '<') {
    const std::size_t close = cursor_.text.find('>', begin);
    if (close == std::string_view::npos)
      return fail(alarm(AlarmId::file_name, span(begin, cursor_.text.size()), cursor_.text.substr(begin)));
    block_.file_name = span(begin + 1, close);
    cursor_.at = close + 1;
    return {};
  }
  if (to_upper(cursor_.peek()) != 'P')
    return fail(alarm(AlarmId::program_name_missing, span(block_.statement.where.begin, begin), "FOPEN"));
  ++cursor_.at;
  cursor_.skip_blanks();
  const auto program = compile_macro_value(cursor_, grammar_, block_, MacroValue::operand);
  if (!program) return fail(program.error());
  block_.statement.program = *program;
  return {};
}

/// Reads DPRNT[…]. Only the text is stored here; control/macro_b interprets it.
Status StatementReader::print(Keyword keyword, std::size_t begin) {
  cursor_.skip_blanks();
  if (cursor_.peek() != '[') return syntax(cursor_.at);
  const std::size_t open = cursor_.at;
  int depth = 0;
  do {
    const char c = cursor_.peek();
    if (cursor_.at >= cursor_.text.size()) return fail(alarm(AlarmId::bracket_not_closed, span(open, open + 1)));
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    ++cursor_.at;
  } while (depth > 0);
  block_.statement.kind = keyword == Keyword::print_binary ? StatementKind::print_binary : StatementKind::print_decimal;
  block_.statement.text = span(open, cursor_.at);
  return ended(begin);
}

/// Checks that only a comment follows the statement. INFERRED: a block has only one statement (nct 23.2.1).
Status StatementReader::ended(std::size_t begin) {
  block_.statement.where = span(block_.statement.where.begin, cursor_.at);
  (void)begin;
  cursor_.skip_blanks();
  if (cursor_.at >= cursor_.text.size() || cursor_.peek() == '(' || cursor_.peek() == ';') return {};
  return syntax(cursor_.at);
}

tl::unexpected<Alarm> StatementReader::syntax(std::size_t at) const {
  std::size_t bytes = 1;
  if (at < cursor_.text.size() && (static_cast<unsigned char>(cursor_.text[at]) & 0x80) != 0) {
    bytes = std::max<std::size_t>(1, first_character(cursor_.text.substr(at)).size);
    return fail(alarm(AlarmId::unexpected_character, span(at, at + bytes), cursor_.text.substr(at, bytes)));
  }
  const std::string_view shown = at < cursor_.text.size() ? cursor_.text.substr(at, bytes) : std::string_view("…");
  return fail(alarm(AlarmId::expression_syntax, span(at, at + bytes), shown));
}

Span StatementReader::span(std::size_t begin, std::size_t end) const {
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::min(end, cursor_.text.size()))};
}

}  // namespace kadr
