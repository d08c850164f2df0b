// Splits the text of one block into words. Used by control/interpreter_start, lang/block/block_reader; tested by tests/lang/lexer_test.cpp.

#include "lang/block/lexer.h"

#include <cmath>
#include <limits>

#include "base/ascii.h"
#include "lang/block/block_parts.h"
#include "lang/block/line_word_reader.h"
#include "lang/block/o_word_reader.h"
#include "lang/block/odd_characters.h"
#include "lang/block/statement_reader.h"
#include "lang/block/word_reader.h"
#include "lang/expression/expression.h"
#include "lang/klartext/klartext_line.h"
#include "lang/named/named_reader.h"
#include "lang/text/encoding.h"
#include "lang/text/wide.h"

namespace kadr {
namespace {

/// Reads one block. There is one method for each type of item: word, comment, label, …
class Lexer {
 public:
  Lexer(std::string_view text, std::size_t from, bool is_utf8, const Grammar& grammar, Block& block)
      : cursor_{text, from},
        begin_(from),
        is_utf8_(is_utf8),
        grammar_(grammar),
        block_(block),
        words_(cursor_, grammar, block),
        statements_(cursor_, grammar, block) {}

  Result<Lexed> run() {
    block_.text = cursor_.text;
    cursor_.skip_blanks();
    const Status status = items();  // a Status is as large as an Alarm, so the functions of the lexer return it, but never assign it
    block_.where = span(begin_, cursor_.at);
    if (result_.needs_utf8 || result_.open_comment) return result_;
    if (!status) return fail(status.error());
    KADR_TRY(whole_block());
    if (result_.needs_utf8) return result_;
    cursor_.skip_blanks();
    result_.next = cursor_.at;
    return result_;
  }

 private:
  Status items() {
    if (grammar_.filtered_lines) return filtered_line();
    KADR_TRY(beginning());
    while (!done_ && cursor_.at < cursor_.text.size()) KADR_TRY(item());
    return {};
  }

  Status filtered_line() {
    if (!is_utf8_ && has_high(cursor_.text.size())) {
      result_.needs_utf8 = true;
      return {};
    }
    return LineWordReader(cursor_, grammar_, block_).read();
  }

  // ---- before the words

  Status beginning() {
    const char c = cursor_.peek();
    if (c == '%') return program_start();
    if (c == '/' && !(grammar_.slash_comments && at(1) == '/')) return skip();
    return {};
  }

  Status program_start() {
    const std::size_t begin = cursor_.at;
    while (cursor_.peek() == '%') ++cursor_.at;
    if (grammar_.percent_encloses) return sign_of_file(begin);
    if (grammar_.percent_ignored) {
      cursor_.at = cursor_.text.size();
      done_ = true;
      return {};
    }
    const bool tape_begins = cursor_.at - begin > 1;
    cursor_.skip_blanks();
    if (tape_begins && !is_digit(cursor_.peek())) return {};  // in `%%` alone the tape starts, but no program yet (spec/gost 1)
    block_.marker = Marker::program_start;
    if (!is_digit(cursor_.peek())) return {};
    Number number;
    const bool read = read_number(cursor_, number);
    if (!read || number.has_point || !grammar_.percent_number || number.whole_digits > grammar_.percent_digits)
      return fail(alarm(AlarmId::program_number_damaged, span(begin, cursor_.at), double(grammar_.percent_digits)));
    block_.label = static_cast<std::uint32_t>(number.value);
    return {};
  }

  /// Reads `%`, which must be the only character in its line (spec/linuxcnc 2.1).
  Status sign_of_file(std::size_t begin) {
    cursor_.skip_blanks();
    if (cursor_.at < cursor_.text.size()) {
      cursor_.at = begin;
      return unexpected();
    }
    block_.marker = Marker::program_start;
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
    if (block_.statement.kind > StatementKind::words && !is_blank(c) && c != '(' && c != ';' && !block_.statement.words_follow)
        [[unlikely]]  // only blanks and comments may follow a statement
      return fail(alarm(AlarmId::statement_not_alone, span(cursor_.at, cursor_.at + 1)));
    if (is_capital(c)) return word(c, 1);
    if (is_blank(c)) {
      ++cursor_.at;
      return {};
    }
    switch (c) {
      case '(': return comment();
      case ';': return grammar_.semicolon_comments ? line_comment(1) : grammar_.semicolon_ends ? end_by_semicolon() : unexpected();
      case '/': return slash();
      case '#': return grammar_.expressions ? assignment() : words_.parameter_by_sign();
      case ',': return grammar_.comma_words ? comma_word() : unexpected();
      case '<': return grammar_.file_names ? file_name() : unexpected();
      case ':': return grammar_.colon_is_label ? word_of(grammar_.label_address, 1, cursor_.at) : main_block();
      case '[': return statements_.bracket();
      case '\x1a': return passes_dos_end(cursor_) ? Status() : unexpected();  // Ctrl-Z ends a file on old systems
      case ']':
      case '=': return grammar_.has_statements() ? out_of_place(c) : unexpected();
      default: break;
    }
    if (is_high(c) || c == '\x0e') return wide();
    if (is_lower(c) && grammar_.lower_case) return word(to_upper(c), 1);
    for (const AddressName& name : grammar_.names)  // one of these names may be a sign: `$`, `@`, `^`
      if (name.text.size() == 1 && name.text[0] == c) return word_of(name.address, 1, cursor_.at);
    return words_.parameter_by_sign();
  }

  Status word(char letter, std::size_t bytes) {
    const std::size_t begin = cursor_.at;
    if (letter == 'L' && words_.marks_end("LF", begin)) return end_mark(2);
    if (letter == 'O' && grammar_.o_words) return o_line();
    if (grammar_.has_statements()) {
      const char next = begin + bytes < cursor_.text.size() ? cursor_.text[begin + bytes] : '\0';
      if (is_letter(next)) {
        if (const Keyword keyword = statements_.keyword_here(); statements_.knows(keyword)) return statements_.read(keyword);
        if ((letter == 'A') && (next == 'X' || next == 'x')) return words_.axis_by_number(begin);
      }
      if ((grammar_.named >> (letter - 'A') & 1u) != 0)
        if (const AddressName* const name = words_.name_here(); name != nullptr) return word_of(name->address, name->text.size(), begin);
    }
    return word_of(letter, bytes, begin);
  }

  Status o_line() { return begins() && block_.assignments.empty() ? OWordReader(cursor_, grammar_, block_).read() : unexpected(); }

  /// Returns true if the block so far has neither words nor IF[…] THEN.
  bool begins() const { return block_.word_count == 0 && block_.statement.kind == StatementKind::none; }

  /// Reads a word whose address is `letter`. The address is written with `bytes` bytes.
  Status word_of(char letter, std::size_t bytes, std::size_t begin) {
    cursor_.at += bytes;
    cursor_.skip_blanks();
    const WordFormat& format = grammar_.word(letter);
    if (!grammar_.long_parameters.empty() && words_.assigns_parameter(letter)) return words_.long_parameter(letter, begin);
    if (letter == grammar_.section_address && words_.no_value_follows()) return section(begin);
    if (!format.known && letter > 'Z')
      return fail(alarm(AlarmId::not_available, span(begin, cursor_.at), cursor_.text.substr(begin, cursor_.at - begin)));
    if (!format.known) return fail(alarm(AlarmId::address_unknown, span(begin, cursor_.at), letter));
    if (letter == 'N' && !(grammar_.custom_macros && (block_.has_number || !begins()))) return words_.block_number(begin, format);
    if (letter == grammar_.label_address && !(grammar_.custom_macros && !begins())) return words_.label(begin, format);
    if (grammar_.custom_macros && cursor_.peek() == '=') {
      ++cursor_.at;
      cursor_.skip_blanks();
    }
    if (letter == grammar_.parameter_address) return words_.formal_parameter(begin);
    KADR_TRY(words_.room_for(letter, format, begin));
    Word& w = block_.words[block_.word_count];
    w.address = w.written = letter;
    w.expression = {};
    w.code = -1;
    w.incremental = w.bare = false;
    w.value = 0;  // if the word cannot be read, its value remains 0: a caller that continues after the fault may use this value
    if (format.second_number) w.second = std::numeric_limits<double>::quiet_NaN();
    KADR_TRY(words_.value(w, format, begin));
    w.where = span(begin, cursor_.at);
    ++block_.word_count;
    return {};
  }

  // ---- names of several characters, ,C ,R ,A, AX[…], <file>

  Status comma_word() {
    const std::size_t begin = cursor_.at++;
    cursor_.skip_blanks();
    const char letter = to_upper(cursor_.peek());
    const char address = comma_address(letter);
    if (address == 0) return fail(alarm(AlarmId::unexpected_character, span(begin, begin + 1), ','));
    return word_of(address, 1, begin);
  }

  Status file_name() {
    const std::size_t begin = cursor_.at;
    const std::size_t close = cursor_.text.find('>', begin);
    if (block_.file_name.end != 0) return unexpected();
    if (close == std::string_view::npos)
      return fail(alarm(AlarmId::file_name, span(begin, cursor_.text.size()), cursor_.text.substr(begin)));
    for (std::size_t i = begin; i < close && !is_utf8_; ++i)
      if (is_high(cursor_.text[i])) {
        result_.needs_utf8 = done_ = true;
        return {};
      }
    block_.file_name = span(begin + 1, close);
    cursor_.at = close + 1;
    return {};
  }

  // ---- numbers of blocks, labels, sections

  Status main_block() {
    const std::size_t begin = cursor_.at;
    if (!grammar_.main_blocks) return unexpected();
    ++cursor_.at;
    cursor_.skip_blanks();
    block_.main_block = true;
    return words_.block_number(begin, grammar_.word('N'));
  }

  Status section(std::size_t begin) {
    if (block_.word_count != 0 || block_.has_number || !block_.assignments.empty())
      return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), grammar_.section_address));
    block_.marker = Marker::section;
    return {};
  }

  Status assignment() {
    const std::size_t begin = cursor_.at++;
    if (grammar_.has_statements()) return statements_.assignment(begin);
    return read_assignment(cursor_, grammar_, block_, begin);
  }

  // ---- comments, ends of blocks, other characters

  Status comment() {
    const std::size_t begin = cursor_.at;
    const std::size_t close = cursor_.text.find(')', begin);
    if (close == std::string_view::npos) {
      cursor_.at = cursor_.text.size();
      if (grammar_.comments_span_lines) result_.open_comment = done_ = true, result_.comment_at = begin;
      return fail(alarm(AlarmId::comment_not_closed, span(begin, begin + 1)));
    }
    if (!grammar_.comment_forbidden.empty()) {
      const std::size_t bad = cursor_.text.substr(0, close).find_first_of(grammar_.comment_forbidden, begin + 1);
      if (bad != std::string_view::npos) return fail(alarm(AlarmId::comment_character, span(bad, bad + 1), cursor_.text[bad]));
    }
    if (is_utf8_ && !grammar_.comment_forbidden.empty()) KADR_TRY(no_mark_inside(cursor_.text, begin + 1, close));
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
    const char first = cursor_.peek();
    if (!is_digit(first) && first != '+' && first != '-' && first != grammar_.parameter_address)
      return fail(alarm(AlarmId::skip_position, span(begin, begin + 1)));
    KADR_TRY(words_.room_for('A', grammar_.word('A'), begin));
    Word& w = block_.words[block_.word_count];
    w.address = w.written = 'A';
    w.expression = {};
    w.code = -1;
    w.incremental = w.bare = false;
    w.value = 0;  // if the word cannot be read, its value remains 0: a caller that continues after the fault may use this value
    WordFormat format = grammar_.word('A');
    format.parameter = true;
    KADR_TRY(words_.value(w, format, begin));
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
    if (grammar_.end_of_block != EndOfBlock::line_only && rest.starts_with("ПC")) return mark_with_latin_letter();
    if (c.code == 0xA0 || c.code == 0xFEFF) {  // a no-break space or a byte order mark has no effect
      cursor_.at += c.bytes;
      return {};
    }
    const char latin = look_alike(c.code);
    if (latin == 0) return fail(alarm(AlarmId::unexpected_character, span(cursor_.at, cursor_.at + c.bytes), rest.substr(0, c.bytes)));
    if (block_.warnings.size() < limits::block_words)
      block_.warnings.push_back(
          warning(AlarmId::look_alike_letter, span(cursor_.at, cursor_.at + c.bytes), rest.substr(0, c.bytes), latin));
    return word(latin, c.bytes);
  }

  /// Accepts an end of block ПС whose С is a Latin C, with a warning.
  Status mark_with_latin_letter() {
    constexpr std::size_t bytes = 3;
    block_.warnings.push_back(warning(AlarmId::mark_letter, span(cursor_.at, cursor_.at + bytes)));
    return end_mark(bytes);
  }

  Status end_by_semicolon() {
    ++cursor_.at;
    done_ = true;
    return {};
  }

  Status end_mark(std::size_t bytes) {
    cursor_.at += bytes;
    result_.marked = true;
    done_ = true;
    cursor_.skip_blanks();
    return {};
  }

  Status unexpected() const { return fail(unexpected_at(cursor_.text, cursor_.at)); }

  /// Returns the alarm for a surplus `]` (nct 23.2.6), or for `=` after a name that the channel does not have, as in Z2=5 (nct 2.2).
  Status out_of_place(char c) {
    const Span where = span(cursor_.at, cursor_.at + 1);
    if (c == ']') return fail(alarm(AlarmId::expression_syntax, where, c));
    const Word* const last = block_.word_count == 0 ? nullptr : &block_.words[block_.word_count - 1];
    if (last == nullptr || last->where.end != cursor_.at) return unexpected();
    return fail(alarm(AlarmId::illegal_address, last->where, block_.text_of(last->where)));
  }

  /// Makes the checks for which the whole block must be known.
  Status whole_block() {
    if (grammar_.block_length != 0 && !grammar_.filtered_lines && !block_.empty()) {
      if (!is_utf8_ && cursor_.at - begin_ > grammar_.block_length && has_high(cursor_.at)) {
        result_.needs_utf8 = true;  // bytes above 127 are decoded first, because only then the characters of the block can be counted
        return {};
      }
      const std::uint32_t length = characters_of(cursor_.text.substr(begin_, cursor_.at - begin_));
      if (length > grammar_.block_length)
        return fail(alarm(AlarmId::block_too_long, span(begin_, cursor_.at), double(length), double(grammar_.block_length)));
    }
    const bool has_words = block_.word_count != 0 || !block_.assignments.empty();
    if (grammar_.block_number_required && has_words && !block_.has_number && block_.marker == Marker::none)
      return fail(alarm(AlarmId::block_number_missing, span(begin_, begin_ + 1)));
    return {};
  }
  bool has_high(std::size_t end) const { return has_high_bytes(cursor_.text.substr(begin_, end - begin_)); }

  char at(std::size_t ahead) const { return cursor_.at + ahead < cursor_.text.size() ? cursor_.text[cursor_.at + ahead] : '\0'; }
  Span span(std::size_t begin, std::size_t end) const {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::min(end, cursor_.text.size()))};
  }

  Cursor cursor_;
  std::size_t begin_;
  bool is_utf8_;
  const Grammar& grammar_;
  Block& block_;
  WordReader words_;
  StatementReader statements_;
  Lexed result_;
  bool done_ = false;
};

}  // namespace

Result<Lexed> lex_block(std::string_view text, std::size_t from, bool is_utf8, const Grammar& grammar, Block& block) {
  if (grammar.klartext_blocks) return lex_klartext_line(text, from, is_utf8, block);
  if (grammar.named_blocks) return lex_named_line(text, from, is_utf8, block);
  return Lexer(text, from, is_utf8, grammar, block).run();
}

}  // namespace kadr
