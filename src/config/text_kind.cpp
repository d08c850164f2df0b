// For config/guess and cli/program_files; tests/config/guess_test.cpp.

#include "config/text_kind.h"

#include <algorithm>
#include <array>

#include "base/ascii.h"
#include "config/guess_pattern.h"

namespace kadr {
namespace {

constexpr int lines_looked_at = 500;

/// A language that Kadr does not know, and what stands in no program of our controls, as config/guess_pattern.h writes it.
struct LanguageMark {
  const char* pattern;
  const char* language;
};
constexpr LanguageMark language_marks[] = {
    {"BEGINPGM", "Heidenhain"},
    {"ENDPGM", "Heidenhain"},
    {"TOOLCALL", "Heidenhain"},
    {"TOOLDEF", "Heidenhain"},
    {"CYCLDEF", "Heidenhain"},
    {"CYCLCALL", "Heidenhain"},
    {"BLKFORM", "Heidenhain"},
    {"FMAX", "Heidenhain"},
    {"CALLLBL", "Heidenhain"},
    {"^LBL\\d", "Heidenhain"},
    {"FN\\d:", "Heidenhain"},
    {"DR+", "Heidenhain"},
    {"DR-", "Heidenhain"},
    {"LX\\n", "Heidenhain"},
    {"LY\\n", "Heidenhain"},
    {"LZ\\n", "Heidenhain"},
    {"PLANESPATIAL", "Heidenhain"},
    {";$PATH=", "Sinumerik"},
    {"MCALL", "Sinumerik"},
    {"DEFREAL", "Sinumerik"},
    {"DEFINT", "Sinumerik"},
    {"CYCLE\\d", "Sinumerik"},
    {"WORKPIECE(", "Sinumerik"},
    {"STOPRE", "Sinumerik"},
    {"GOTOF", "Sinumerik"},
    {"GOTOB", "Sinumerik"},
    {"\\a=IC(", "Sinumerik"},
    {"\\a=AC(", "Sinumerik"},
    {"\\a=DC(", "Sinumerik"},
    {"\\a=R\\d", "Sinumerik"},
    {"^R\\d=", "Sinumerik"},
    {"^TRANS\\a", "Sinumerik"},
    {"ATRANS", "Sinumerik"},
    {"^AROT", "Sinumerik"},
    {"SUPA", "Sinumerik"},
    {"TRAORI", "Sinumerik"},
    {"TRAFOOF", "Sinumerik"},
    {"DIAMON", "Sinumerik"},
    {"DIAMOF", "Sinumerik"},
    {"FFWON", "Sinumerik"},
    {"POCKET3(", "Sinumerik"},
    {"POCKET4(", "Sinumerik"},
    {"HOLES1(", "Sinumerik"},
    {"HOLES2(", "Sinumerik"},
    {"CR=\\n", "Sinumerik"},
    {"TURN=", "Sinumerik"},
    {"AP=\\n", "Sinumerik"},
    {"$TC_", "Sinumerik"},
    {"$P_", "Sinumerik"},
    {"$AA_", "Sinumerik"},
    {"^PROC ", "Sinumerik"},
    {"MSG(\"", "Sinumerik"},
    {"G500", "Sinumerik"},
    {"CALLO", "Okuma"},
    {"VZOF", "Okuma"},
    {"VTOFH", "Okuma"},
    {"VTOFD", "Okuma"},
    {"NAT0", "Okuma"},
    {"MODIN", "Okuma"},
    {"MODOUT", "Okuma"},
    {"^RTS$", "Okuma"},
    {"NOEX", "Okuma"},
    {"^VC\\d=", "Okuma"},
    {"G15H\\d", "Okuma"},
    {"G56HA", "Okuma"},
    {"NCYL", "Okuma"},
};

/// Words of letters that stand in programs of our controls.
constexpr std::array<std::string_view, 54> statement_words = {
    "IF",     "THEN",  "ELSE",  "ELSEIF", "ENDIF", "GOTO",  "WHILE", "ENDWHILE", "DO",     "END",  "EQ",     "NE",     "GT", "LT",
    "GE",     "LE",    "SIN",   "COS",    "TAN",   "ATAN",  "SQRT",  "ABS",      "FIX",    "FUP",  "ROUND",  "AND",    "OR", "XOR",
    "MOD",    "DPRNT", "BPRNT", "POPEN",  "PCLOS", "FOPEN", "FCLOS", "SUB",      "ENDSUB", "CALL", "RETURN", "REPEAT", "LF", "PRM",
    "EXISTS", "MSG",   "ASIN",  "ACOS",   "BCD",   "BIN",   "LN",    "EXP",      "POW",    "ADP",  "AXNUM",  "SETVN"};

bool letter(char c) { return c >= 'A' && c <= 'Z'; }
/// The beginning of a character that is no ASCII.
bool beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0xC0; }
bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

bool begins_value(char c) { return is_digit(c) || std::string_view("+-.#[<=(").find(c) != std::string_view::npos; }

/// Addresses with values, and words of letters, of a line in capitals.
struct WordCount {
  int addresses = 0, words = 0;
};
WordCount words_of(std::string_view line) {
  WordCount count;
  for (std::size_t i = 0; i < line.size();) {
    if (line[i] == ';') break;
    if (line[i] == '<') i = std::min(line.find('>', i), line.size() - 1);  // a name: O<name>, #<name>
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
    constexpr std::string_view end_of_block = "\xD0\x9F\xD0\xA1";  // ПС
    if ((characters == 1 && value) || of_language || word == end_of_block || (characters <= 2 && value)) ++count.addresses;
    else ++count.words;
    i = end;
  }
  return count;
}

bool is_like_block(const std::string& line) {
  if (line[0] == '%' || line[0] == ';' || line[0] == '/') return true;
  const WordCount count = words_of(line);
  return count.addresses > count.words;
}

/// For people: what the line begins with, whole characters.
std::string beginning_of(std::string_view line) {
  constexpr std::size_t most = 40;  // bytes
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  std::size_t size = std::min(line.size(), most);
  while (size < line.size() && size > 0 && continues(line[size])) --size;
  while (size > 0 && static_cast<unsigned char>(line[size - 1]) <= ' ') --size;
  return std::string(line.substr(0, size)) + (size + 1 < line.size() ? "…" : "");
}

bool is_binary(std::string_view sample) {
  constexpr double most = 0.02;  // of the bytes: a damaged program has fewer
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
  if (is_binary(sample)) return {TextKind::binary, {}, {}, 0};
  std::uint32_t number = 0;
  int lines = 0, blocks = 0;
  KindOfText first_prose{TextKind::prose, {}, {}, 0};
  for (std::string_view rest = sample; !rest.empty() && lines < lines_looked_at;) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view whole = rest.substr(0, end);
    const std::string line = bare_line(whole);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++number;
    if (line.empty()) continue;
    const GuessLine forms = guess_line(whole);
    const bool has_names = line.find("#<") != std::string::npos || line.find("O<") != std::string::npos;  // LinuxCNC's, of any letters
    for (const LanguageMark& mark : language_marks)
      if (const std::string_view found = found_in(forms, mark.pattern); !found.empty() && !has_names)
        return {TextKind::other_language, mark.language, std::string(found), number};
    ++lines;
    if (is_like_block(line)) ++blocks;
    else if (first_prose.line == 0) first_prose = {TextKind::prose, {}, beginning_of(whole), number};
  }
  if (lines == 0) return {TextKind::empty, {}, {}, 0};
  return 2 * blocks < lines ? first_prose : KindOfText();
}

}  // namespace kadr
