// Reads the numbers of a comment about a blank. Used by lang/text/stock_comment and lang/text/box_comment; tested by
// tests/lang/stock_comment_test.cpp.

#include "lang/text/stock_numbers.h"

#include "lang/text/shop_words.h"

namespace kadr {
namespace {

class NumberReader {
 public:
  explicit NumberReader(const std::vector<CommentToken>& tokens) : tokens_(tokens) {}

  std::vector<StockNumber> all() const {
    std::vector<StockNumber> numbers;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (!is_figure(i) || tokens_[i].is_broken) continue;
      numbers.push_back(from(i));
      i = numbers.back().end - 1;
    }
    return numbers;
  }

 private:
  bool is_word(std::size_t i, std::string_view words) const {
    return i < tokens_.size() && tokens_[i].is == CommentToken::Is::word && is_one_of(words, tokens_[i].text);
  }
  bool is_sign(std::size_t i, std::string_view sign) const {
    return i < tokens_.size() && tokens_[i].is == CommentToken::Is::sign && tokens_[i].text == sign;
  }
  bool is_figure(std::size_t i) const { return i < tokens_.size() && tokens_[i].is == CommentToken::Is::figure; }

  StockNumber from(std::size_t i) const {
    StockNumber number{tokens_[i].value, 0, i, i + 1};
    bool in_inches = tokens_[i].is_fraction;
    const std::size_t next = is_sign(i + 1, "-") ? i + 2 : i + 1;
    if (is_figure(next) && tokens_[next].is_fraction && !in_inches)
      number.value += tokens_[next].value, number.end = next + 1, in_inches = true;
    if (is_sign(number.end, "\"") || is_word(number.end, "IN INCH INCHES")) in_inches = true, ++number.end;
    const bool in_mm = !in_inches && is_word(number.end, shop_mm);
    if (in_mm) ++number.end;
    if (in_inches) number.value *= inch_in_mm;
    number.unit = in_inches ? inch_in_mm : in_mm ? 1 : 0;
    return number;
  }

  const std::vector<CommentToken>& tokens_;
};

}  // namespace

std::vector<StockNumber> stock_numbers(const std::vector<CommentToken>& tokens) { return NumberReader(tokens).all(); }

bool is_one_of(std::string_view words, std::string_view word) {
  if (word.empty()) return false;
  for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

}  // namespace kadr
