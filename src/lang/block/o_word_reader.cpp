// Reads O lines of RS274/NGC. Described in o_word_reader.h. Used by lang/block/lexer; tested by tests/lang/o_word_test.cpp.

#include "lang/block/o_word_reader.h"

#include "base/ascii.h"
#include "lang/block/word_reader.h"

namespace kadr {
namespace {

struct OWordRow {
  std::string_view text;
  OWord word;
};
/// The commands of O lines. If one command is the beginning of another, the longer one comes first.
constexpr OWordRow o_words[] = {
    {"sub", OWord::sub},
    {"endsub", OWord::endsub},
    {"call", OWord::call},
    {"return", OWord::return_},
    {"do", OWord::do_},
    {"while", OWord::while_},
    {"repeat", OWord::repeat},
    {"if", OWord::if_},
    {"elseif", OWord::elseif},
    {"else", OWord::else_},
    {"endif", OWord::endif},
    {"break", OWord::break_},
    {"continue", OWord::continue_},
    {"endwhile", OWord::endwhile},
    {"endrepeat", OWord::endrepeat},
};

char small(char c) { return is_capital(c) ? static_cast<char>(c | 0x20) : c; }

}  // namespace

std::string_view name_of(OWord word) {
  for (const OWordRow& row : o_words)
    if (row.word == word) return row.text;
  return {};
}

Status OWordReader::read() {
  const std::size_t begin = cursor_.at++;
  block_.statement.kind = StatementKind::o_word;
  KADR_TRY(label());
  block_.statement.label_where = span(begin);
  KADR_TRY(command());
  block_.statement.where = span(begin);
  return ended();
}

/// Reads the label of the line: a number, an expression, or a name between < and >.
Status OWordReader::label() {
  Statement& s = block_.statement;
  cursor_.skip_blanks();
  if (cursor_.peek() != '<') {
    if (is_digit(cursor_.peek())) return number();
    const auto value = compile_value(cursor_, grammar_, block_);
    if (!value) return fail(value.error());
    s.value = *value;
    return {};
  }
  const std::size_t open = cursor_.at;
  const std::size_t close = cursor_.text.find('>', open);
  if (close == std::string_view::npos) {
    cursor_.at = cursor_.text.size();
    return fail(alarm(AlarmId::variable_name_open, span(open)));
  }
  cursor_.at = close + 1;
  s.text = {static_cast<std::uint32_t>(open + 1), static_cast<std::uint32_t>(close)};
  return {};
}

/// Reads the number of the label. Blanks in the number are ignored: `O 1 2 sub` is O12.
Status OWordReader::number() {
  std::string digits;
  for (; cursor_.at < cursor_.text.size(); ++cursor_.at) {
    const char c = cursor_.peek();
    if (is_digit(c) || c == '.') digits += c;
    else if (!is_blank(c)) break;
  }
  Cursor alone{digits, 0};
  const auto value = compile_value(alone, grammar_, block_);
  if (!value) return fail(value.error());
  block_.statement.value = *value;
  return {};
}

Status OWordReader::command() {
  Statement& s = block_.statement;
  cursor_.skip_blanks();
  const std::size_t begin = cursor_.at;
  std::string word;
  for (; is_letter(cursor_.peek()) || is_blank(cursor_.peek()); ++cursor_.at) {
    if (cursor_.at >= cursor_.text.size()) break;
    if (is_letter(cursor_.peek())) word += small(cursor_.peek());
  }
  s.o_word = OWord::label;
  if (word.empty()) return {};
  // Blanks are ignored, so the text that is compared with the commands may also contain the next word of the line.
  for (const OWordRow& row : o_words)
    if (word == row.text) s.o_word = row.word;
  if (s.o_word == OWord::label) {
    for (const OWordRow& row : o_words)
      if (word.starts_with(row.text)) return fail(alarm(AlarmId::o_word_rest, span(begin)));
    return fail(alarm(AlarmId::o_word_unknown, span(begin)));
  }
  switch (s.o_word) {
    case OWord::if_:
    case OWord::elseif:
    case OWord::while_:
    case OWord::repeat: return bracket(name_of(s.o_word));
    case OWord::call: return arguments();
    case OWord::return_:
    case OWord::endsub: return cursor_.peek() == '[' ? bracket({}) : Status();
    default: return {};
  }
}

Status OWordReader::bracket(std::string_view after) {
  cursor_.skip_blanks();
  if (cursor_.peek() != '[') return fail(alarm(AlarmId::o_word_bracket, span(cursor_.at), after));
  const auto value = compile_value(cursor_, grammar_, block_);
  if (!value) return fail(value.error());
  block_.statement.conditions[0] = *value;
  block_.statement.condition_count = 1;
  return {};
}

Status OWordReader::arguments() {
  for (cursor_.skip_blanks(); cursor_.peek() == '[' || cursor_.peek() == '('; cursor_.skip_blanks()) {
    const std::size_t begin = cursor_.at;
    if (cursor_.peek() == '(') {  // a comment is allowed between two arguments, and skipped
      const std::size_t close = cursor_.text.find(')', begin);
      if (close == std::string_view::npos) return {};  // an unclosed comment is reported later, for the whole line
      cursor_.at = close + 1;
      continue;
    }
    const auto value = compile_value(cursor_, grammar_, block_);
    if (!value) return fail(value.error());
    if (block_.arguments.size() == limits::call_arguments) return fail(alarm(AlarmId::o_word_arguments, span(begin)));
    block_.arguments.push_back(*value);
  }
  return {};
}

Status OWordReader::ended() {
  cursor_.skip_blanks();
  const char c = cursor_.peek();
  if (cursor_.at >= cursor_.text.size() || c == '(' || c == ';') return {};
  return fail(alarm(AlarmId::o_word_rest, {static_cast<std::uint32_t>(cursor_.at), static_cast<std::uint32_t>(cursor_.at + 1)}));
}

}  // namespace kadr
