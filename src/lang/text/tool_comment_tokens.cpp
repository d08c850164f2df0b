// Splits a comment into words, numbers (in the code: figures) and signs. Used by lang/text/tool_comment; tested by
// tests/lang/tool_comment_test.cpp.

#include "lang/text/tool_comment_tokens.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "base/ascii.h"

namespace kadr {
namespace {

struct SignSpelling {
  std::string_view written, meant;
};
/// The different spellings of a sign, each with the spelling that replaces it.
constexpr std::array<SignSpelling, 17> sign_spellings = {{
    {"Ø", " DIA "},
    {"ø", " DIA "},
    {"⌀", " DIA "},
    {"×", " X "},
    {"°", " DEG "},
    {"º", " DEG "},
    {"–", "-"},
    {"—", "-"},
    {"−", "-"},
    {"″", "\""},
    {"”", "\""},
    {"“", "\""},
    {"''", "\""},
    {"«", "\""},
    {"»", "\""},
    {"’", "'"},
    {"№", "#"},
}};

std::string with_signs_made_alike(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto* const found = std::find_if(sign_spellings.begin(), sign_spellings.end(),
                                           [&](const SignSpelling& a) { return text.substr(i, a.written.size()) == a.written; });
    out += found == sign_spellings.end() ? text.substr(i, 1) : found->meant;
    i += found == sign_spellings.end() ? 1 : found->written.size();
  }
  return out;
}

/// Converts a text to capitals, also Russian and Western letters (UTF-8: а…п are D0 B0…BF, р…я D1 80…8F, ё D1 91, à…þ C3 A0…BE).
std::string capitals(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    text[i] = to_upper(text[i]);
    if (i + 1 >= text.size()) continue;
    const auto next = static_cast<unsigned char>(text[i + 1]);
    if (c == 0xD0 && next >= 0xB0 && next <= 0xBF) text[i + 1] = static_cast<char>(next - 0x20);
    if (c == 0xD1 && next >= 0x80 && next <= 0x8F) text[i] = static_cast<char>(0xD0), text[i + 1] = static_cast<char>(next + 0x20);
    if (c == 0xC3 && next >= 0xA0 && next <= 0xBE && next != 0xB7) text[i + 1] = static_cast<char>(next - 0x20);
    if (c == 0xD1 && next == 0x91) text[i] = static_cast<char>(0xD0), text[i + 1] = static_cast<char>(0x81);
  }
  return text;
}

bool is_word_letter(char c) { return is_capital(c) || is_high(c); }

class Tokens {
 public:
  explicit Tokens(std::string text) : text_(std::move(text)) {}

  std::vector<CommentToken> all() {
    while (at_ < text_.size()) take();
    return std::move(tokens_);
  }

 private:
  char at(std::size_t i) const { return i < text_.size() ? text_[i] : ' '; }

  void take() {
    const char c = text_[at_];
    const bool leads_point = (c == '.' || c == ',') && is_digit(at(at_ + 1));
    const bool abbreviates =
        leads_point && c == '.' && joined_ && at(digits_from(at_ + 1)) == '.' && is_digit(at(digits_from(at_ + 1) + 1));
    // R0,5 is one number with a decimal comma; in "D8,.5" and "A,5" the comma separates two tokens.
    const bool comma_divides = c == ',' && joined_;
    if (is_digit(c) || (leads_point && !comma_divides && !abbreviates)) return figure();
    if (is_word_letter(c)) return word();
    ++at_;
    if (c == '_') underscored_ = true;
    if (c == '_' || c <= ' ') {
      joined_ = false;
      underscored_ = underscored_ && c == '_';
      return;
    }
    add({CommentToken::Is::sign, std::string(1, c)});
  }

  void add(CommentToken token) {
    token.joined = joined_, token.underscored = underscored_;
    tokens_.push_back(std::move(token));
    joined_ = true, underscored_ = false;
  }

  /// Reads a word, which is a sequence of letters. It may have points between single letters (E.M.), or an apostrophe between letters
  /// (C'BORE).
  void word() {
    const std::size_t from = at_;
    const auto goes_on = [&] {
      const char c = at(at_);
      const bool abbreviates = c == '.' && is_capital(at(at_ - 1)) && (at_ - from == 1 || at(at_ - 2) == '.');
      return is_word_letter(c) || ((abbreviates || c == '\'') && is_capital(at(at_ + 1)) && !is_digit(at(at_ + 2)));
    };
    while (goes_on()) ++at_;
    add({CommentToken::Is::word, text_.substr(from, at_ - from)});
  }

  std::size_t digits_from(std::size_t i) const {
    while (is_digit(at(i))) ++i;
    return i;
  }

  void figure() {
    CommentToken token{CommentToken::Is::figure, {}};
    const std::size_t from = at_;
    at_ = digits_from(at_);
    if (at(at_) == '/' && is_digit(at(at_ + 1))) return fraction(from, token);
    const bool is_point = at(at_) == '.' || (at(at_) == ',' && is_digit(at(at_ + 1)));
    if (is_point) {
      token.has_point = true, token.leads_point = at_ == from;
      const std::size_t point = at_;
      at_ = digits_from(point + 1);
      token.decimals = static_cast<std::uint8_t>(std::min<std::size_t>(at_ - point - 1, 255));
    }
    // A text with two points, such as 1.2.3, is not a number.
    while (is_point && at(at_) == '.' && is_digit(at(at_ + 1))) token.is_broken = true, at_ = digits_from(at_ + 1);
    token.text = text_.substr(from, at_ - from);
    std::string digits = token.text;
    std::replace(digits.begin(), digits.end(), ',', '.');
    std::from_chars(digits.data(), digits.data() + digits.size(), token.value);
    add(std::move(token));
  }

  /// Reads a fraction such as 3/8. A date such as 3/8/24 is not a fraction.
  void fraction(std::size_t from, CommentToken& token) {
    double numerator = 0, denominator = 0;
    std::from_chars(text_.data() + from, text_.data() + at_, numerator);
    const std::size_t below = at_ + 1;
    at_ = digits_from(below);
    std::from_chars(text_.data() + below, text_.data() + at_, denominator);
    constexpr std::array<double, 6> of_rulers = {2, 4, 8, 16, 32, 64};
    const bool is_of_ruler = std::find(of_rulers.begin(), of_rulers.end(), denominator) != of_rulers.end();
    token.is_fraction = is_of_ruler && numerator > 0 && numerator < denominator;
    while (at(at_) == '/' && is_digit(at(at_ + 1))) token.is_fraction = false, at_ = digits_from(at_ + 1);
    token.is_broken = !token.is_fraction;
    if (token.is_fraction) token.value = numerator / denominator;
    token.text = text_.substr(from, at_ - from);
    add(std::move(token));
  }

  std::string text_;
  std::size_t at_ = 0;
  std::vector<CommentToken> tokens_;
  bool joined_ = false, underscored_ = false;
};

}  // namespace

std::vector<CommentToken> comment_tokens(std::string_view text) { return Tokens(capitals(with_signs_made_alike(text))).all(); }

}  // namespace kadr
