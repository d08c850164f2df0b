// Reads the small text format for contours of docs/commands/mill.md, one element per line:
//   from X Y | line X Y [open] | arc X Y I J cw|ccw [open] | close [open] | circle X Y R [open]     # comment

#include <fast_float/fast_float.h>

#include <array>
#include <optional>

#include "config/drawing/drawing.h"

namespace kadr {
namespace {

constexpr std::size_t max_words = 7;

struct Words {
  std::array<std::string_view, max_words> word;
  std::array<std::uint32_t, max_words> at{};
  std::size_t count = 0;
};

std::optional<double> number(std::string_view word) {
  double value = 0;
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = fast_float::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

class TextReader {
 public:
  DrawingResult read(std::string_view text) {
    for (std::uint32_t line = 1; !text.empty(); ++line) {
      const std::size_t end = text.find('\n');
      edges_.at(line);
      if (const auto wrong = take(text.substr(0, end))) return drawing_fault(line, *wrong);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return edges_.take();
  }

 private:
  static Words split(std::string_view line) {
    Words words;
    line = line.substr(0, line.find('#'));
    for (std::size_t i = 0; i < line.size() && words.count < max_words;) {
      i = line.find_first_not_of(" \t\r", i);
      if (i == std::string_view::npos) break;
      const std::size_t end = std::min(line.find_first_of(" \t\r", i), line.size());
      words.at[words.count] = static_cast<std::uint32_t>(i);
      words.word[words.count++] = line.substr(i, end - i);
      i = end;
    }
    return words;
  }

  static Alarm syntax(const Words& words, std::size_t i) {
    if (i >= words.count) return alarm(AlarmId::contour_word_missing, {}, words.word[0]);
    const auto size = static_cast<std::uint32_t>(words.word[i].size());
    return alarm(AlarmId::contour_syntax, {words.at[i], words.at[i] + size}, words.word[i]);
  }

  /// Reads one line: the first word, the numbers after it, then the words after the numbers.
  std::optional<Alarm> take(std::string_view line) {
    Words words = split(line);
    if (words.count == 0) return std::nullopt;
    edges_.open(words.count > 1 && words.word[words.count - 1] == "open");
    if (words.word[words.count - 1] == "open") --words.count;
    const std::string_view what = words.word[0];
    const std::size_t numbers = what == "from" || what == "line" ? 2 : what == "arc" ? 4 : what == "circle" ? 3 : 0;
    if (numbers == 0 && what != "close") return syntax(words, 0);
    std::array<double, 4> value{};
    for (std::size_t i = 0; i < numbers; ++i) {
      const auto read = i + 1 < words.count ? number(words.word[i + 1]) : std::nullopt;
      if (!read) return syntax(words, i + 1);
      value[i] = *read;
    }
    const std::size_t rest = what == "arc" ? numbers + 2 : numbers + 1;
    if (words.count != rest) return syntax(words, std::min(words.count, rest));
    return add(what, value, words);
  }

  std::optional<Alarm> add(std::string_view what, const std::array<double, 4>& value, const Words& words) {
    const Vec2 to{value[0], value[1]};
    if (what == "circle") {
      edges_.arc(to, value[2], 0, 360);
      return std::nullopt;
    }
    if (what == "from") at_ = first_ = to;
    else if (!at_) return alarm(AlarmId::contour_word_missing, {}, "from");
    else if (what == "line") edges_.line(*at_, to);
    else if (what == "close") edges_.line(*at_, first_);
    else {
      const std::string_view turn = words.word[5];
      if (turn != "cw" && turn != "ccw") return syntax(words, 5);
      edges_.arc_between(*at_, to, {value[2], value[3]}, turn == "ccw");
      if (const double off = length(*at_ - Vec2{value[2], value[3]}) - length(to - Vec2{value[2], value[3]}); !(std::abs(off) < radius_off))
        return alarm(AlarmId::contour_radius, {}, std::abs(off));
    }
    at_ = what == "close" ? first_ : to;
    return std::nullopt;
  }

  static constexpr double radius_off = 0.01;  // greatest difference of the radii at both ends of an arc, mm; the limit of the controls

  EdgeList edges_;
  std::optional<Vec2> at_;
  Vec2 first_;
};

}  // namespace

DrawingResult read_drawing_text(std::string_view text) { return TextReader().read(text); }

}  // namespace kadr
