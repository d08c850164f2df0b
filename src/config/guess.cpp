// Which control a program was written for, guessed from its text. For session/channel_run, cli/program_files; tested by
// tests/config/guess_test.cpp.

#include "config/guess.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "base/ascii.h"
#include "config/text_kind.h"
#include "lang/text/encoding.h"

namespace kadr {
namespace {

/// What speaks for a control: a piece of text and its first line, or (line 0) what the text is like as a whole.
struct Found {
  double weight = 0;
  std::string what;
  std::uint32_t line = 0;
  const char* en = "";
  const char* ru = "";
};

/// Counts a sign of a control; keeps where it stood first.
struct Sign {
  std::uint64_t count = 0;
  std::string what;
  std::uint32_t line = 0;

  void see(std::string_view text, std::uint32_t at) {
    if (count++ == 0) what = text, line = at;
  }
};

/// A code that of all our controls only nct has: `G54.1`, not `G54.12`. Empty: none.
std::string_view nct_code(std::string_view line) {
  constexpr std::array<std::string_view, 11> codes = {"G54.1", "G84.2", "G84.3", "G68.2", "G43.4", "G43.5",
                                                      "G43.7", "G51.1", "G10.9", "G53.6", "G66.1"};
  for (const std::string_view code : codes)
    for (std::size_t at = line.find(code); at != std::string_view::npos; at = line.find(code, at + 1))
      if (at + code.size() >= line.size() || !is_digit(line[at + code.size()])) return code;
  for (const std::string_view call : {"G65P", "G65 P", "G65<", "G65 <", "G66P", "G66 P", "M98<", "M98 <"})
    if (line.find(call) != std::string_view::npos) return call;
  return {};
}

/// A statement or name of the macro language, `XI-40`, `,R5`. `O100 WHILE [` belongs to another family of controls.
std::string_view nct_form(std::string_view line) {
  if (line[0] == 'O') return {};
  constexpr std::array<std::string_view, 13> words = {"WHILE[", "WHILE [", "GOTO",  "THEN", "DPRNT[", "BPRNT[", "POPEN",
                                                      "FOPEN",  "FCLOS",   "PCLOS", "#_",   "AXNUM[", "PRM["};
  for (const std::string_view word : words)
    if (line.find(word) != std::string_view::npos) return word;
  for (std::size_t i = 0; i + 2 < line.size(); ++i) {
    const char after = line[i + 2];
    if (!is_digit(after) && after != '-' && after != '.') continue;
    if (line[i + 1] == 'I' && std::string_view("XYZUVWABCR").find(line[i]) != std::string_view::npos) return line.substr(i, 3);
    if (line[i] == ',' && std::string_view("CRA").find(line[i + 1]) != std::string_view::npos) return line.substr(i, 3);
  }
  return {};
}

/// An O line with a word of flow (`O100 WHILE […]`, `O<SLOT> CALL`), a name `#<…>`, a code that of all our controls LinuxCNC has alone
/// (spec/linuxcnc 3, 4.2, 6). Empty: none.
std::string_view linuxcnc_form(std::string_view line) {
  if (line[0] == 'O') {
    const std::size_t name = line.find('>');
    const std::size_t label = line.size() > 1 && line[1] == '<' && name != std::string_view::npos
                                  ? name + 1
                                  : std::min(line.find_first_not_of("O0123456789# "), line.size());
    const std::string_view behind = line.substr(std::min(line.find_first_not_of(' ', label), line.size()));
    for (const std::string_view word : {"SUB", "ENDSUB", "CALL", "RETURN", "IF", "WHILE", "DO", "REPEAT"})
      if (behind.starts_with(word)) return line.substr(0, std::min<std::size_t>(line.size(), 24));
  }
  if (const std::size_t at = line.find("#<"); at != std::string_view::npos)
    return line.substr(at, std::min<std::size_t>(line.find('>', at) - at + 1, 24));
  constexpr std::array<std::string_view, 10> codes = {"G33.1", "G38.3", "G38.4", "G38.5", "G43.2",
                                                      "G41.1", "G42.1", "G59.1", "G59.2", "G59.3"};
  for (const std::string_view code : codes)
    if (line.find(code) != std::string_view::npos) return code;
  return {};
}

/// `$X`, `$110=500`, `$J=G91X10F100` at the start of a line: no other control has such lines (spec/grbl 9).
std::string_view grbl_form(std::string_view line) {
  if (line[0] != '$' || line.size() < 2) return {};
  return std::string_view("$#GINHXCJSR").find(line[1]) != std::string_view::npos || is_digit(line[1]) ? line.substr(0, 12)
                                                                                                      : std::string_view();
}

/// The first of these that stands in the line, followed by no further digit or letter.
template <std::size_t N>
std::string_view one_of(std::string_view line, const std::array<std::string_view, N>& forms) {
  for (const std::string_view form : forms)
    for (std::size_t at = line.find(form); at != std::string_view::npos; at = line.find(form, at + 1))
      if (at + form.size() >= line.size() || !is_digit(form.back()) || !is_digit(line[at + form.size()])) return form;
  return {};
}

/// What the Haas has beside Fanuc's language (spec/haas 2.4, 3.1, 5.3, 6.1, 9).
std::string_view haas_form(std::string_view line) {
  constexpr std::array<std::string_view, 12> forms = {"M97P",  "M97 P", "G154P", "G154 P", "G187", "G103",
                                                      "#3026", "#3027", "G47E",  "G47 E",  "G150", "G101 X"};
  return one_of(line, forms);
}

/// What Fanuc has and the NCT has not: WH[, a `;` behind words, M29 S, G05.1, G10.6 (spec/fanuc 13).
std::string_view fanuc_form(std::string_view line) {
  constexpr std::array<std::string_view, 9> forms = {"WH[", "M29S", "M29 S", "G05.1", "G5.1Q", "G5.1 Q", "M198", "SETVN", "G05P10000"};
  return one_of(line, forms);
}

/// "ПС in line 2, L81 in line 12".
std::string reason_of(const std::vector<Found>& found, bool ru) {
  std::string reason;
  for (const Found& f : found) {
    if (!reason.empty()) reason += ", ";
    reason += f.line == 0 ? (ru ? f.ru : f.en) : f.what + (ru ? " в строке " : " in line ") + std::to_string(f.line);
  }
  return reason;
}

/// What the lines of a program tell; comments are left out before.
class Clues {
 public:
  void take(std::string_view line, std::uint32_t number) {
    number_ = number;
    if (line[0] == '%') return tape_begins(line);
    if (std::exchange(behind_percent_, false) && is_program_number(line)) return program_number_.see(line, number);
    ++lines_;
    const bool numbered = line[0] == 'N' || line[0] == ':' || (line[0] == '/' && line.size() > 1 && line[1] == 'N');
    numbered_ += numbered;
    points_ += line.find('.') != std::string_view::npos;
    constexpr std::string_view ps = "\xD0\x9F\xD0\xA1";
    if (line.find(ps) != std::string_view::npos) marks_ps_.see(ps, number);
    if (line.size() >= 2 && line.ends_with("LF")) marks_lf_.see("LF", number);
    if (const auto form = grbl_form(line); !form.empty()) grbl_.see(form, number);
    if (const auto form = haas_form(line); !form.empty()) haas_.see(form, number);
    if (const auto form = fanuc_form(line); !form.empty()) fanuc_.see(form, number);
    if (const auto form = linuxcnc_form(line); !form.empty()) linuxcnc_.see(form, number);
    if (const auto code = nct_code(line); !code.empty()) macros_.see(code, number);
    else if (const auto form = nct_form(line); !form.empty()) macros_.see(form, number);
    if (const std::size_t at = line.find_first_of("#["); at != std::string_view::npos) {
      const std::size_t end = line.find_first_not_of("#[<_0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ>", at);
      variables_.see(line.substr(at, std::min<std::size_t>(end - at, 20)), number);
    }
    for (std::size_t i = 0; i + 1 < line.size(); ++i) letter(line, i);
  }

  Guess best() const {
    constexpr std::array<const char*, 9> ids = {"s2c42", "mach3", "correctors", "gost", "nct", "linuxcnc", "grbl", "haas", "fanuc"};
    const std::array<std::vector<Found>, 9> of = {s2c42(),    mach3(),      correctors(), gost(),       nct(),
                                                  linuxcnc(), alone(grbl_), alone(haas_), alone(fanuc_)};
    const auto weight = [](const std::vector<Found>& found) {
      return std::accumulate(found.begin(), found.end(), 0.0, [](double sum, const Found& f) { return sum + f.weight; });
    };
    std::size_t best = 1;  // the most common, where nothing speaks for another
    for (std::size_t i = 0; i < of.size(); ++i)
      if (weight(of[i]) > weight(of[best])) best = i;
    if (of[best].empty()) return {ids[best], "the text tells little", "по тексту почти ничего не видно"};
    return {ids[best], reason_of(of[best], false), reason_of(of[best], true)};
  }

 private:
  static void add(std::vector<Found>& to, double weight, const Sign& sign) {
    if (sign.count > 0) to.push_back({weight, sign.what, sign.line});
  }
  static void add(std::vector<Found>& to, double weight, bool holds, const char* en, const char* ru) {
    if (holds) to.push_back({weight, {}, 0, en, ru});
  }
  /// `%012`: spec/gost 1; `%O1000` and a bare `%` stand in programs of others, too.
  void tape_begins(std::string_view line) {
    behind_percent_ = true;
    if (line.size() > 1 && is_digit(line[1])) tape_number_.see(line.substr(0, std::min<std::size_t>(line.size(), 6)), number_);
  }
  static bool is_program_number(std::string_view line) {
    return line[0] == 'O' && line.size() > 1 && line.find_first_not_of("0123456789", 1) == std::string_view::npos;
  }
  bool all_numbered() const { return numbered_ == lines_ && lines_ > 0; }

  std::vector<Found> s2c42() const {
    std::vector<Found> found;
    add(found, 4, marks_ps_);
    add(found, 4, parameters_);
    add(found, 4, l_cycles_);
    add(found, 2, long_integers_ > 0 && points_ == 0, "numbers without points", "числа без точки");
    add(found, 1, all_numbered(), "all blocks numbered", "все кадры с номерами");
    return found;
  }
  std::vector<Found> mach3() const {
    std::vector<Found> found;
    add(found, 4, variables_);
    add(found, 2, o_words_);
    if (one_digit_codes_ != 0 || !all_numbered()) add(found, 2, program_number_);  // else gost has it as well (spec/gost 1)
    const bool few = static_cast<double>(lines_ - numbered_) / static_cast<double>(std::max<std::uint64_t>(lines_, 1)) > 0.5;
    add(found, 1.5, few, "few block numbers", "мало номеров кадров");
    add(found, 1, points_ > 0, "decimal points", "десятичные точки");
    if (!found.empty()) found.back().weight += 0.5;  // of equal ones the most common
    return found;
  }
  std::vector<Found> correctors() const {
    std::vector<Found> found;
    add(found, 6, pairs_);
    add(found, 6, pocket_);
    return found;
  }
  std::vector<Found> gost() const {
    std::vector<Found> found;
    add(found, 2, marks_lf_);
    add(found, 3, main_blocks_);
    add(found, 2, tape_number_);
    const bool numbered = all_numbered() && marks_ps_.count == 0;
    add(found, 1.5, numbered, "all blocks numbered", "все кадры с номерами");
    if (one_digit_codes_ != 0) return found;  // spec/gost 3: 3G2 prints G01
    add(found, 0.75, plus_signs_);
    add(found, 0.75, numbered && two_digit_codes_ > 0, "codes of two digits", "коды из двух цифр");
    return found;
  }
  std::vector<Found> nct() const {
    std::vector<Found> found;
    add(found, 12, macros_);
    return found;
  }
  /// A sign that no other control has; it counts for more than the macros that several share.
  static std::vector<Found> alone(const Sign& sign) {
    std::vector<Found> found;
    add(found, 14, sign);
    return found;
  }
  std::vector<Found> linuxcnc() const {
    std::vector<Found> found;
    add(found, 12, linuxcnc_);
    return found;
  }

  void letter(std::string_view line, std::size_t i) {
    const char c = line[i];
    const char next = line[i + 1];
    const auto see = [&](Sign& sign, std::size_t length) { sign.see(line.substr(i, length), number_); };
    if (c == ':' && is_digit(next)) see(main_blocks_, 2);
    if ((c == 'G' || c == 'M') && is_digit(next)) ++(i + 2 < line.size() && is_digit(line[i + 2]) ? two_digit_codes_ : one_digit_codes_);
    if (std::string_view("XYZIJK").find(c) != std::string_view::npos && next == '+' && i + 2 < line.size() && is_digit(line[i + 2]))
      see(plus_signs_, 3);
    if (c == 'R' && is_digit(next) && i + 2 < line.size() && (line[i + 2] == '+' || line[i + 2] == '-')) see(parameters_, 3);
    if ((c == '+' || c == '-') && next == 'R') see(parameters_, 3);
    if (c == 'L' && next == '8' && i + 2 < line.size() && is_digit(line[i + 2])) see(l_cycles_, 3);
    if (c == 'L' && is_digit(next) && i + 3 < line.size() && line[i + 2] == ' ' && is_digit(line[i + 3])) see(pairs_, 5);
    if (c == 'G' && line.substr(i).starts_with("G79")) see(pocket_, 3);
    if (c == 'O' && is_digit(next)) see(o_words_, std::min(line.find_first_not_of("0123456789", i + 1), line.size()) - i);
    if ((c == 'X' || c == 'Y' || c == 'Z') && long_integer(line, i + 1)) ++long_integers_;
  }

  /// `X8000`: four digits or more and no point: increments of 0.001 mm.
  static bool long_integer(std::string_view line, std::size_t at) {
    if (at < line.size() && (line[at] == '+' || line[at] == '-')) ++at;
    std::size_t digits = 0;
    while (at < line.size() && is_digit(line[at])) ++at, ++digits;
    return digits >= 4 && (at >= line.size() || line[at] != '.');
  }

  std::uint32_t number_ = 0;  // of the line
  bool behind_percent_ = false;
  std::uint64_t lines_ = 0, numbered_ = 0, points_ = 0, long_integers_ = 0, two_digit_codes_ = 0, one_digit_codes_ = 0;
  Sign marks_ps_, marks_lf_, variables_, macros_, linuxcnc_, grbl_, haas_, fanuc_, parameters_, l_cycles_, pairs_, pocket_, o_words_,
      program_number_, main_blocks_, tape_number_, plus_signs_;
};

Guess unknown(const KindOfText& text) {
  const std::string line = std::to_string(text.line);
  switch (text.kind) {
    case TextKind::other_language:
      return {"", text.language + ": " + text.found + " in line " + line, text.language + ": " + text.found + " в строке " + line};
    case TextKind::prose:
      return {"", "few lines are blocks, the first that is none is line " + line + ": " + text.found,
              "кадров мало, первая строка не из них — " + line + ": " + text.found};
    default: return {"", "it is no text", "это не текст"};
  }
}

}  // namespace

bool is_program_text(std::string_view bytes) {
  std::string text;
  const auto encoding = detect_encoding(bytes);
  if (encoding) (void)append_utf8(bytes, *encoding, text);
  return kind_of_text(encoding ? std::string_view(text) : bytes).kind == TextKind::program;
}

Guess guess_control(std::string_view sample) {
  constexpr std::uint32_t lines_looked_at = 500;
  if (sample.starts_with("\xEF\xBB\xBF")) sample.remove_prefix(3);
  const KindOfText text = kind_of_text(sample);
  if (text.kind == TextKind::empty) return {"mach3", "there is nothing in it", "в нём ничего нет"};
  if (text.kind != TextKind::program) return unknown(text);
  Clues clues;
  for (std::uint32_t number = 1; !sample.empty() && number <= lines_looked_at; ++number) {
    const std::size_t end = std::min(sample.find('\n'), sample.size());
    const std::string line = bare_line(sample.substr(0, end));
    if (!line.empty()) clues.take(line, number);
    sample.remove_prefix(std::min(end + 1, sample.size()));
  }
  return clues.best();
}

}  // namespace kadr
