// Reads the beginning of a line of a control whose blocks have names. Used by lang/block/lexer; tested by tests/lang/named_test.cpp.

#include "lang/named/named_reader.h"

#include <algorithm>

#include "base/ascii.h"
#include "lang/named/named_expression.h"
#include "lang/named/named_parser.h"

namespace kadr {
namespace {

class LineParts {
 public:
  LineParts(std::string_view text, std::size_t from, Block& block) : text_(text), at_(from), block_(block) {}

  Status run() {
    block_.text = text_;
    comment();
    block_.where = {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(end_)};
    skip();
    if (peek() == '%') return program_name();
    const Status faults = beginning();
    skip();
    const std::size_t begin = at_;
    label();
    skip();
    if (at_ < end_ || begin != at_) {
      block_.statement.kind = StatementKind::named;
      block_.statement.text = span(at_, end_);
    }
    return faults;
  }

 private:
  void comment() {
    bool quoted = false;
    end_ = text_.size();
    for (std::size_t i = at_; i < text_.size(); ++i) {
      if (text_[i] == '"') quoted = !quoted;
      if (text_[i] != ';' || quoted) continue;
      block_.comments.push_back(span(i + 1, text_.size()));
      end_ = i;
      break;
    }
    while (end_ > at_ && is_blank_sign(text_[end_ - 1])) --end_;
  }

  /// A line with % begins a program of the file, and names it (spec/sinumerik 1).
  Status program_name() {
    block_.statement.kind = StatementKind::named;
    block_.statement.text = span(at_, end_);
    return {};
  }

  Status beginning() {
    Status fault;
    if (peek() == '/') {
      const std::size_t begin = at_++;
      std::uint32_t level = 0;
      while (is_digit(peek()) && level < 1000) level = level * 10 + static_cast<std::uint32_t>(text_[at_++] - '0');
      constexpr std::uint32_t most = 9;
      if (level > most) fault = fail(alarm(AlarmId::skip_level_wrong, span(begin, at_), double(level)));
      else block_.skip = skip_of_level(static_cast<int>(level));
      skip();
    }
    const char sign = peek();
    std::size_t digits = at_ + 1;
    while (sign != ':' && digits < end_ && is_blank_sign(text_[digits])) ++digits;
    if ((to_upper(sign) != 'N' && sign != ':') || digits >= end_ || !is_digit(text_[digits])) return fault;
    const std::size_t begin = at_;
    at_ = digits;
    std::uint64_t number = 0;
    for (; is_digit(peek()) && at_ - digits < 9; ++at_) number = number * 10 + static_cast<std::uint64_t>(text_[at_] - '0');
    block_.has_number = true;
    block_.main_block = sign == ':';
    block_.number = static_cast<std::uint32_t>(number);
    block_.number_digits = static_cast<std::uint8_t>(at_ - digits);
    block_.number_where = span(begin, at_);
    if (is_digit(peek())) return fail(alarm(AlarmId::number_damaged, span(begin, at_ + 1)));
    return fault;
  }

  void label() {
    std::size_t look = at_;
    while (look < end_ && continues_name(text_[look])) ++look;
    if (look < at_ + 2 || !begins_name(text_[at_]) || !begins_name(text_[at_ + 1]) || look >= end_ || text_[look] != ':') return;
    block_.statement.label_where = span(at_, look);
    at_ = look + 1;
  }

  void skip() {
    while (at_ < end_ && is_blank_sign(text_[at_])) ++at_;
  }
  char peek() const { return at_ < end_ ? text_[at_] : '\0'; }
  static Span span(std::size_t begin, std::size_t end) { return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)}; }

  std::string_view text_;
  std::size_t at_, end_ = 0;
  Block& block_;
};

}  // namespace

Status read_named_line(std::string_view text, std::size_t from, Block& block) { return LineParts(text, from, block).run(); }

Result<Lexed> lex_named_line(std::string_view text, std::size_t from, bool is_utf8, Block& block) {
  Lexed result;
  block.text = text;
  block.where = {static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(text.size())};
  result.needs_utf8 = !is_utf8 && std::any_of(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0x80) != 0; });
  if (result.needs_utf8) return result;
  KADR_TRY(read_named_line(text, from, block));
  result.next = text.size();
  return result;
}

}  // namespace kadr
