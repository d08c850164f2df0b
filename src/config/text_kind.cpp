// Classifies text files as programs, prose or no text. Used by config/control/guess and cli/job/program_files; tested by
// tests/config/guess_test.cpp.

#include "config/text_kind.h"

#include <algorithm>
#include <array>

#include "base/ascii.h"

namespace kadr {
namespace {

constexpr int lines_looked_at = 500;

/// Words of several letters that occur in programs of the supported controls.
constexpr std::array<std::string_view, 54> statement_words = {
    "IF",     "THEN",  "ELSE",  "ELSEIF", "ENDIF", "GOTO",  "WHILE", "ENDWHILE", "DO",     "END",  "EQ",     "NE",     "GT", "LT",
    "GE",     "LE",    "SIN",   "COS",    "TAN",   "ATAN",  "SQRT",  "ABS",      "FIX",    "FUP",  "ROUND",  "AND",    "OR", "XOR",
    "MOD",    "DPRNT", "BPRNT", "POPEN",  "PCLOS", "FOPEN", "FCLOS", "SUB",      "ENDSUB", "CALL", "RETURN", "REPEAT", "LF", "PRM",
    "EXISTS", "MSG",   "ASIN",  "ACOS",   "BCD",   "BIN",   "LN",    "EXP",      "POW",    "ADP",  "AXNUM",  "SETVN"};

bool letter(char c) { return c >= 'A' && c <= 'Z'; }
/// Returns true for the first byte of a character outside ASCII.
bool beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0xC0; }
bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

bool begins_value(char c) { return is_digit(c) || std::string_view("+-.#[<=(").find(c) != std::string_view::npos; }

/// The number of words in a line in upper case: addresses with a value, and other words.
struct WordCount {
  int addresses = 0, words = 0;
};
WordCount words_of(std::string_view line) {
  WordCount count;
  for (std::size_t i = 0; i < line.size();) {
    if (line[i] == ';') break;
    if (line[i] == '<') i = std::min(line.find('>', i), line.size() - 1);  // skips a name in angle brackets: O<name>, #<name>
    if (line[i] == '#' || line[i] == ':') {
      ++count.addresses;
      ++i;
      if (i < line.size() && line[i] == '_') i = std::min(line.find_first_not_of("_0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ", i), line.size());
      continue;
    }
    if (!letter(line[i]) && !beyond_ascii(line[i])) {
      ++i;
      continue;
    }
    std::size_t end = i, characters = 0;
    for (; end < line.size() && (letter(line[end]) || beyond_ascii(line[end]) || continues(line[end])); ++end)
      characters += continues(line[end]) ? 0 : 1;
    const std::string_view word = line.substr(i, end - i);
    const std::size_t next = std::min(line.find_first_not_of(" \t", end), line.size());
    const bool value = next < line.size() && begins_value(line[next]);
    const bool of_language = std::find(statement_words.begin(), statement_words.end(), word) != statement_words.end();
    constexpr std::string_view end_of_block = "\xD0\x9F\xD0\xA1";  // the letters ПС (end of block) in UTF-8
    if ((characters == 1 && value) || of_language || word == end_of_block || (characters <= 2 && value)) ++count.addresses;
    else ++count.words;
    i = end;
  }
  return count;
}

/// Returns true if commas precede numbers, as in a row of a table (`M2 x 0.4, 2.5, 1.886`). In blocks, commas precede letters (`,R5`) or
/// are inside brackets.
bool is_like_row(std::string_view line) {
  int commas = 0, depth = 0;
  for (std::size_t i = 0; i < line.size() && line[i] != ';'; ++i) {
    if (line[i] == '[' || line[i] == '(') ++depth;
    if (line[i] == ']' || line[i] == ')') --depth;
    if (line[i] != ',' || depth != 0) continue;
    const std::size_t next = line.find_first_not_of(" \t", i + 1);
    commas += next != std::string_view::npos && begins_value(line[next]);
  }
  return commas >= 2;
}

bool is_like_block(const std::string& line) {
  if (line[0] == '%' || line[0] == ';' || (line[0] == '/' && !line.starts_with("//"))) return true;
  const WordCount count = words_of(line);
  return count.addresses > count.words && !is_like_row(line);
}

/// Returns the start of the line for a message, cut at a character boundary.
std::string beginning_of(std::string_view line) {
  constexpr std::size_t most = 40;  // greatest length of the result in bytes
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  std::size_t size = std::min(line.size(), most);
  while (size < line.size() && size > 0 && continues(line[size])) --size;
  while (size > 0 && static_cast<unsigned char>(line[size - 1]) <= ' ') --size;
  return std::string(line.substr(0, size)) + (size + 1 < line.size() ? "…" : "");
}

bool is_binary(std::string_view sample) {
  constexpr double most = 0.02;  // greatest fraction of bytes that are no text; a damaged program has a smaller fraction
  const auto odd = std::count_if(sample.begin(), sample.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f' && byte != 0x1A) || byte == 0x7F;
  });
  return static_cast<double>(odd) > most * static_cast<double>(sample.size());
}

}  // namespace

std::string bare_line(std::string_view line) {
  std::string text;
  bool inside = false;
  for (const char c : line) {
    if (c == '(') inside = true;
    else if (c == ')') inside = false;
    else if (!inside && c != '\r') text += to_upper(c);
  }
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

KindOfText kind_of_text(std::string_view sample) {
  if (is_binary(sample)) return {TextKind::binary, {}, 0};
  std::uint32_t number = 0;
  int lines = 0, blocks = 0;
  KindOfText first_prose{TextKind::prose, {}, 0};
  for (std::string_view rest = sample; !rest.empty() && lines < lines_looked_at;) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view whole = rest.substr(0, end);
    const std::string line = bare_line(whole);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++number;
    if (line.empty()) continue;
    ++lines;
    if (is_like_block(line)) ++blocks;
    else if (first_prose.line == 0) first_prose = {TextKind::prose, beginning_of(whole), number};
  }
  if (lines == 0) return {TextKind::empty, {}, 0};
  return 2 * blocks < lines ? first_prose : KindOfText();
}

}  // namespace kadr
