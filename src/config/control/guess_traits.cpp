// Traits: finds the style of a program's text. Used by config/control/guess; tested by tests/config/guess_test.cpp.

#include "config/control/guess_traits.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/ascii.h"
#include "texts/guess.h"

namespace kadr {
namespace {

constexpr std::array<TraitText, static_cast<std::size_t>(TextTrait::count)> trait_texts = {{
    {"all_numbered", texts::guess::all_numbered},
    {"few_numbered", texts::guess::few_numbered},
    {"decimal_points", texts::guess::decimal_points},
    {"trailing_points", texts::guess::trailing_points},
    {"long_integers", texts::guess::long_integers},
    {"whole_lengths", texts::guess::whole_lengths},
    {"plus_signs", texts::guess::plus_signs},
    {"two_digit_codes", texts::guess::two_digit_codes},
    {"program_number", texts::guess::program_number},
    {"percent", texts::guess::percent},
    {"no_percent", texts::guess::no_percent},
    {"no_tools", texts::guess::no_tools},
    {"without_y", texts::guess::without_y},
    {"u_w_words", texts::guess::u_w_words},
    {"changing_power", texts::guess::changing_power},
    {"feed_everywhere", texts::guess::feed_everywhere},
}};

bool is_program_number(std::string_view line) {
  return line[0] == 'O' && line.size() > 1 && line.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

/// Returns true if the letter at index i is an address: a number follows it, and no letter precedes it.
bool is_address(std::string_view line, std::size_t i) {
  const char next = i + 1 < line.size() ? line[i + 1] : ' ';
  const bool alone = i == 0 || !is_capital(line[i - 1]);
  return alone && (is_digit(next) || std::string_view("+-. [#").find(next) != std::string_view::npos);
}

}  // namespace

const TraitText& text_of(TextTrait trait) { return trait_texts[static_cast<std::size_t>(trait)]; }

void Traits::take(std::string_view line) {
  const bool first = !std::exchange(any_, true);
  if (line[0] == '%') {
    after_percent_ = percent_ = true;
    percent_first_ = percent_first_ || first;
    return;
  }
  if (std::exchange(after_percent_, false) && is_program_number(line)) {
    numbered_program_ = true;
    return;
  }
  ++lines_;
  numbered_ += line[0] == 'N' || line[0] == ':' || line.starts_with("/N");
  points_ += line.find('.') != std::string_view::npos;
  feed_and_power(line.substr(0, line.find(';')));
  for (std::size_t i = 0; i + 1 < line.size(); ++i) letter(line, i);
}

bool Traits::holds(TextTrait trait) const {
  const bool all_numbered = numbered_ == lines_ && lines_ > 0;
  switch (trait) {
    case TextTrait::all_numbered: return all_numbered;
    case TextTrait::few_numbered: return 2 * numbered_ < lines_;
    case TextTrait::decimal_points: return points_ > 0;
    case TextTrait::trailing_points: return trailing_points_ > 0;
    case TextTrait::long_integers: return long_integers_ > 0 && points_ == 0;
    case TextTrait::whole_lengths: return short_lengths_ > 0 && pointed_lengths_ == 0 && long_integers_ == 0;
    case TextTrait::plus_signs: return plus_signs_ > 0 && one_digit_codes_ == 0;
    case TextTrait::two_digit_codes: return all_numbered && two_digit_codes_ > 0 && one_digit_codes_ == 0;
    case TextTrait::program_number: return numbered_program_ && (one_digit_codes_ != 0 || !all_numbered);
    case TextTrait::percent: return percent_first_;
    case TextTrait::no_percent: return !percent_ && lines_ > 0;
    case TextTrait::no_tools: return !tools_ && lines_ > 0;
    case TextTrait::without_y: return x_ && z_ && !y_;
    case TextTrait::u_w_words: return u_or_w_ && !rotary_ && !y_;
    case TextTrait::changing_power: return powers_ >= 3;
    case TextTrait::feed_everywhere: return feed_motions_ >= 4 && 10 * feeds_ >= 9 * feed_motions_;
    case TextTrait::count: break;
  }
  return false;
}

void Traits::feed_and_power(std::string_view line) {
  bool spindle = false, tool = false, motion = false, feed = false, power = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (!is_address(line, i)) continue;
    const std::string_view number = line.substr(i + 1, 2), three = line.substr(i + 1, 3);
    const bool more = three.size() > 2 && is_digit(three[2]);
    const int code = is_digit(number[0]) ? (number[0] - '0') * (number.size() > 1 && is_digit(number[1]) ? 10 : 1) +
                                               (number.size() > 1 && is_digit(number[1]) ? number[1] - '0' : 0)
                                         : -1;
    switch (line[i]) {
      case 'M': spindle = spindle || (!more && (code == 3 || code == 4)), tool = tool || (!more && code == 6); break;
      case 'G': motion = motion || (!more && code >= 1 && code <= 3); break;
      case 'T': tool = true; break;
      case 'H': tools_ = true; break;
      case 'F': feed = true; break;
      case 'S': power = true; break;
      case 'X': x_ = true; break;
      case 'Y': y_ = true; break;
      case 'Z': z_ = true; break;
      case 'U':
      case 'W': u_or_w_ = true; break;
      case 'A':
      case 'B':
      case 'C': rotary_ = true; break;
      default: break;
    }
  }
  tools_ = tools_ || tool;
  powers_ += power && !spindle && !tool;
  feed_motions_ += motion, feeds_ += motion && feed;
}

void Traits::letter(std::string_view line, std::size_t i) {
  const char c = line[i], next = line[i + 1];
  const bool digit_after = i + 2 < line.size() && is_digit(line[i + 2]);
  if ((c == 'G' || c == 'M') && is_digit(next)) ++(digit_after ? two_digit_codes_ : one_digit_codes_);
  if (std::string_view("XYZIJK").find(c) != std::string_view::npos && next == '+' && digit_after) ++plus_signs_;
  // A word in a block with G65 or G66 is an argument, which often is a mere number and not a length, so it is not counted.
  const bool argument = line.find("G65") != std::string_view::npos || line.find("G66") != std::string_view::npos;
  if (!argument && std::string_view("XYZIJKR").find(c) != std::string_view::npos) length(line, i + 1, c == 'X' || c == 'Y' || c == 'Z');
}

/// Counts a length by its form. Four or more digits without a decimal point (`X8000`) suggest increments of 0.001 mm. `X10` may mean 10 mm.
/// `X0` is not counted, because it means the same on all controls.
void Traits::length(std::string_view line, std::size_t at, bool of_axis) {
  if (line[at] == '+' || line[at] == '-') ++at;
  const std::size_t end = std::min(line.find_first_not_of("0123456789", at), line.size());
  if (end < line.size() && line[end] == '.') {
    ++pointed_lengths_;
    trailing_points_ += end > at && (end + 1 == line.size() || !is_digit(line[end + 1]));
  } else if (of_axis && end - at >= 4) {
    ++long_integers_;
  } else if (of_axis && line.substr(at, end - at).find_first_not_of('0') != std::string_view::npos) {
    ++short_lengths_;
  }
}

}  // namespace kadr
