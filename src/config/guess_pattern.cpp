// For config/guess; tested by tests/config/guess_test.cpp.

#include "config/guess_pattern.h"

#include <algorithm>
#include <optional>

#include "base/ascii.h"
#include "config/text_kind.h"

namespace kadr {
namespace {

constexpr std::string_view letters_of_axes = "XYZUVWABC";

std::size_t digits_at(std::string_view text, std::size_t at) {
  return std::min(text.find_first_not_of("0123456789", at), text.size()) - at;
}

/// How many characters a sign of a pattern takes there; nothing: it does not stand there.
std::optional<std::size_t> taken(char sign, std::string_view line, std::size_t at) {
  if (sign == 'd') {
    const std::size_t digits = digits_at(line, at);
    return digits > 0 ? std::optional(digits) : std::nullopt;
  }
  if (at >= line.size()) return std::nullopt;
  if (sign == 'c') return is_digit(line[at]) ? std::optional<std::size_t>(1) : std::nullopt;
  if (sign == 'a') return letters_of_axes.find(line[at]) != std::string_view::npos ? std::optional<std::size_t>(1) : std::nullopt;
  if (sign != 'n') return line[at] == sign ? std::optional<std::size_t>(1) : std::nullopt;
  const std::size_t end = std::min(line.find_first_not_of("+-.0123456789", at), line.size());
  const bool has_digit = line.substr(at, end - at).find_first_of("0123456789") != std::string_view::npos;
  return has_digit ? std::optional(end - at) : std::nullopt;
}

/// Where what the pattern says ends, if it stands there.
std::optional<std::size_t> end_of(std::string_view line, std::size_t at, std::string_view pattern) {
  const std::size_t begin = at;
  if (is_capital(line[at]) && at > 0 && is_capital(line[at - 1])) return std::nullopt;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '$' && i + 1 == pattern.size()) return at == line.size() ? std::optional(at) : std::nullopt;
    const bool escaped = pattern[i] == '\\' && i + 1 < pattern.size();
    const char sign = escaped ? pattern[++i] : pattern[i];
    const bool is_class = escaped && (sign == 'd' || sign == 'c' || sign == 'n' || sign == 'a');
    const auto size = is_class                               ? taken(sign, line, at)
                      : at < line.size() && line[at] == sign ? std::optional<std::size_t>(1)
                                                             : std::nullopt;
    if (!size) return std::nullopt;
    at += *size;
  }
  const bool more_digits = at < line.size() && (is_digit(line[at]) || (line[at] == '.' && digits_at(line, at + 1) > 0));
  return at > begin && is_digit(pattern.back()) && more_digits ? std::nullopt : std::optional(at);
}

/// G05.1 → G5.1; what stands behind `/` and N10.
std::string squeezed(std::string_view written) {
  std::string text;
  for (const char c : written)
    if (c != ' ' && c != '\t') text += c;
  if (text.starts_with('/')) text.erase(0, 1 + (text.size() > 1 && is_digit(text[1]) ? 1 : 0));
  if (text.starts_with('N')) text.erase(0, 1 + digits_at(text, 1));
  for (std::size_t i = 0; i + 2 < text.size(); ++i)
    while ((text[i] == 'G' || text[i] == 'M') && i + 2 < text.size() && text[i + 1] == '0' && is_digit(text[i + 2])) text.erase(i + 1, 1);
  return text;
}

}  // namespace

GuessLine guess_line(std::string_view line) {
  GuessLine forms;
  for (const char c : bare_line(line))
    if (c != '\t' && (c != ' ' || forms.written.empty() || forms.written.back() != ' ')) forms.written += c;
  forms.squeezed = squeezed(forms.written);
  for (const char c : line)
    if (c != '\r') forms.raw += to_upper(c);
  return forms;
}

std::string_view found_in(const GuessLine& line, std::string_view pattern) {
  const bool in_comments = pattern.starts_with('(') || pattern.starts_with(';');
  const bool as_written = pattern.find(' ') != std::string_view::npos;
  const std::string_view text = in_comments ? line.raw : as_written ? line.written : line.squeezed;
  const bool at_beginning = pattern.starts_with('^');
  if (at_beginning) pattern.remove_prefix(1);
  if (pattern.empty()) return {};
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (const auto end = end_of(text, at, pattern)) return text.substr(at, *end - at);
    if (at_beginning) break;
  }
  return {};
}

}  // namespace kadr
