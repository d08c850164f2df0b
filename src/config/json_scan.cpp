// Checks JSON text before it is parsed. A fault is reported in words, with line and column, and a text that could exhaust the stack or the
// memory is rejected. Used by config/setup/setup; tested by tests/config/json_scan_test.cpp.

#include "config/json_scan.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include "base/ascii.h"
#include "config/read_file.h"
#include "lang/text/encoding.h"
#include "texts/json_faults.h"

namespace kadr {
namespace {

/// Appends a character, given by its Unicode number, as UTF-8.
void append(unsigned code, std::string& to) {
  const auto rest = [&](int shift) { to += static_cast<char>(0x80U | (code >> shift & 0x3FU)); };
  if (code < 0x80) to += static_cast<char>(code);
  else if (code < 0x800) to += static_cast<char>(0xC0U | code >> 6), rest(0);
  else if (code < 0x10000) to += static_cast<char>(0xE0U | code >> 12), rest(6), rest(0);
  else to += static_cast<char>(0xF0U | code >> 18), rest(12), rest(6), rest(0);
}

/// The grammar of RFC 8259, one method per rule. A method returns false if it found a fault.
class JsonScan {
 public:
  JsonScan(std::string_view text, const std::string& file) : text_(text), file_(file) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  std::string run() {
    if (value()) {
      blanks();
      if (at_ < text_.size()) fault(translated(texts::json_faults::behind_end, here()));
    }
    return fault_;
  }

 private:
  bool fault_at(std::size_t at, const std::string& sentence) {
    if (fault_.empty()) fault_ = location_prefix(file_, text_, at) + sentence;
    return false;
  }
  bool fault(const std::string& sentence) { return fault_at(at_, sentence); }

  bool missing(PlainText what) {
    if (at_ >= text_.size()) return fault(translated(texts::json_faults::ends_early, plain_text(what)));
    if (text_[at_] == '/' || text_[at_] == '#') return fault(translated(texts::json_faults::no_comments));
    return fault(translated(texts::json_faults::other_character, here(), plain_text(what)));
  }

  /// Returns the current character in the form in which messages print it.
  std::string here() const {
    const std::string_view rest = text_.substr(at_);
    const std::size_t size = rest.empty() ? 0 : first_character(rest).size;
    if (size == 0 || static_cast<unsigned char>(rest[0]) < ' ') return translated(texts::json_faults::a_control_character);
    return "'" + std::string(rest.substr(0, size)) + "'";
  }

  void blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  bool next_is(char c) {
    blanks();
    return at_ < text_.size() && text_[at_] == c;
  }
  bool taken(char c) { return next_is(c) && (++at_, true); }

  bool value() {
    blanks();
    if (++values_ > limits::json_values) return fault(translated(texts::json_faults::too_many_values, limits::json_values));
    const char c = at_ < text_.size() ? text_[at_] : '\0';
    if (c == '{') return within(&JsonScan::table);
    if (c == '[') return within(&JsonScan::list);
    if (c == '"') return string().has_value();
    if (is_digit(c) || c == '-' || c == '+' || c == '.') return number();
    if (is_letter(c)) return word();
    if (c == '\'') return fault(translated(texts::json_faults::text_in_double_quotes));
    return missing(texts::json_faults::a_value);
  }

  bool within(bool (JsonScan::*read)()) {
    if (depth_ == limits::json_depth) return fault(counted(texts::json_faults::too_deep, limits::json_depth));
    ++depth_, ++at_;
    const bool read_well = (this->*read)();
    --depth_;
    return read_well;
  }

  bool table() {
    std::set<std::string, std::less<>> keys;
    if (taken('}')) return true;
    do {
      blanks();
      const std::size_t at = at_;
      if (next_is('}')) return fault(translated(texts::json_faults::comma_before_brace));
      if (!next_is('"')) return missing(texts::json_faults::a_key);
      const auto key = string();
      if (!key) return false;
      if (!keys.insert(*key).second) return fault_at(at, translated(texts::json_faults::key_twice, *key));
      if (!taken(':')) return missing(texts::json_faults::colon_behind_key);
      if (!value()) return false;
    } while (taken(','));
    return taken('}') || missing(texts::json_faults::comma_or_brace);
  }

  bool list() {
    if (taken(']')) return true;
    do {
      if (next_is(']')) return fault(translated(texts::json_faults::comma_before_bracket));
      if (!value()) return false;
    } while (taken(','));
    return taken(']') || missing(texts::json_faults::comma_or_bracket);
  }

  bool word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '_')) ++at_;
    constexpr std::size_t longest = 40;
    const std::string word(text_.substr(begin, std::min(at_ - begin, longest)));
    if (word == "true" || word == "false" || word == "null") return true;
    if (word == "NaN" || word == "nan" || word == "Infinity" || word == "inf")
      return fault_at(begin, translated(texts::json_faults::no_number, word));
    return fault_at(begin, translated(texts::json_faults::no_value, word));
  }

  bool digits() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    return at_ > begin;
  }

  bool number() {
    const std::size_t begin = at_;
    const auto wrong = [&] {
      while (at_ < text_.size() &&
             (is_digit(text_[at_]) || is_letter(text_[at_]) || text_[at_] == '.' || text_[at_] == '-' || text_[at_] == '+'))
        ++at_;
      constexpr std::size_t longest = 40;
      const std::string written(text_.substr(begin, std::min(at_ - begin, longest)));
      return fault_at(begin, translated(texts::json_faults::number_form, written));
    };
    if (text_[at_] == '-') ++at_;
    const std::size_t first = at_;
    if (!digits() || (text_[first] == '0' && at_ > first + 1)) return wrong();
    if (at_ < text_.size() && text_[at_] == '.' && (++at_, !digits())) return wrong();
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      if (!digits()) return wrong();
    }
    if (at_ < text_.size() && (is_letter(text_[at_]) || text_[at_] == '.')) return wrong();
    double value = 0;
    const auto read = std::from_chars(text_.data() + begin, text_.data() + at_, value);
    const bool tiny = read.ec == std::errc::result_out_of_range && text_.substr(begin, at_ - begin).find("e-") != std::string_view::npos;
    if (read.ec == std::errc() || tiny) return true;
    constexpr std::size_t longest = 40;
    const std::string written(text_.substr(begin, std::min(at_ - begin, longest)));
    return fault_at(begin, translated(texts::json_faults::number_too_great, written));
  }

  /// Returns the characters of a string, with escapes decoded.
  std::optional<std::string> string() {
    std::string content;
    const std::size_t begin = at_++;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"') {
        ++at_;
        return content;
      }
      if (static_cast<unsigned char>(c) < ' ') {
        fault(translated(texts::json_faults::control_character_in_text));
        return std::nullopt;
      }
      if (c == '\\') {
        if (!escape(content)) return std::nullopt;
        continue;
      }
      const std::size_t size = first_character(text_.substr(at_)).size;
      if (size == 0) {
        fault(translated(texts::json_faults::no_utf_8));
        return std::nullopt;
      }
      content += text_.substr(at_, size);
      at_ += size;
    }
    fault_at(begin, translated(texts::json_faults::no_closing_quote));
    return std::nullopt;
  }

  bool escape(std::string& content) {
    constexpr std::string_view known = "\"\\/bfnrt", means = "\"\\/\b\f\n\r\t";
    const char c = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
    if (const std::size_t which = known.find(c); c != '\0' && which != std::string_view::npos) {
      content += means[which];
      at_ += 2;
      return true;
    }
    const std::size_t begin = at_;
    const int first = unit();
    const bool high = first >= 0xD800 && first < 0xDC00, low = first >= 0xDC00 && first < 0xE000;
    const int second = high ? unit() : 0;
    if (first < 0 || low || (high && (second < 0xDC00 || second >= 0xE000)))
      return fault_at(begin, translated(texts::json_faults::unknown_escape));
    append(high ? 0x10000U + (static_cast<unsigned>(first - 0xD800) << 10) + static_cast<unsigned>(second - 0xDC00)
                : static_cast<unsigned>(first),
           content);
    return true;
  }

  /// Reads one escape \uXXXX and returns its UTF-16 code unit; -1 if there is no such escape at the current position.
  int unit() {
    int value = 0;
    if (text_.substr(at_, 2) != "\\u" || at_ + 6 > text_.size()) return -1;
    const auto read = std::from_chars(text_.data() + at_ + 2, text_.data() + at_ + 6, value, 16);
    if (read.ec != std::errc() || read.ptr != text_.data() + at_ + 6 || text_[at_ + 2] == '-') return -1;
    at_ += 6;
    return value;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0, depth_ = 0, values_ = 0;
  std::string fault_;
};

}  // namespace

std::string json_fault_message(std::string_view text, const std::string& file) {
  if (std::string fault = no_text_message(text, file); !fault.empty()) return fault;
  return JsonScan(text, file).run();
}

}  // namespace kadr
