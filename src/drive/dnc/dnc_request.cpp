// Requests of a control, and names of received programs. Used by kadr dnc, tested by tests/drive/dnc_test.cpp.

#include "drive/dnc/dnc_request.h"

#include <algorithm>

namespace kadr::drive {
namespace {

constexpr std::size_t longest_name = 64;

bool is_name_character(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\r')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

/// Calls `use` with each line that is not empty and not `%`, until it returns false.
template <class Use>
void each_block(std::string_view text, Use use) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = trimmed(text.substr(0, end));
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    if (!line.empty() && line != "%" && !use(line)) return;
  }
}

/// Returns the letter and the digits at the beginning of a line: "O1234".
std::string_view number_of(std::string_view line) {
  if (line.empty() || (line.front() != 'O' && line.front() != ':' && line.front() != '%')) return {};
  std::size_t end = 1;
  while (end < line.size() && line[end] >= '0' && line[end] <= '9') ++end;
  return end > 1 ? line.substr(0, end) : std::string_view();
}

}  // namespace

std::optional<std::string> requested_program(std::string_view text) {
  constexpr std::string_view word = "(SEND ";
  std::optional<std::string> name;
  bool is_request = true;
  each_block(text, [&](std::string_view line) {
    line = trimmed(line.substr(number_of(line).size()));
    if (line.empty() || line == "M30" || line == "M02" || line == "M2") return true;
    is_request = !name && line.starts_with(word) && line.back() == ')';
    if (is_request) name = std::string(trimmed(line.substr(word.size(), line.size() - word.size() - 1)));
    return is_request;
  });
  const bool is_right = is_request && name && !name->empty() && name->size() <= longest_name && name->front() != '.' &&
                        std::all_of(name->begin(), name->end(), is_name_character);
  return is_right ? name : std::nullopt;
}

std::string name_of_program(std::string_view text) {
  std::string name = "program";
  each_block(text, [&](std::string_view line) {
    const std::string_view number = number_of(line);
    if (!number.empty()) name = (number.front() == '%' ? "P" : "O") + std::string(number.substr(1, longest_name));
    return false;
  });
  return name;
}

}  // namespace kadr::drive
