#include "config/guess.h"

#include <array>
#include <cctype>
#include <cstdint>

namespace kadr {
namespace {

struct Clue {
  double weight = 0;
  const char* en = "";
  const char* ru = "";
};

bool digit(char c) { return c >= '0' && c <= '9'; }

/// A code that of all our controls only nct has: `G54.1`, not `G54.12`.
bool nct_code(std::string_view line) {
  constexpr std::array<std::string_view, 11> codes = {"G54.1", "G84.2", "G84.3", "G68.2", "G43.4", "G43.5",
                                                      "G43.7", "G51.1", "G10.9", "G53.6", "G66.1"};
  for (const std::string_view code : codes)
    for (std::size_t at = line.find(code); at != std::string_view::npos; at = line.find(code, at + 1))
      if (at + code.size() >= line.size() || !digit(line[at + code.size()])) return true;
  for (const std::string_view call : {"G65P", "G65 P", "G65<", "G65 <", "G66P", "G66 P", "M98<", "M98 <"})
    if (line.find(call) != std::string_view::npos) return true;
  return false;
}

/// A statement or name of the macro language, `XI-40`, `,R5`. `O100 WHILE [` belongs to another family of controls.
bool nct_form(std::string_view line) {
  if (line[0] == 'O') return false;
  constexpr std::array<std::string_view, 13> words = {"WHILE[", "WHILE [", "GOTO",  "THEN", "DPRNT[", "BPRNT[", "POPEN",
                                                      "FOPEN",  "FCLOS",   "PCLOS", "#_",   "AXNUM[", "PRM["};
  for (const std::string_view word : words)
    if (line.find(word) != std::string_view::npos) return true;
  for (std::size_t i = 0; i + 2 < line.size(); ++i) {
    const char after = line[i + 2];
    if (!digit(after) && after != '-' && after != '.') continue;
    if (line[i + 1] == 'I' && std::string_view("XYZUVWABCR").find(line[i]) != std::string_view::npos) return true;
    if (line[i] == ',' && std::string_view("CRA").find(line[i + 1]) != std::string_view::npos) return true;
  }
  return false;
}

/// What a line of program tells; comments are left out before.
class Clues {
 public:
  void take(std::string_view line) {
    if (line.empty()) return;
    ++lines_;
    const bool numbered = line[0] == 'N' || line[0] == ':' || (line[0] == '/' && line.size() > 1 && line[1] == 'N');
    numbered_ += numbered;
    points_ += line.find('.') != std::string_view::npos;
    marks_ps_ += line.find("\xD0\x9F\xD0\xA1") != std::string_view::npos;
    marks_lf_ += line.size() >= 2 && line.substr(line.size() - 2) == "LF";
    macros_ += nct_code(line) || nct_form(line);
    variables_ += line.find('#') != std::string_view::npos || line.find('[') != std::string_view::npos;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) letter(line, i);
  }

  Guess best() const {
    const double n = lines_ == 0 ? 1.0 : static_cast<double>(lines_);
    const std::array<Clue, 5> of = {
        Clue{(marks_ps_ > 0 ? 4.0 : 0.0) + (parameters_ > 0 ? 4.0 : 0.0) + (l_cycles_ > 0 ? 4.0 : 0.0) +
                 (long_integers_ > 0 && points_ == 0 ? 2.0 : 0.0) + (numbered_ == lines_ && lines_ > 0 ? 1.0 : 0.0),
             "blocks end with ПС, numbers without points, L81…L89 or R parameters",
             "кадры кончаются ПС, числа без точки, L81…L89 или параметры R"},
        Clue{(variables_ > 0 ? 4.0 : 0.0) + (static_cast<double>(lines_ - numbered_) / n > 0.5 ? 1.5 : 0.0) + (points_ > 0 ? 1.0 : 0.0) +
                 (probe_or_o_ > 0 ? 2.0 : 0.0) + 0.5,
             "free numbers with decimal points, few block numbers, # variables or O programs",
             "числа с точкой, мало номеров кадров, переменные # или программы O"},
        Clue{(pairs_ > 0 ? 6.0 : 0.0) + (pocket_ > 0 ? 6.0 : 0.0), "axis correctors (L1 15) or pocket cycles G87/G79",
             "корректоры по осям (L1 15) или циклы карманов G87/G79"},
        Clue{(marks_lf_ > 0 ? 2.0 : 0.0) + (main_blocks_ > 0 ? 2.0 : 0.0) +
                 (numbered_ == lines_ && lines_ > 0 && marks_ps_ == 0 ? 1.5 : 0.0) + (main_blocks_ > 0 ? 1.0 : 0.0),
             "numbered blocks that end with LF, main blocks", "нумерованные кадры с LF, главные кадры"},
        Clue{macros_ > 0 ? 12.0 : 0.0, "macro statements, #_NAME, G65 P, G54.1, G84.2, XI-40 or ,R5",
             "операторы макроязыка, #_ИМЯ, G65 P, G54.1, G84.2, XI-40 или ,R5"}};
    constexpr std::array<const char*, 5> ids = {"s2c42", "mach3", "correctors", "gost", "nct"};
    std::size_t best = 1;
    for (std::size_t i = 0; i < of.size(); ++i)
      if (of[i].weight > of[best].weight) best = i;
    constexpr double weak = 1;
    if (of[best].weight < weak || lines_ == 0) return {ids[best], "the text tells little", "по тексту почти ничего не видно"};
    return {ids[best], of[best].en, of[best].ru};
  }

 private:
  void letter(std::string_view line, std::size_t i) {
    const char c = line[i];
    const char next = line[i + 1];
    main_blocks_ += c == ':' && digit(next);
    if (c == 'R' && digit(next) && i + 2 < line.size() && (line[i + 2] == '+' || line[i + 2] == '-')) ++parameters_;
    if ((c == '+' || c == '-') && next == 'R') ++parameters_;
    if (c == 'L' && next == '8' && i + 2 < line.size() && digit(line[i + 2])) ++l_cycles_;
    if (c == 'L' && digit(next) && i + 3 < line.size() && line[i + 2] == ' ' && digit(line[i + 3])) ++pairs_;
    if (c == 'G' && line.substr(i).starts_with("G79")) ++pocket_;
    if (c == 'O' && digit(next)) ++probe_or_o_;
    if ((c == 'X' || c == 'Y' || c == 'Z') && long_integer(line, i + 1)) ++long_integers_;
  }

  /// `X8000`: four digits or more and no point: increments of 0.001 mm.
  static bool long_integer(std::string_view line, std::size_t at) {
    if (at < line.size() && (line[at] == '+' || line[at] == '-')) ++at;
    std::size_t digits = 0;
    while (at < line.size() && digit(line[at])) ++at, ++digits;
    return digits >= 4 && (at >= line.size() || line[at] != '.');
  }

  std::uint64_t lines_ = 0, numbered_ = 0, points_ = 0, marks_ps_ = 0, marks_lf_ = 0, variables_ = 0;
  std::uint64_t macros_ = 0, parameters_ = 0, l_cycles_ = 0, pairs_ = 0, pocket_ = 0, probe_or_o_ = 0, main_blocks_ = 0, long_integers_ = 0;
};

std::string without_comments(std::string_view line) {
  std::string text;
  bool inside = false;
  for (const char c : line) {
    if (c == '(') inside = true;
    else if (c == ')') inside = false;
    else if (!inside && c != '\r') text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

}  // namespace

Guess guess_control(std::string_view sample) {
  constexpr int lines_looked_at = 500;
  Clues clues;
  int lines = 0;
  while (!sample.empty() && lines++ < lines_looked_at) {
    const std::size_t end = std::min(sample.find('\n'), sample.size());
    const std::string line = without_comments(sample.substr(0, end));
    if (!line.empty() && line[0] != '%') clues.take(line);
    sample.remove_prefix(std::min(end + 1, sample.size()));
  }
  return clues.best();
}

}  // namespace kadr
