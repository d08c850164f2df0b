// Matches patterns of [guess] in lines of a program. Used by config/control/guess; tested by tests/config/guess_test.cpp.

#include "config/control/guess_pattern.h"

#include <fnmatch.h>

#include <algorithm>
#include <bit>
#include <optional>

#include "base/ascii.h"
#include "config/text_kind.h"

namespace kadr {
namespace {

constexpr std::string_view letters_of_axes = "XYZUVWABC";

std::size_t digits_at(std::string_view text, std::size_t at) {
  return std::min(text.find_first_not_of("0123456789", at), text.size()) - at;
}

/// Returns the number of characters that a class of the pattern (\d, \c, \n, \a, \l) matches at this position; nullopt if it does not
/// match.
std::optional<std::size_t> taken(char sign, std::string_view line, std::size_t at) {
  if (sign == 'd') {
    const std::size_t digits = digits_at(line, at);
    return digits > 0 ? std::optional(digits) : std::nullopt;
  }
  if (at >= line.size()) return std::nullopt;
  if (sign == 'c') return is_digit(line[at]) ? std::optional<std::size_t>(1) : std::nullopt;
  if (sign == 'l') return is_capital(line[at]) ? std::optional<std::size_t>(1) : std::nullopt;
  if (sign == 'a') return letters_of_axes.find(line[at]) != std::string_view::npos ? std::optional<std::size_t>(1) : std::nullopt;
  if (sign != 'n') return line[at] == sign ? std::optional<std::size_t>(1) : std::nullopt;
  const std::size_t end = std::min(line.find_first_not_of("+-.0123456789", at), line.size());
  const bool has_digit = line.substr(at, end - at).find_first_of("0123456789") != std::string_view::npos;
  return has_digit ? std::optional(end - at) : std::nullopt;
}

bool is_class(char sign) { return std::string_view("dcnal").find(sign) != std::string_view::npos; }

/// Returns the end of the match that starts at this position; nullopt if the pattern does not match. The elements of the pattern are
/// matched one after another.
std::optional<std::size_t> end_of_signs(std::string_view line, std::size_t at, std::string_view pattern) {
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '$' && i + 1 == pattern.size()) return at == line.size() ? std::optional(at) : std::nullopt;
    const bool escaped = pattern[i] == '\\' && i + 1 < pattern.size();
    const char sign = escaped ? pattern[++i] : pattern[i];
    if (escaped && sign == '*') {  // \* matches any text; the search tries the shortest match first
      for (std::size_t after = at; after <= line.size(); ++after)
        if (const auto end = end_of_signs(line, after, pattern.substr(i + 1))) return end;
      return std::nullopt;
    }
    const auto size = escaped && is_class(sign)              ? taken(sign, line, at)
                      : at < line.size() && line[at] == sign ? std::optional<std::size_t>(1)
                                                             : std::nullopt;
    if (!size) return std::nullopt;
    at += *size;
  }
  return at;
}

std::optional<std::size_t> end_of(std::string_view line, std::size_t at, std::string_view pattern) {
  if (is_capital(line[at]) && at > 0 && is_capital(line[at - 1])) return std::nullopt;
  const auto end = end_of_signs(line, at, pattern);
  if (!end || !is_digit(pattern.back())) return end;
  const bool more_digits = *end < line.size() && (is_digit(line[*end]) || (line[*end] == '.' && digits_at(line, *end + 1) > 0));
  return more_digits ? std::nullopt : end;
}

/// Removes blanks, a leading `/`, a block number, and leading zeros of G and M codes: "/ N10 G05.1" becomes "G5.1".
std::string squeezed(std::string_view written) {
  std::string text;
  for (const char c : written)
    if (c != ' ' && c != '\t') text += c;
  if (text.starts_with('/')) text.erase(0, 1 + (text.size() > 1 && is_digit(text[1]) ? 1 : 0));
  if (text.starts_with('N') && digits_at(text, 1) > 0) text.erase(0, 1 + digits_at(text, 1));
  for (std::size_t i = 0; i + 2 < text.size(); ++i)
    while ((text[i] == 'G' || text[i] == 'M') && i + 2 < text.size() && text[i + 1] == '0' && is_digit(text[i + 2])) text.erase(i + 1, 1);
  return text;
}

/// Returns the comments of a line: the texts in brackets and after `;`, separated by blanks.
std::string comments_of(std::string_view raw) {
  const std::size_t first = std::min(raw.find_first_not_of(" \t"), raw.size());
  const std::string_view line = raw.substr(first);
  if (line.starts_with("# ") || line.starts_with("//")) return std::string(line);
  std::string text;
  for (std::size_t i = 0, depth = 0; i < line.size(); ++i) {
    if (line[i] == ';' && depth == 0) return text + std::string(line.substr(i + 1));
    if (line[i] == '(' && depth == 0) depth = 1, text += ' ';
    else if (line[i] == ')') depth = 0;
    else if (depth != 0) text += line[i];
  }
  return text;
}

/// Finds the text that matches a pattern with a bracket, such as CYCLE800(, in the words of a line.
std::string_view found_with_bracket(std::string_view raw, std::string_view pattern) {
  // Position of the first word after the block number
  const std::size_t word = std::min(raw.find_first_not_of(" \t0123456789N"), raw.size());
  const bool at_beginning = pattern[0] == '^';
  if (at_beginning) pattern.remove_prefix(1);
  int depth = 0;
  for (std::size_t at = 0; at < raw.size() && raw[at] != ';'; ++at) {
    if (depth == 0 && (!at_beginning || at == word))
      if (const auto end = end_of(raw, at, pattern)) return raw.substr(at, *end - at);
    depth += raw[at] == '(' ? 1 : raw[at] == ')' ? -1 : 0;
  }
  return {};
}

}  // namespace

GuessLine guess_line(std::string_view line) {
  GuessLine forms;
  line = line.substr(0, 1000);  // only the first 1000 characters are searched, because patterns with \* visit each position many times
  for (const char c : bare_line(line))
    if (c != '\t' && (c != ' ' || forms.written.empty() || forms.written.back() != ' ')) forms.written += c;
  forms.squeezed = squeezed(forms.written);
  for (const char c : line)
    if (c != '\r') forms.raw += to_upper(c);
  forms.comments = comments_of(forms.raw);
  return forms;
}

std::string_view found_in(const GuessLine& line, std::string_view pattern) {
  const bool in_comments = pattern.starts_with('(') || pattern.starts_with(';');
  const bool as_written = pattern.find(' ') != std::string_view::npos;
  // A pattern with a bracket, such as CYCLE800(, is searched in the line as written, so that the bracket does not start a comment
  const bool has_bracket = !in_comments && pattern.find('(') != std::string_view::npos;
  if (has_bracket) return found_with_bracket(line.raw, pattern);
  const std::string_view text = in_comments ? line.raw : as_written ? line.written : line.squeezed;
  const bool at_beginning = pattern.size() > 1 && pattern[0] == '^';
  if (at_beginning) pattern.remove_prefix(1);
  if (pattern.empty()) return {};
  const char first = pattern[0];
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (first == '\\' || text[at] == first)
      if (const auto end = end_of(text, at, pattern)) return text.substr(at, *end - at);
    if (at_beginning) break;
  }
  return {};
}

std::string_view found_in_words(std::string_view text, std::string_view pattern) {
  if (pattern.empty()) return {};
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto end = end_of(text, at, pattern);
    if (end && (*end == text.size() || !is_capital(pattern.back()) || !is_capital(text[*end]))) return text.substr(at, *end - at);
  }
  return {};
}

LineSigns signs_of(std::string_view text) {
  LineSigns signs = 0;
  for (const char c : text) signs |= LineSigns{1} << (static_cast<unsigned char>(c) % 64);
  return signs;
}

LineSigns signs_needed(std::string_view pattern) {
  LineSigns signs = 0;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool at_edge = (pattern[i] == '^' && i == 0) || (pattern[i] == '$' && i + 1 == pattern.size());
    if (at_edge || pattern[i] == ' ') continue;  // a tab counts as a blank
    if (pattern[i] != '\\') signs |= signs_of(pattern.substr(i, 1));
    else ++i;
  }
  return signs;
}

std::size_t rarest_sign(LineSigns signs) {
  constexpr std::string_view from_common_on = "01GXYZ.23456789-FNMIJSRTKHPQ";
  std::size_t best = any_sign, rank = 0;
  for (LineSigns rest = signs; rest != 0; rest &= rest - 1) {
    const auto sign = static_cast<std::size_t>(std::countr_zero(rest));
    const auto is_it = [sign](char c) { return static_cast<unsigned char>(c) % any_sign == sign; };
    const auto its = static_cast<std::size_t>(std::find_if(from_common_on.begin(), from_common_on.end(), is_it) - from_common_on.begin());
    if (best == any_sign || its > rank) best = sign, rank = its;
  }
  return best;
}

bool is_named_like(std::string_view path, std::string_view pattern) {
  if (pattern.find('/') == std::string_view::npos) path = path.substr(path.rfind('/') + 1);
  std::string small;
  for (const char c : path) small += to_lower(c);
  return ::fnmatch(std::string(pattern).c_str(), small.c_str(), 0) == 0;
}

}  // namespace kadr
