// Reads the number of teeth of a tool from a comment. This file is used by session/checklist and tested by tests/checklist.py.

#include "session/checklist/comment_teeth.h"

#include <cctype>

namespace kadr {
namespace {

bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool word_at(std::string_view text, std::size_t at, std::string_view word) {
  if (text.size() - at < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (std::toupper(static_cast<unsigned char>(text[at + i])) != word[i]) return false;
  return at + word.size() == text.size() || !letter(text[at + word.size()]);
}

}  // namespace

int teeth_named(std::string_view comment) {
  constexpr int most = 12;
  for (std::size_t i = 0; i < comment.size(); ++i) {
    if (!digit(comment[i]) || (i > 0 && (digit(comment[i - 1]) || letter(comment[i - 1]) || comment[i - 1] == '.'))) continue;
    std::size_t end = i;
    int number = 0;
    while (end < comment.size() && digit(comment[end]) && number <= most) number = number * 10 + (comment[end++] - '0');
    if (end < comment.size() && (comment[end] == ' ' || comment[end] == '-')) ++end;
    for (const std::string_view word : {"FL", "FLT", "FLUTE", "FLUTES", "FLUTED", "TEETH"})
      if (number >= 1 && number <= most && word_at(comment, end, word)) return number;
  }
  return 0;
}

}  // namespace kadr
