// Reads the size of a rectangular blank from a comment. Used by session/cutting/stated_box; tested by tests/lang/box_comment_test.cpp.
//
// A size is three numbers with X between them (120X80X25), or three numbers that the words next to them name (X= Y= Z=, LENGTH, WIDTH,
// HEIGHT). The comment must name a blank. In a comment of several clauses only the clause with the numbers may not be about something else.

#include "lang/text/box_comment.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "base/ascii.h"
#include "lang/text/shop_words.h"
#include "lang/text/stock_numbers.h"

namespace kadr {
namespace {

constexpr double thinnest_blank = 0.1;  // mm; no blank is thinner

class BoxReading {
 public:
  BoxReading(std::string_view text, bool inch)
      : tokens_(comment_tokens(text)), numbers_(stock_numbers(tokens_)), unit_(inch ? inch_in_mm : 1) {
    std::size_t clause = 0;
    for (const CommentToken& t : tokens_) {
      if (t.is == CommentToken::Is::sign && std::string_view(",:;/|").find(t.text) != std::string_view::npos) ++clause;
      clauses_.push_back(clause);
    }
  }

  bool names_blank() const {
    return std::any_of(tokens_.begin(), tokens_.end(),
                       [](const CommentToken& t) { return t.is == CommentToken::Is::word && is_one_of(box_words, t.text); });
  }
  bool has_numbers() const { return !numbers_.empty(); }

  std::optional<BoxComment> size() const {
    if (!names_blank() || numbers_.size() < 3) return std::nullopt;
    auto found = in_row();
    if (!found) found = labelled();
    if (!found) return std::nullopt;
    const bool fits =
        std::all_of(found->size.begin(), found->size.end(), [](double v) { return v >= thinnest_blank && v <= greatest_blank; });
    return fits ? found : std::nullopt;
  }

 private:
  bool is_word(std::size_t i, std::string_view words) const {
    return i < tokens_.size() && tokens_[i].is == CommentToken::Is::word && is_one_of(words, tokens_[i].text);
  }
  bool is_sign(std::size_t i, std::string_view signs) const {
    return i < tokens_.size() && tokens_[i].is == CommentToken::Is::sign && signs.find(tokens_[i].text[0]) != std::string_view::npos;
  }

  bool is_of_others(const StockNumber& number) const {
    for (std::size_t i = 0; i < tokens_.size(); ++i)
      if (clauses_[i] == clauses_[number.first] && is_word(i, not_of_box)) return true;
    return false;
  }

  bool follows(std::size_t k) const {
    if (k >= numbers_.size()) return false;
    const std::size_t sign = numbers_[k - 1].end;
    return numbers_[k].first == sign + 1 && (is_word(sign, box_between_words) || is_sign(sign, "*"));
  }

  /// Three numbers in a row, such as 120X80X25. A unit after the last one counts for all.
  std::optional<BoxComment> in_row() const {
    for (std::size_t k = 0; k + 2 < numbers_.size(); ++k) {
      if (!follows(k + 1) || !follows(k + 2) || follows(k + 3) || (k > 0 && follows(k)) || is_of_others(numbers_[k])) continue;
      const StockNumber& last = numbers_[k + 2];
      BoxComment found;
      for (std::size_t i = 0; i < 3; ++i) found.size[i] = numbers_[k + i].mm(last.unit > 0 ? last.unit : unit_);
      return found;
    }
    return std::nullopt;
  }

  /// Returns 0 for a length or X, 1 for a width or Y, 2 for a height or Z.
  std::optional<std::size_t> axis_at(std::size_t i) const {
    return is_word(i, box_x_words)   ? std::optional<std::size_t>(0)
           : is_word(i, box_y_words) ? std::optional<std::size_t>(1)
           : is_word(i, box_z_words) ? std::optional<std::size_t>(2)
                                     : std::nullopt;
  }

  std::optional<BoxComment> labelled() const {
    BoxComment found;
    std::array<bool, 3> known{};
    std::vector<bool> used(tokens_.size() + 1);  // true: the word belongs to a number
    for (const StockNumber& number : numbers_) {
      std::size_t before = number.first;
      while (before > 0 && is_sign(before - 1, "=:.")) --before;
      const bool is_negative = before > 0 && is_sign(before - 1, "-");
      auto axis = before > 0 && !used[before - 1] ? axis_at(before - 1) : std::nullopt;
      const bool is_before = axis.has_value();
      if (!axis) axis = axis_at(number.end);
      if (!axis) continue;
      used[is_before ? before - 1 : number.end] = true;
      if (is_negative || known[*axis]) return std::nullopt;  // the comment states limits, not a size
      known[*axis] = true;
      found.size[*axis] = number.mm(unit_);
      found.has_axes = found.has_axes || (before > 0 && is_word(before - 1, "X Y Z"));
    }
    return known[0] && known[1] && known[2] ? std::optional(found) : std::nullopt;
  }

  const std::vector<CommentToken> tokens_;
  const std::vector<StockNumber> numbers_;
  std::vector<std::size_t> clauses_;  // for each token, the number of its clause
  const double unit_;                 // mm per unit of a number without a unit
};

/// Reads "STOCK/BLOCK,X,Y,Z,X0,Y0,Z0", the line that CutViewer and its like take: sizes, then the place of the program's zero from the
/// least corner.
std::optional<BoxComment> read_viewer_line(std::string_view text, double unit) {
  constexpr std::string_view begins = "STOCK/BLOCK,";
  std::string line;
  for (const char c : text)
    if (c != ' ') line += to_upper(c);
  if (!line.starts_with(begins)) return std::nullopt;
  std::vector<double> values;
  for (const char *at = line.data() + begins.size(), *const end = line.data() + line.size(); at < end;) {
    double value = 0;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc()) break;
    values.push_back(value * unit);
    at = read.ptr < end && *read.ptr == ',' ? read.ptr + 1 : end;
  }
  if (values.size() < 3 ||
      std::any_of(values.begin(), values.begin() + 3, [](double v) { return !(v >= thinnest_blank && v <= greatest_blank); }))
    return std::nullopt;
  BoxComment found{{values[0], values[1], values[2]}, true, {}};
  if (values.size() >= 6) found.zero = {values[3], values[4], values[5]};
  return found;
}

}  // namespace

std::optional<BoxComment> read_box_comment(std::string_view text, bool inch) {
  if (auto line = read_viewer_line(text, inch ? inch_in_mm : 1)) return line;
  return BoxReading(text, inch).size();
}

bool is_heading_of_box(std::string_view text) {
  const BoxReading reading(text, false);
  return reading.names_blank() && !reading.has_numbers();
}

}  // namespace kadr
