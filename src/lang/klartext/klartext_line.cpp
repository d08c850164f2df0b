// Reads a line of a conversational control. Used by lang/block/lexer; tested by tests/lang/klartext_test.cpp.

#include "lang/klartext/klartext_line.h"

#include <algorithm>

#include "base/ascii.h"
#include "base/powers_of_ten.h"

namespace kadr {
namespace {

constexpr bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }

/// The M functions that are rows of the control's table and take no words of their own (spec/heidenhain 3.5).
constexpr bool is_plain_code(unsigned code) { return code <= 6 || code == 8 || code == 9 || code == 13 || code == 14 || code == 30; }

/// Reads `L` and its words, if all of them are plain.
class PlainLine {
 public:
  PlainLine(std::string_view text, std::size_t at, std::size_t end, Block& block) : text_(text), at_(at), end_(end), block_(block) {}

  /// Returns false, and leaves no words in the block, if a word is not plain.
  bool read() {
    const std::size_t begin = at_++;
    Word& motion = add('G', begin);
    motion.code = 10;
    motion.value = 1;
    while (true) {
      skip();
      if (at_ == end_) break;
      if (!word()) return give_up();
    }
    motion.where.end = static_cast<std::uint32_t>(begin + 1);
    if (rapid_) {
      motion.code = 0;
      motion.value = 0;
    }
    for (std::uint32_t i = 0; i < block_.word_count; ++i) {
      const Word& w = block_.words[i];
      block_.shape.add(w.address, w.code);
    }
    return true;
  }

 private:
  bool give_up() {
    block_.word_count = 0;
    block_.letters = 0;
    block_.shape = {};
    return false;
  }

  bool word() {
    const std::size_t begin = at_;
    const char letter = to_upper(text_[at_++]);
    switch (letter) {
      case 'X':
      case 'Y':
      case 'Z':
      case 'A':
      case 'B':
      case 'C':
      case 'U':
      case 'V':
      case 'W': return !block_.has(letter) && number(letter, begin, true);
      case 'F':
        skip();
        if (at_ + 3 <= end_ && to_upper(text_[at_]) == 'M') {
          if (to_upper(text_[at_ + 1]) != 'A' || to_upper(text_[at_ + 2]) != 'X' || rapid_ || block_.has('F')) return false;
          at_ += 3;
          rapid_ = true;
          return at_ == end_ || is_blank(text_[at_]);
        }
        return !rapid_ && !block_.has('F') && number('F', begin, false);
      case 'R': return compensation(begin);
      case 'M': return code(begin);
      default: return false;
    }
  }

  bool compensation(std::size_t begin) {
    if (at_ == end_ || compensated_) return false;
    const char side = to_upper(text_[at_++]);
    if (side != '0' && side != 'L' && side != 'R') return false;
    if (at_ != end_ && !is_blank(text_[at_])) return false;
    compensated_ = true;
    Word& w = add('G', begin);
    w.code = side == '0' ? 400 : side == 'L' ? 410 : 420;
    w.value = w.code / 10.0;
    return true;
  }

  bool code(std::size_t begin) {
    unsigned value = 0;
    std::size_t digits = 0;
    for (; at_ != end_ && is_digit(text_[at_]) && digits < 4; ++at_, ++digits) value = value * 10 + static_cast<unsigned>(text_[at_] - '0');
    if (digits == 0 || !is_plain_code(value) || (at_ != end_ && !is_blank(text_[at_]))) return false;
    Word& w = add('M', begin);
    w.code = static_cast<std::int32_t>(value * 10);
    w.value = value;
    return true;
  }

  bool number(char letter, std::size_t begin, bool may_have_sign) {
    skip();
    bool minus = false;
    if (may_have_sign && at_ != end_ && (text_[at_] == '+' || text_[at_] == '-')) {
      minus = text_[at_++] == '-';
      skip();
    }
    std::uint64_t mantissa = 0;
    std::size_t digits = 0, decimals = 0;
    for (; at_ != end_ && is_digit(text_[at_]); ++at_, ++digits) mantissa = mantissa * 10 + static_cast<std::uint64_t>(text_[at_] - '0');
    const bool has_point = at_ != end_ && (text_[at_] == '.' || text_[at_] == ',');
    if (has_point)
      for (++at_; at_ != end_ && is_digit(text_[at_]); ++at_, ++digits, ++decimals)
        mantissa = mantissa * 10 + static_cast<std::uint64_t>(text_[at_] - '0');
    constexpr std::size_t exact_digits = 15;  // a whole number of 15 digits is exact in a double
    if (digits == 0 || digits > exact_digits) return false;
    Word& w = add(letter, begin);
    const double value = static_cast<double>(mantissa) / powers_of_ten[decimals];
    w.value = minus ? -value : value;
    w.digits = static_cast<std::uint8_t>(digits);
    w.has_point = true;
    return true;
  }

  Word& add(char letter, std::size_t begin) {
    const std::uint32_t index = block_.word_count++;
    if (!block_.has(letter)) {
      block_.letters |= letter_bit(letter);
      block_.at[static_cast<std::size_t>(letter - 'A')] = static_cast<std::uint8_t>(index);
    }
    Word& w = block_.words[index];
    w = Word{};
    w.address = w.written = letter;
    w.where = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
    return w;
  }

  void skip() {
    while (at_ != end_ && is_blank(text_[at_])) ++at_;
  }

  std::string_view text_;
  std::size_t at_, end_;
  Block& block_;
  bool rapid_ = false, compensated_ = false;
};

class KlartextLine {
 public:
  KlartextLine(std::string_view text, std::size_t from, Block& block) : text_(text), at_(from), end_(text.size()), block_(block) {}

  /// Returns true if the block goes on in the next line.
  bool run() {
    block_.text = text_;
    std::size_t last = end_;
    while (last > at_ && is_blank(text_[last - 1])) --last;
    const bool continues = last > at_ && text_[last - 1] == '~';
    end_ = last;
    block_.where = {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(end_)};
    beginning();
    if (at_ == end_) return continues;
    if (text_[at_] == ';' || text_[at_] == '*') {  // a comment, or a structure block
      comment(at_ + 1, end_);
      return continues;
    }
    if (continues) return true;
    find_comments();
    const bool one_line = text_.find('\n', at_) == std::string_view::npos;
    const char first = to_upper(text_[at_]);
    if (one_line && first == 'L' && at_ + 1 < statement_end_ && is_blank(text_[at_ + 1]) &&
        PlainLine(text_, at_, statement_end_, block_).read())
      return false;
    block_.statement.kind = StatementKind::klartext;
    block_.statement.text = {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(one_line ? statement_end_ : end_)};
    return false;
  }

 private:
  void beginning() {
    skip_mark();
    const std::size_t begin = at_;
    std::uint64_t number = 0;
    std::size_t digits = 0;
    for (; at_ < end_ && is_digit(text_[at_]) && digits < 9; ++at_, ++digits)
      number = number * 10 + static_cast<std::uint64_t>(text_[at_] - '0');
    if (digits > 0) {
      block_.has_number = true;
      block_.number = static_cast<std::uint32_t>(number);
      block_.number_digits = static_cast<std::uint8_t>(digits);
      block_.number_where = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
    }
    skip_mark();
  }

  void skip_mark() {
    skip();
    if (at_ == end_ || text_[at_] != '/') return;
    block_.skip = 1;
    ++at_;
    skip();
  }

  void comment(std::size_t begin, std::size_t end) {
    block_.comments.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
  }

  /// Notes the comments of each line of the statement. `;` within quotation marks is text.
  void find_comments() {
    bool quoted = false;
    statement_end_ = end_;
    for (std::size_t i = at_; i < end_; ++i) {
      const char c = text_[i];
      if (c == '\n') quoted = false;
      if (c == '"') quoted = !quoted;
      if (c != ';' || quoted) continue;
      const std::size_t line_end = std::min(text_.find('\n', i), end_);
      comment(i + 1, line_end);
      if (statement_end_ == end_) statement_end_ = i;
      i = line_end;
      quoted = false;
    }
    while (statement_end_ > at_ && is_blank(text_[statement_end_ - 1])) --statement_end_;
  }

  void skip() {
    while (at_ < end_ && is_blank(text_[at_])) ++at_;
  }

  std::string_view text_;
  std::size_t at_, end_;
  std::size_t statement_end_ = 0;  // of the first line, without its comment
  Block& block_;
};

}  // namespace

Result<Lexed> lex_klartext_line(std::string_view text, std::size_t from, bool is_utf8, Block& block) {
  Lexed result;
  result.needs_utf8 = !is_utf8 && std::any_of(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0x80) != 0; });
  if (result.needs_utf8) {
    block.text = text;
    block.where = {static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(text.size())};
    return result;
  }
  result.continues = KlartextLine(text, from, block).run();
  result.next = text.size();
  return result;
}

}  // namespace kadr
