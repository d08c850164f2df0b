// Finds the operators and functions of a control. Used by lang/expression/expression_compiler, filled by the loader of control files;
// tested by tests/lang/expression_rules_test.cpp.

#include "lang/expression/expression_rules.h"

#include <algorithm>

#include "base/ascii.h"

namespace kadr {
namespace {

bool begins_with(std::string_view text, std::string_view word) {
  return text.size() >= word.size() &&
         std::equal(word.begin(), word.end(), text.begin(), [](char wanted, char written) { return wanted == to_upper(written); });
}

/// Returns the number of letters that are the same at the beginning of the text and of the word.
std::size_t alike(std::string_view text, std::string_view word) {
  std::size_t i = 0;
  while (i < text.size() && i < word.size() && to_upper(text[i]) == word[i]) ++i;
  return i;
}

}  // namespace

const ExpressionRow* ExpressionRows::find_short(std::string_view text, std::size_t& length) const {
  const ExpressionRow* best = find(text);
  length = best == nullptr ? 0 : best->text.size();
  if (best != nullptr) return best;
  constexpr std::size_t least = 2;
  for (const ExpressionRow& row : rows_)
    if (const std::size_t same = alike(text, row.text); is_letter(row.text[0]) && same >= least && same > length)
      best = &row, length = same;
  return best;
}

void ExpressionRows::add(ExpressionRow row) {
  rows_.push_back(std::move(row));
  std::stable_sort(rows_.begin(), rows_.end(), [](const ExpressionRow& a, const ExpressionRow& b) {
    return a.text[0] != b.text[0] ? a.text[0] < b.text[0] : a.text.size() > b.text.size();
  });
  first_.fill(0);
  for (std::size_t i = rows_.size(); i-- > 0;) first_[static_cast<unsigned char>(rows_[i].text[0])] = static_cast<std::uint8_t>(i + 1);
}

bool ExpressionRows::has(std::string_view text) const {
  return std::any_of(rows_.begin(), rows_.end(), [&](const ExpressionRow& row) { return row.text == text; });
}

bool ExpressionRows::compare() const {
  return std::any_of(rows_.begin(), rows_.end(), [](const ExpressionRow& row) { return row.binding > 0 && is_comparison(row.op); });
}

const ExpressionRow* ExpressionRows::find(std::string_view text) const {
  if (text.empty()) return nullptr;
  const auto c = static_cast<unsigned char>(to_upper(text[0]));
  if (c >= first_.size() || first_[c] == 0) return nullptr;
  for (std::size_t i = first_[c] - 1u; i < rows_.size() && rows_[i].text[0] == static_cast<char>(c); ++i)
    if (begins_with(text, rows_[i].text)) return &rows_[i];
  return nullptr;
}

}  // namespace kadr
