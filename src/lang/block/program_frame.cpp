// Finds the record marks % of a program, and the text that is skipped before the program (spec/fanuc 1.1, label skip). Used by
// lang/block/block_reader, control/macro_b/programs/program_search; tested by tests/cases/fanuc/programs.cases.

#include "lang/block/program_frame.h"

#include <algorithm>
#include <memory>

#include "lang/block/lexer.h"

namespace kadr {
namespace {

bool is_empty(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

/// Returns the first line at or after the offset `at` that is not empty; an empty line if all lines are empty.
std::string_view first_line(std::string_view text, std::size_t& at) {
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    if (!is_empty(line)) return line;
    at = end + 1;
  }
  return {};
}

bool is_block(std::string_view line, const Grammar& grammar) {
  const auto block = std::make_unique<Block>();
  const std::string_view text = line.substr(0, line.find_last_not_of(" \t\r") + 1);
  return lex_block(text, 0, false, grammar, *block).has_value();
}

/// Returns the first line that has more than a comment; an empty line if no line has.
std::string_view after_comments(std::string_view sample, std::size_t& at) {
  std::string_view line = first_line(sample, at);
  while (!line.empty() && line[line.find_first_not_of(" \t\r")] == '(' && line[line.find_last_not_of(" \t\r")] == ')') {
    at = std::min(sample.find('\n', at), sample.size() - 1) + 1;
    line = first_line(sample, at);
  }
  return line;
}

}  // namespace

bool has_sign(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first != std::string_view::npos && line[first] == '%';
}

ProgramFrame frame_of(std::string_view sample, const Grammar& grammar) {
  std::size_t at = sample.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const std::string_view first = first_line(sample, at);
  if (first.empty()) return {};
  if (has_sign(first)) return {0, at};
  std::size_t sign = at;
  if (has_sign(after_comments(sample, sign))) {
    std::size_t after = std::min(sample.find('\n', sign), sample.size() - 1) + 1;
    return first_line(sample, after).empty() ? ProgramFrame() : ProgramFrame{sign, sign};
  }
  if (is_block(first, grammar)) return {};
  while (at < sample.size()) {
    at = std::min(sample.find('\n', at), sample.size() - 1) + 1;
    if (at == sample.size() || !has_sign(sample.substr(at, std::min(sample.find('\n', at), sample.size()) - at))) continue;
    std::size_t after = std::min(sample.find('\n', at), sample.size() - 1) + 1;
    if (first_line(sample, after).empty()) return {};  // no line follows this %, so this sign ends the program and does not start one
    return {at, at};
  }
  return {};
}

}  // namespace kadr
