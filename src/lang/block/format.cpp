// Reads format descriptors, such as `%: / DS N04 3G2 X+053 Y+053 Z+042 F031 S04 T05 M2*` (spec/gost 3, spec/s2c42 2). Used by
// config/control/control_loader_codes, config/control/control_loader_words; tested by tests/lang/format_test.cpp.

#include "lang/block/format.h"

#include <algorithm>

#include "base/ascii.h"
#include "lang/text/end_mark.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

constexpr std::string_view decimal_sign = "DS";
// Addresses of codes; G0, G01 and M2 are all accepted, whatever the format requires about leading zeros.
constexpr std::string_view code_letters = "GM";
// addresses whose number has no fraction, even if the descriptor allows decimal points (DS)
constexpr std::string_view without_point = "NGM";

bool holds(std::string_view letters, char letter) { return letters.find(letter) != std::string_view::npos; }

Failed not_understood(std::string_view piece, std::string_view reason) {
  return Failed("format \"" + std::string(piece) + "\" is not understood: " + std::string(reason));
}

bool take(std::string_view& text, std::string_view piece) {
  if (!text.starts_with(piece)) return false;
  text.remove_prefix(piece.size());
  return true;
}

bool take_sign(std::string_view& text) { return take(text, "+") || take(text, "±"); }

/// Returns the length in bytes of a word's format at the start of the text: an optional sign, star and digits.
std::size_t format_size(std::string_view text) {
  std::string_view rest = text;
  if (!take_sign(rest)) take(rest, "-");
  if (rest.size() > 1 && rest[0] == '*' && is_digit(rest[1])) rest.remove_prefix(1);
  while (!rest.empty() && is_digit(rest[0])) rest.remove_prefix(1);
  return text.size() - rest.size();
}

/// Reads a descriptor part by part and sets the grammar accordingly.
class Descriptor {
 public:
  Descriptor(std::string_view text, Grammar& grammar)
      : rest_(text), point_(text.find(decimal_sign) != std::string_view::npos), grammar_(grammar) {}

  tl::expected<void, std::string> apply() {
    while (skip_blanks()) {
      if (ended_) return not_understood(rest_, "nothing may follow the end of block");
      if (take(rest_, "%")) {
        grammar_.percent_ignored = false;
      } else if (take(rest_, ":")) {
        grammar_.main_blocks = true;
      } else if (take(rest_, "*") || take(rest_, "LF") || take(rest_, end_mark_in_text)) {
        ended_ = true;
        grammar_.end_of_block = EndOfBlock::line;
        grammar_.mark_everywhere = true;
      } else if (!take(rest_, "/") && !take(rest_, decimal_sign)) {
        if (auto word = apply_word(); !word) return word;
      }
    }
    return {};
  }

 private:
  bool skip_blanks() {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t')) rest_.remove_prefix(1);
    return !rest_.empty();
  }

  /// Reads a part such as `3G2`: the count of words, the letter, the format.
  tl::expected<void, std::string> apply_word() {
    const std::string_view piece = rest_.substr(0, rest_.find_first_of(" \t"));
    const bool counted = is_digit(rest_[0]);
    const auto count = static_cast<std::uint8_t>(counted ? rest_[0] - '0' : 0);
    if (counted) rest_.remove_prefix(1);
    if (counted && count == 0) return not_understood(piece, "a count is 1 to 9");
    if (rest_.empty() || !is_capital(rest_[0])) return not_understood(piece, "an address is a letter A to Z");
    const char letter = rest_[0];
    if (holds(seen_, letter)) return not_understood(piece, "the address stands twice");
    seen_ += letter;
    const std::size_t size = format_size(rest_.substr(1));
    auto format = parse_word_format(rest_.substr(1, size), point_);
    if (!format) return not_understood(piece, format.error());
    // The descriptor N043G2 has this error: its N has digits for a fraction.
    if (letter == 'N' && format->implied) return not_understood(piece, "a block number has no fraction");
    rest_.remove_prefix(1 + size);
    set(letter, *format, count);
    return {};
  }

  /// Sets the format of a word. Properties that a descriptor cannot express remain: a second number, parameters, a count that is not
  /// written.
  void set(char letter, WordFormat format, std::uint8_t count) {
    WordFormat& word = grammar_.word(letter);
    format.at_most = count > 0 ? count : word.at_most;
    format.second_number = word.second_number;
    format.parameter = word.parameter;
    if (holds(without_point, letter)) format.point = false;
    if (holds(code_letters, letter)) {
      if (!format.drop_zeros) format.code_digits = format.whole_digits;
      format.code = format.drop_zeros = true;
    }
    word = format;
  }

  std::string_view rest_;
  bool point_;
  Grammar& grammar_;
  std::string seen_;
  bool ended_ = false;
};

}  // namespace

tl::expected<WordFormat, std::string> parse_word_format(std::string_view digits, bool point) {
  WordFormat format;
  format.known = true;
  format.point = point;
  format.sign = take_sign(digits);
  // INFERRED: the star in T*2 stands for an additional digit, which the note on T*2 mentions (2С42 6.2)
  const bool one_more = take(digits, "*");
  if (digits.starts_with('-')) return Failed("a sign is written + or ±");
  format.drop_zeros = take(digits, "0");
  if (digits.empty() || digits.size() > 2) return Failed("one or two digits say how many stand before and after the point");
  if (!std::all_of(digits.begin(), digits.end(), is_digit)) return Failed("only digits may follow");
  if (digits[0] == '0') return Failed("at least one digit stands before the point");
  format.one_more = one_more;
  format.whole_digits = static_cast<std::uint8_t>(digits[0] - '0' + (one_more ? 1 : 0));
  if (digits.size() == 2) format.fraction_digits = static_cast<std::uint8_t>(digits[1] - '0');
  format.implied = format.fraction_digits > 0;
  return format;
}

tl::expected<void, std::string> apply_descriptor(std::string_view descriptor, Grammar& grammar) {
  Grammar changed = grammar;  // a copy is changed, because a faulty descriptor must change nothing
  auto applied = Descriptor(descriptor, changed).apply();
  if (applied) grammar = changed;
  return applied;
}

}  // namespace kadr
