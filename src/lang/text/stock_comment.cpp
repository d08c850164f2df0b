// Reads the size of a turned blank from a comment. Used by session/cutting/turning/stated_blank; tested by
// tests/lang/stock_comment_test.cpp.
//
// Each number belongs to the word before it (D50, DIA 50, LENGTH = 80), else to the word after it (4.5OD, 1.3"L); a word belongs to one
// number. A number without such a word is the diameter directly after the name of a bar (BAR 50), or with a unit as the first number (5"
// ALUMINUM BARSTOCK).

#include "lang/text/stock_comment.h"

#include <algorithm>

#include "base/ascii.h"
#include "lang/text/shop_words.h"
#include "lang/text/stock_numbers.h"

namespace kadr {
namespace {

// Comments with these words are about tools, jaws or work, not about the blank.
constexpr std::string_view words_of_others =
    "BORING TURN TURNING FACE FACING JAW JAWS PRESSURE DRILL DRILLING INSERT CUT CUTTER STOP PULL PULLER REMOVE LEAVE TOOL BROACH";

enum class StockSize { unknown, diameter, bore, length };

struct BlankNumber : StockNumber {
  StockSize size = StockSize::unknown;
};

/// Returns the tokens from the clause on that first names a blank: in "HUB, SIX HOLES D8, BLANK D80 L40" those before it are of the part.
std::vector<CommentToken> from_clause_of_blank(std::vector<CommentToken> tokens) {
  std::size_t clause = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const CommentToken& t = tokens[i];
    if (t.is == CommentToken::Is::sign && (t.text == "," || t.text == ":" || t.text == ";")) clause = i + 1;
    if (t.is == CommentToken::Is::word && (is_one_of(stock_bar_words, t.text) || is_one_of(stock_blank_words, t.text))) {
      tokens.erase(tokens.begin(), tokens.begin() + std::ptrdiff_t(clause));
      break;
    }
  }
  return tokens;
}

class StockReading {
 public:
  StockReading(std::string_view text, bool inch)
      : tokens_(from_clause_of_blank(comment_tokens(text))), used_(tokens_.size()), unit_(inch ? inch_in_mm : 1) {
    is_billet_ = is_word(0, "BILLET");
  }

  StockComment sizes() {
    if (!is_of_blank()) return {};
    for (const StockNumber& number : stock_numbers(tokens_)) numbers_.push_back(BlankNumber{number, StockSize::unknown});
    for (BlankNumber& number : numbers_) number.size = labelled(number);
    guess_unlabelled();
    StockComment found;
    for (const BlankNumber& number : numbers_) take(number, found);
    if (found.bore && found.diameter && *found.bore >= *found.diameter) return {};
    return found;
  }

 private:
  bool is_word(std::size_t i, std::string_view words) const {
    return i < tokens_.size() && tokens_[i].is == CommentToken::Is::word && is_one_of(words, tokens_[i].text);
  }
  bool is_sign(std::size_t i, std::string_view signs) const {
    return i < tokens_.size() && tokens_[i].is == CommentToken::Is::sign && signs.find(tokens_[i].text[0]) != std::string_view::npos;
  }
  bool is_figure(std::size_t i) const { return i < tokens_.size() && tokens_[i].is == CommentToken::Is::figure; }

  bool is_of_blank() const {
    bool named = false;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (is_word(i, words_of_others) || (is_word(i, "T") && is_figure(i + 1))) return false;
      named = named || is_word(i, stock_bar_words) || is_word(i, stock_blank_words);
    }
    return named;
  }

  StockSize meaning(std::size_t i) const {
    if (i >= tokens_.size() || used_[i]) return StockSize::unknown;
    if (is_word(i, stock_diameter_words) || (is_billet_ && is_word(i, "X"))) return StockSize::diameter;
    if (is_word(i, stock_bore_words)) return StockSize::bore;
    return is_word(i, stock_length_words) || (is_billet_ && is_word(i, "Z")) ? StockSize::length : StockSize::unknown;
  }

  StockSize labelled(const BlankNumber& number) {
    std::size_t before = number.first;
    while (before > 0 && is_sign(before - 1, "=:.")) --before;
    const std::size_t label = before > 0 && meaning(before - 1) != StockSize::unknown ? before - 1 : number.end;
    const StockSize size = meaning(label);
    if (size != StockSize::unknown) used_[label] = true;
    return size;
  }

  /// Gives a number without a word the size that its place tells. A row of three or more such numbers with X between them is a box.
  void guess_unlabelled() {
    const auto has = [&](StockSize size) {
      return std::any_of(numbers_.begin(), numbers_.end(), [&](const BlankNumber& n) { return n.size == size; });
    };
    if (numbers_.empty() || has(StockSize::diameter)) return;
    const auto follows = [&](std::size_t k) {
      return k < numbers_.size() && numbers_[k].size == StockSize::unknown && is_word(numbers_[k - 1].end, "X") &&
             numbers_[k].first == numbers_[k - 1].end + 1;
    };
    for (std::size_t k = 0; k < numbers_.size(); ++k) {
      BlankNumber& number = numbers_[k];
      if (number.size != StockSize::unknown) continue;
      const bool is_of_bar = number.first > 0 && is_word(number.first - 1, stock_bar_words);
      const bool has_length = follows(k + 1);
      if (!is_of_bar && !(k == 0 && number.unit > 0) && !(has_length && number.first > 0 && is_word(number.first - 1, stock_blank_words)))
        continue;
      if (has_length && follows(k + 2)) return;
      number.size = StockSize::diameter;
      if (has_length && !has(StockSize::length)) numbers_[k + 1].size = StockSize::length;
      return;
    }
  }

  void take(const BlankNumber& number, StockComment& found) const {
    const double value = number.mm(unit_);
    if (!(value > 0 && value <= greatest_blank)) return;
    std::optional<double>* const to = number.size == StockSize::diameter ? &found.diameter
                                      : number.size == StockSize::bore   ? &found.bore
                                      : number.size == StockSize::length ? &found.length
                                                                         : nullptr;
    if (to != nullptr && !*to) *to = value;
  }

  std::vector<CommentToken> tokens_;
  std::vector<bool> used_;  // true: the word belongs to a number
  std::vector<BlankNumber> numbers_;
  double unit_;  // mm per unit of a number without a unit
  bool is_billet_ = false;
};

}  // namespace

StockComment read_stock_comment(std::string_view text, bool inch) { return StockReading(text, inch).sizes(); }

std::string billet_of(std::string_view line) {
  const std::size_t at = line.find_first_not_of(" \t");
  constexpr std::string_view word = "BILLET";
  if (at == std::string_view::npos || line[at] != '[' || line.size() < at + 1 + word.size()) return {};
  for (std::size_t i = 0; i < word.size(); ++i)
    if (to_upper(line[at + 1 + i]) != word[i]) return {};
  return std::string(line.substr(at + 1));
}

}  // namespace kadr
