#include "lang/lexer.h"

#include <cmath>
#include <cstring>

#include "lang/encoding.h"
#include "lang/expression.h"

namespace kadr {
namespace {

constexpr double powers_of_ten[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\0' || c == '\x7f'; }
bool is_high(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// One character above 127 of valid UTF-8.
struct Wide {
  char32_t code = 0;
  std::size_t bytes = 1;
};
Wide wide_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u; };
  const unsigned lead = byte(0);
  if ((lead & 0xE0) == 0xC0) return {static_cast<char32_t>((lead & 0x1F) << 6 | (byte(1) & 0x3F)), 2};
  if ((lead & 0xF0) == 0xE0) return {static_cast<char32_t>((lead & 0x0F) << 12 | (byte(1) & 0x3F) << 6 | (byte(2) & 0x3F)), 3};
  return {static_cast<char32_t>((lead & 0x07) << 18 | (byte(1) & 0x3F) << 12 | (byte(2) & 0x3F) << 6 | (byte(3) & 0x3F)), 4};
}

/// Reads one block; a method a kind of thing that may stand in it.
class Lexer {
 public:
  Lexer(std::string_view text, std::size_t from, bool is_utf8, const Grammar& grammar, Block& block)
      : cursor_{text, from}, begin_(from), is_utf8_(is_utf8), grammar_(grammar), block_(block) {}

  Result<Lexed> run() {
    block_.text = cursor_.text;
    cursor_.skip_blanks();
    Status status = beginning();
    while (status && !done_ && cursor_.at < cursor_.text.size()) status = item();
    block_.where = span(begin_, cursor_.at);
    if (result_.needs_utf8) return result_;
    if (!status) return fail(status.error());
    KADR_TRY(whole_block());
    cursor_.skip_blanks();
    result_.next = cursor_.at;
    return result_;
  }

 private:
  // ---- what stands before the words

  Status beginning() {
    const char c = cursor_.peek();
    if (c == '%') return program_start();
    if (c == '/' && !(grammar_.slash_comments && at(1) == '/')) return skip();
    return {};
  }

  Status program_start() {
    const std::size_t begin = cursor_.at;
    while (cursor_.peek() == '%') ++cursor_.at;
    if (grammar_.percent_ignored) {
      cursor_.at = cursor_.text.size();
      done_ = true;
      return {};
    }
    block_.marker = Marker::program_start;
    cursor_.skip_blanks();
    if (!is_digit(cursor_.peek())) return {};
    Number number;
    const bool read = read_number(cursor_, number);
    if (!read || number.has_point || !grammar_.percent_number || number.whole_digits > grammar_.percent_digits)
      return fail(alarm(AlarmId::program_number_damaged, span(begin, cursor_.at), double(grammar_.percent_digits)));
    block_.label = static_cast<std::uint32_t>(number.value);
    return {};
  }

  Status skip() {
    ++cursor_.at;
    block_.skip = 1;
    if (grammar_.skip_levels && is_digit(cursor_.peek())) block_.skip = static_cast<std::uint8_t>(cursor_.text[cursor_.at++] - '0');
    cursor_.skip_blanks();
    return {};
  }

  // ---- the words

  Status item() {
    const char c = cursor_.text[cursor_.at];
    if (is_upper(c)) return word(c, 1);
    if (is_blank(c)) {
      ++cursor_.at;
      return {};
    }
    switch (c) {
      case '(': return comment();
      case ';': return grammar_.semicolon_comments ? line_comment(1) : unexpected();
      case '/': return slash();
      case '#': return grammar_.expressions ? assignment() : unexpected();
      case ':': return main_block();
      default: break;
    }
    if (is_high(c) || c == '\x0e') return wide();
    if (is_lower(c) && grammar_.lower_case) return word(static_cast<char>(c - 'a' + 'A'), 1);
    return unexpected();
  }

  Status word(char letter, std::size_t bytes) {
    const std::size_t begin = cursor_.at;
    if (letter == 'L' && marks_end("LF", begin)) return end_mark(2);
    cursor_.at += bytes;
    cursor_.skip_blanks();
    const WordFormat& format = grammar_.word(letter);
    if (letter == grammar_.section_address && no_value_follows()) return section(begin);
    if (!format.known) return fail(alarm(AlarmId::address_unknown, span(begin, cursor_.at), letter));
    if (letter == 'N') return block_number(begin, format);
    if (letter == grammar_.label_address) return label(begin, format);
    if (letter == grammar_.parameter_address) return formal_parameter(begin);
    KADR_TRY(room_for(letter, format, begin));
    Word& w = block_.words[block_.word_count];
    w.address = letter;
    w.expression = {};
    w.code = -1;
    if (format.second_number) w.second = std::numeric_limits<double>::quiet_NaN();
    KADR_TRY(value(w, format, begin));
    w.where = span(begin, cursor_.at);
    ++block_.word_count;
    return {};
  }

  Status room_for(char letter, const WordFormat& format, std::size_t begin) {
    const std::uint32_t bit = letter_bit(letter);
    if (block_.word_count == limits::block_words)
      return fail(alarm(AlarmId::too_many_words, span(begin, cursor_.at), double{limits::block_words}));
    if ((block_.letters & bit) == 0) [[likely]] {
      block_.letters |= bit;
      block_.at[static_cast<std::size_t>(letter - 'A')] = static_cast<std::uint8_t>(block_.word_count);
      return {};
    }
    if (format.at_most == 0) return {};
    if (format.at_most == 1) return fail(alarm(AlarmId::address_twice, span(begin, cursor_.at), letter));
    std::uint32_t count = 1;
    for (std::uint32_t i = 0; i < block_.word_count; ++i) count += block_.words[i].address == letter;
    if (count <= format.at_most) return {};
    return fail(alarm(AlarmId::too_many_codes, span(begin, cursor_.at), letter, double(count), double(format.at_most)));
  }

  Status value(Word& w, const WordFormat& format, std::size_t begin) {
    char sign = 0;
    const std::size_t sign_at = cursor_.at;
    if (cursor_.peek() == '+' || cursor_.peek() == '-') {
      sign = cursor_.text[cursor_.at++];
      cursor_.skip_blanks();
    }
    const char c = cursor_.peek();
    if (is_digit(c) || c == '.') [[likely]] {
      if (sign != 0 && !format.sign) return fail(alarm(AlarmId::sign_not_allowed, span(sign_at, sign_at + 1), w.address));
      return number(w, format, sign, begin);
    }
    if (format.parameter && c == grammar_.parameter_address) return parameter_sum(w, format, 0, sign == '-' ? '-' : '+', begin);
    if (!grammar_.expressions || no_value_follows()) return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), w.address));
    auto expression = compile_value(cursor_, grammar_, block_);
    if (!expression) return fail(expression.error());
    if (sign == '-') {
      block_.code.push_back({Op::negate, 0, span(sign_at, cursor_.at)});
      ++expression->end;
    }
    w.expression = *expression;
    w.digits = 0;
    w.has_point = false;
    return {};
  }

  Status number(Word& w, const WordFormat& format, char sign, std::size_t begin) {
    Number read;
    if (!read_number(cursor_, read)) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at), w.address));
    if (grammar_.expressions && cursor_.at < cursor_.text.size() && is_blank(cursor_.text[cursor_.at])) KADR_TRY(digits_apart(read, w, begin));
    w.digits = static_cast<std::uint8_t>(std::min(read.whole_digits + read.fraction_digits, 255));
    w.has_point = read.has_point;
    if (format.whole_digits != 0) KADR_TRY(check_digits(w, read, format, begin));
    w.value = format.implied && !read.has_point ? read.mantissa / powers_of_ten[format.fraction_digits] : read.value;
    if (sign == '-') w.value = -w.value;
    if (format.code) KADR_TRY(code_of(w, read, begin));
    if (format.parameter) {
      cursor_.skip_blanks();
      const char c = cursor_.peek();
      if ((c == '+' || c == '-')) return parameter_sum(w, format, sign == '-' ? -read.mantissa : read.mantissa, c, begin);
    }
    if (format.second_number) return second_number(w);
    return {};
  }

  /// RS274/NGC: blanks mean nothing, even between digits (`X1 0` is X10).
  Status digits_apart(Number& read, const Word& w, std::size_t begin) {
    Cursor ahead = cursor_;
    ahead.skip_blanks();
    if (!is_digit(ahead.peek()) && (ahead.peek() != '.' || read.has_point)) return {};
    std::string digits;
    Cursor from{cursor_.text, cursor_.at - read.whole_digits - read.fraction_digits - (read.has_point ? 1u : 0u)};
    while (is_digit(from.peek()) || from.peek() == '.') {
      digits += from.text[from.at++];
      cursor_.at = from.at;
      from.skip_blanks();
    }
    Cursor whole{digits, 0};
    if (!read_number(whole, read) || whole.at != digits.size())
      return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at), w.address));
    return {};
  }

  Status check_digits(const Word& w, const Number& read, const WordFormat& format, std::size_t begin) const {
    const int most = format.whole_digits + (format.implied && !read.has_point ? format.fraction_digits : 0);
    const Span where = span(begin, cursor_.at);
    if (read.has_point && !format.point) return fail(alarm(AlarmId::point_not_allowed, where, w.address));
    if (read.whole_digits > most) return fail(alarm(AlarmId::too_many_digits, where, w.address, double(read.whole_digits), double(most)));
    if (read.fraction_digits > format.fraction_digits)
      return fail(alarm(AlarmId::too_many_decimals, where, w.address, double(read.fraction_digits), double(format.fraction_digits)));
    if (!format.drop_zeros && !read.has_point && read.whole_digits < most)
      return fail(alarm(AlarmId::too_few_digits, where, w.address, double(read.whole_digits), double(most)));
    return {};
  }

  Status code_of(Word& w, const Number& read, std::size_t begin) const {
    const double tenth = w.value * 10;
    const double nearest = std::round(tenth);
    if (std::fabs(tenth - nearest) > 1e-9 || nearest < 0 || nearest > 1e9)
      return fail(alarm(AlarmId::code_unknown, span(begin, cursor_.at), cursor_.text.substr(begin, cursor_.at - begin)));
    w.code = static_cast<std::int32_t>(nearest);
    (void)read;
    return {};
  }

  Status second_number(Word& w) {
    cursor_.skip_blanks();
    if (!is_digit(cursor_.peek())) return {};
    Number read;
    if (!read_number(cursor_, read)) return fail(alarm(AlarmId::number_damaged, span(cursor_.at, cursor_.at + 1), w.address));
    w.second = read.value;
    return {};
  }

  // ---- formal parameters (2С42 6.3.7)

  /// `X+R1`, `Z-1200+R2`: the raw digits are added, then take the unit of the address.
  Status parameter_sum(Word& w, const WordFormat& format, double constant, char sign, std::size_t begin) {
    const std::size_t sign_at = cursor_.at;
    if (cursor_.peek() == '+' || cursor_.peek() == '-') {
      ++cursor_.at;
      cursor_.skip_blanks();
    }
    if (cursor_.peek() != grammar_.parameter_address) return fail(alarm(AlarmId::parameter_not_allowed, span(sign_at, cursor_.at + 1), w.address));
    ++cursor_.at;
    if (!is_digit(cursor_.peek())) return fail(alarm(AlarmId::number_missing, span(sign_at, cursor_.at), grammar_.parameter_address));
    const double index = cursor_.text[cursor_.at++] - '0';
    Expression e;
    e.begin = static_cast<std::uint16_t>(block_.code.size());
    const Span where = span(begin, cursor_.at);
    block_.code.push_back({Op::number, constant, where});
    block_.code.push_back({Op::parameter, index, where});
    block_.code.push_back({sign == '-' ? Op::subtract : Op::add, 0, where});
    if (format.implied) block_.code.push_back({Op::scale, powers_of_ten[format.fraction_digits], where});
    e.end = static_cast<std::uint16_t>(block_.code.size());
    w.expression = e;
    w.digits = 0;
    return {};
  }

  /// `R2+50` sets R2; the sign is mandatory, INFERRED: without one it is +.
  Status formal_parameter(std::size_t begin) {
    if (!is_digit(cursor_.peek())) return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), grammar_.parameter_address));
    const double index = cursor_.text[cursor_.at++] - '0';
    cursor_.skip_blanks();
    const char sign = cursor_.peek();
    if (sign == '+' || sign == '-') ++cursor_.at;
    cursor_.skip_blanks();
    Number read;
    if (!is_digit(cursor_.peek()) || !read_number(cursor_, read) || read.has_point)
      return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), grammar_.parameter_address));
    if (read.whole_digits > 7) return fail(alarm(AlarmId::too_many_digits, span(begin, cursor_.at), grammar_.parameter_address, double(read.whole_digits), 7.0));
    for (const Assignment& other : block_.assignments)
      if (block_.code[other.target.begin].number == index) return fail(alarm(AlarmId::address_twice, span(begin, cursor_.at), cursor_.text.substr(begin, 2)));
    const Span where = span(begin, cursor_.at);
    const auto target = constant(index, where);
    const auto value = constant(sign == '-' ? -read.mantissa : read.mantissa, where);
    block_.assignments.push_back({target, value, where});
    return {};
  }

  Expression constant(double number, Span where) {
    const auto begin = static_cast<std::uint16_t>(block_.code.size());
    block_.code.push_back({Op::number, number, where});
    return {begin, static_cast<std::uint16_t>(begin + 1)};
  }

  // ---- numbers of blocks, labels, sections

  Status block_number(std::size_t begin, const WordFormat& format) {
    Number read;
    if (!is_digit(cursor_.peek()) || !read_number(cursor_, read)) return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), 'N'));
    if (block_.has_number) return fail(alarm(AlarmId::address_twice, span(begin, cursor_.at), 'N'));
    if (block_.word_count != 0) return fail(alarm(AlarmId::block_number_position, span(begin, cursor_.at)));
    Word w;
    w.address = 'N';
    if (format.whole_digits != 0) KADR_TRY(check_digits(w, read, format, begin));
    if (read.value >= 1e9 || read.has_point) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at), 'N'));
    block_.has_number = true;
    block_.number = static_cast<std::uint32_t>(read.value);
    block_.number_digits = read.whole_digits;
    block_.number_where = span(begin, cursor_.at);
    return {};
  }

  Status main_block() {
    const std::size_t begin = cursor_.at;
    if (!grammar_.main_blocks) return unexpected();
    ++cursor_.at;
    cursor_.skip_blanks();
    block_.main_block = true;
    return block_number(begin, grammar_.word('N'));
  }

  Status label(std::size_t begin, const WordFormat& format) {
    Number read;
    if (!is_digit(cursor_.peek()) || !read_number(cursor_, read)) return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), grammar_.label_address));
    if (block_.marker == Marker::label) return fail(alarm(AlarmId::address_twice, span(begin, cursor_.at), grammar_.label_address));
    Word w;
    w.address = grammar_.label_address;
    if (format.whole_digits != 0) KADR_TRY(check_digits(w, read, format, begin));
    if (read.value >= 1e9 || read.has_point) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at), grammar_.label_address));
    block_.marker = Marker::label;
    block_.label = static_cast<std::uint32_t>(read.value);
    return {};
  }

  Status section(std::size_t begin) {
    if (block_.word_count != 0 || block_.has_number || !block_.assignments.empty())
      return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), grammar_.section_address));
    block_.marker = Marker::section;
    return {};
  }

  Status assignment() {
    const std::size_t begin = cursor_.at++;
    auto target = compile_value(cursor_, grammar_, block_);
    if (!target) return fail(target.error());
    cursor_.skip_blanks();
    if (cursor_.peek() != '=') return fail(alarm(AlarmId::expression_syntax, span(begin, cursor_.at + 1), "#n="));
    ++cursor_.at;
    auto value = compile_value(cursor_, grammar_, block_);
    if (!value) return fail(value.error());
    if (block_.assignments.size() == limits::block_assignments)
      return fail(alarm(AlarmId::too_many_words, span(begin, cursor_.at), double{limits::block_assignments}));
    block_.assignments.push_back({*target, *value, span(begin, cursor_.at)});
    return {};
  }

  // ---- comments, ends, other characters

  Status comment() {
    const std::size_t begin = cursor_.at;
    const std::size_t close = cursor_.text.find(')', begin);
    if (close == std::string_view::npos) {
      cursor_.at = cursor_.text.size();
      return fail(alarm(AlarmId::comment_not_closed, span(begin, begin + 1)));
    }
    if (!grammar_.comment_forbidden.empty()) {
      const std::size_t bad = cursor_.text.substr(0, close).find_first_of(grammar_.comment_forbidden, begin);
      if (bad != std::string_view::npos) return fail(alarm(AlarmId::comment_character, span(bad, bad + 1), cursor_.text[bad]));
    }
    block_.comments.push_back(span(begin + 1, close));
    cursor_.at = close + 1;
    return {};
  }

  Status line_comment(std::size_t marks) {
    block_.comments.push_back(span(cursor_.at + marks, cursor_.text.size()));
    cursor_.at = cursor_.text.size();
    return {};
  }

  Status slash() {
    if (grammar_.slash_comments && at(1) == '/') return line_comment(2);
    if (!grammar_.zero_between_slashes) return fail(alarm(AlarmId::skip_position, span(cursor_.at, cursor_.at + 1)));
    const std::size_t begin = cursor_.at++;
    cursor_.skip_blanks();
    KADR_TRY(room_for('A', grammar_.word('A'), begin));
    Word& w = block_.words[block_.word_count];
    w.address = 'A';
    w.expression = {};
    w.code = -1;
    WordFormat format = grammar_.word('A');
    format.parameter = true;
    KADR_TRY(value(w, format, begin));
    cursor_.skip_blanks();
    if (cursor_.peek() != '/') return fail(alarm(AlarmId::skip_position, span(begin, begin + 1)));
    ++cursor_.at;
    w.where = span(begin, cursor_.at);
    ++block_.word_count;
    return {};
  }

  Status wide() {
    if (!is_utf8_ || cursor_.text[cursor_.at] == '\x0e') {
      result_.needs_utf8 = !is_utf8_;
      done_ = true;
      return result_.needs_utf8 ? Status() : unexpected();
    }
    const Wide c = wide_at(cursor_.text, cursor_.at);
    const std::string_view rest = cursor_.text.substr(cursor_.at);
    if (grammar_.end_of_block != EndOfBlock::line_only && (rest.starts_with("ПС") || rest.starts_with("пс"))) return end_mark(4);
    if (c.code == 0xA0 || c.code == 0xFEFF) {   // no-break space, byte order mark
      cursor_.at += c.bytes;
      return {};
    }
    const char latin = look_alike(c.code);
    if (latin == 0) return fail(alarm(AlarmId::unexpected_character, span(cursor_.at, cursor_.at + c.bytes), rest.substr(0, c.bytes)));
    if (block_.warnings.size() < limits::block_words)
      block_.warnings.push_back(warning(AlarmId::look_alike_letter, span(cursor_.at, cursor_.at + c.bytes), rest.substr(0, c.bytes), latin));
    return word(latin, c.bytes);
  }

  Status end_mark(std::size_t bytes) {
    cursor_.at += bytes;
    result_.marked = true;
    done_ = true;
    cursor_.skip_blanks();
    return {};
  }

  bool marks_end(std::string_view mark, std::size_t at) const {
    if (grammar_.end_of_block == EndOfBlock::line_only || !cursor_.text.substr(at).starts_with(mark)) return false;
    const std::size_t next = at + mark.size();
    return next >= cursor_.text.size() || is_blank(cursor_.text[next]) || cursor_.text[next] == '(';
  }

  bool no_value_follows() const {
    if (cursor_.at >= cursor_.text.size()) return true;
    const char c = cursor_.text[cursor_.at];
    if (c == '(' || c == ';' || c == '/') return true;
    return is_high(c) || marks_end("LF", cursor_.at);
  }

  Status unexpected() {
    const auto c = static_cast<unsigned char>(cursor_.text[cursor_.at]);
    const Span where = span(cursor_.at, cursor_.at + 1);
    if (c < 0x20) return fail(alarm(AlarmId::control_character, where, double(c)));
    return fail(alarm(AlarmId::unexpected_character, where, cursor_.text[cursor_.at]));
  }

  /// What can be said only of the block as a whole.
  Status whole_block() {
    if (grammar_.block_length != 0 && !block_.empty()) {
      std::uint32_t length = 0;
      for (std::size_t i = begin_; i < cursor_.at; ++i) length += (static_cast<unsigned char>(cursor_.text[i]) & 0xC0) != 0x80;
      if (length > grammar_.block_length)
        return fail(alarm(AlarmId::block_too_long, span(begin_, cursor_.at), double(length), double(grammar_.block_length)));
    }
    const bool has_words = block_.word_count != 0 || !block_.assignments.empty();
    if (grammar_.block_number_required && has_words && !block_.has_number && block_.marker == Marker::none)
      return fail(alarm(AlarmId::block_number_missing, span(begin_, begin_ + 1)));
    return {};
  }

  char at(std::size_t ahead) const { return cursor_.at + ahead < cursor_.text.size() ? cursor_.text[cursor_.at + ahead] : '\0'; }
  Span span(std::size_t begin, std::size_t end) const {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::min(end, cursor_.text.size()))};
  }

  Cursor cursor_;
  std::size_t begin_;
  bool is_utf8_;
  const Grammar& grammar_;
  Block& block_;
  Lexed result_;
  bool done_ = false;
};

}  // namespace

Result<Lexed> lex_block(std::string_view text, std::size_t from, bool is_utf8, const Grammar& grammar, Block& block) {
  return Lexer(text, from, is_utf8, grammar, block).run();
}

}  // namespace kadr
