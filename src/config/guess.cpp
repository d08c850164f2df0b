// Which control a program was written for, guessed from its text: marks of the controls' files and what the text is like as a whole. For
// cli/guessed_control, cli/program_files; tested by tests/config/guess_test.cpp.

#include "config/guess.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>

#include "base/ascii.h"
#include "config/guess_pattern.h"
#include "config/text_kind.h"
#include "lang/text/encoding.h"

namespace kadr {
namespace {

/// Where nothing speaks for another: the most common of makers' machines.
constexpr std::string_view usual_control = "mach3";

/// What speaks for a control: a piece of text and its first line, or (line 0) what the text is like as a whole.
struct Found {
  double weight = 0;
  std::string en, ru;
};

/// What the lines of a text are like; comments are left out before.
class Traits {
 public:
  void take(std::string_view line) {
    if (line[0] == '%') {
      behind_percent_ = true;
      return;
    }
    if (std::exchange(behind_percent_, false) && is_program_number(line)) {
      numbered_program_ = true;
      return;
    }
    ++lines_;
    numbered_ += line[0] == 'N' || line[0] == ':' || line.starts_with("/N");
    points_ += line.find('.') != std::string_view::npos;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) letter(line, i);
  }

  bool holds(TextTrait trait) const {
    const bool all_numbered = numbered_ == lines_ && lines_ > 0;
    switch (trait) {
      case TextTrait::all_numbered: return all_numbered;
      case TextTrait::few_numbered: return 2 * numbered_ < lines_;
      case TextTrait::decimal_points: return points_ > 0;
      case TextTrait::long_integers: return long_integers_ > 0 && points_ == 0;
      case TextTrait::whole_lengths: return short_lengths_ > 0 && pointed_lengths_ == 0 && long_integers_ == 0;
      case TextTrait::plus_signs: return plus_signs_ > 0 && one_digit_codes_ == 0;
      case TextTrait::two_digit_codes: return all_numbered && two_digit_codes_ > 0 && one_digit_codes_ == 0;
      case TextTrait::program_number: return numbered_program_ && (one_digit_codes_ != 0 || !all_numbered);
      case TextTrait::count: break;
    }
    return false;
  }

 private:
  static bool is_program_number(std::string_view line) {
    return line[0] == 'O' && line.size() > 1 && line.find_first_not_of("0123456789", 1) == std::string_view::npos;
  }

  void letter(std::string_view line, std::size_t i) {
    const char c = line[i], next = line[i + 1];
    const bool digit_behind = i + 2 < line.size() && is_digit(line[i + 2]);
    if ((c == 'G' || c == 'M') && is_digit(next)) ++(digit_behind ? two_digit_codes_ : one_digit_codes_);
    if (std::string_view("XYZIJK").find(c) != std::string_view::npos && next == '+' && digit_behind) ++plus_signs_;
    const bool argument = line.find("G65") != std::string_view::npos || line.find("G66") != std::string_view::npos;  // often a mere number
    if (!argument && std::string_view("XYZIJKR").find(c) != std::string_view::npos) length(line, i + 1, c == 'X' || c == 'Y' || c == 'Z');
  }

  /// `X8000`: four digits or more and no point: increments of 0.001 mm. `X10` may be 10 mm, `X0` is the same on all controls.
  void length(std::string_view line, std::size_t at, bool of_axis) {
    if (line[at] == '+' || line[at] == '-') ++at;
    const std::size_t end = std::min(line.find_first_not_of("0123456789", at), line.size());
    if (end < line.size() && line[end] == '.') ++pointed_lengths_;
    else if (of_axis && end - at >= 4) ++long_integers_;
    else if (of_axis && line.substr(at, end - at).find_first_not_of('0') != std::string_view::npos) ++short_lengths_;
  }

  bool behind_percent_ = false, numbered_program_ = false;
  std::uint64_t lines_ = 0, numbered_ = 0, points_ = 0, two_digit_codes_ = 0, one_digit_codes_ = 0, plus_signs_ = 0;
  std::uint64_t long_integers_ = 0, short_lengths_ = 0, pointed_lengths_ = 0;
};

/// A control and what of its rows has been found so far.
struct Candidate {
  const GuessRows* rows;
  std::vector<bool> seen;
  std::vector<Found> found;
  double strongest = 0;

  explicit Candidate(const GuessRows& of) : rows(&of), seen(of.marks.size()) {}

  void take(const GuessLine& line, std::uint32_t number) {
    for (std::size_t i = 0; i < rows->marks.size(); ++i) {
      const auto& [pattern, weight] = rows->marks[i];
      if (seen[i]) continue;
      const std::string_view text = found_in(line, pattern);
      if (text.empty()) continue;
      seen[i] = true;
      strongest = std::max(strongest, weight);
      const std::string where = std::to_string(number);
      found.push_back({weight, "line " + where + ": " + std::string(text), "строка " + where + ": " + std::string(text)});
    }
  }

  void take(const Traits& text) {
    for (const auto& [trait, weight] : rows->traits)
      if (text.holds(trait)) found.push_back({weight, std::string(text_of(trait).en), std::string(text_of(trait).ru)});
    std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.weight > b.weight; });
  }

  double score() const {
    double sum = 0;
    for (const Found& f : found) sum += f.weight;
    return sum;
  }

  /// "line 3: M97 P10, line 12: G187", the strongest of them.
  std::string reason(std::string Found::*language) const {
    constexpr std::size_t most = 5;
    std::string all;
    for (std::size_t i = 0; i < std::min(found.size(), most); ++i) all += (i == 0 ? "" : ", ") + found[i].*language;
    return all;
  }
};

Guess guess_of(const std::vector<Candidate>& candidates) {
  constexpr double lead = 2;  // over the next one, of a decisive mark
  const auto better = [](const Candidate& a, const Candidate& b) {
    const double first = a.score(), second = b.score();
    return first != second ? first < second : a.rows->control != usual_control && b.rows->control == usual_control;
  };
  const Candidate& best = *std::max_element(candidates.begin(), candidates.end(), better);
  double next = 0;
  Guess guess;
  for (const Candidate& c : candidates) {
    guess.scores.emplace_back(c.rows->control, c.score());
    if (&c != &best) next = std::max(next, c.score());
  }
  guess.control = best.rows->control;
  guess.decisive = best.strongest >= decisive_weight && best.score() >= next + lead;
  guess.reason_en = best.found.empty() ? "the text tells little" : best.reason(&Found::en);
  guess.reason_ru = best.found.empty() ? "по тексту почти ничего не видно" : best.reason(&Found::ru);
  return guess;
}

Guess unknown(const KindOfText& text) {
  const std::string line = std::to_string(text.line);
  Guess guess;
  guess.decisive = true;
  switch (text.kind) {
    case TextKind::other_language:
      guess.reason_en = text.language + ", line " + line + ": " + text.found;
      guess.reason_ru = text.language + ", строка " + line + ": " + text.found;
      break;
    case TextKind::prose:
      guess.reason_en = "few lines are blocks, the first that is none is line " + line + ": " + text.found;
      guess.reason_ru = "кадров мало, первая строка не из них — " + line + ": " + text.found;
      break;
    default: guess.reason_en = "it is no text", guess.reason_ru = "это не текст";
  }
  return guess;
}

}  // namespace

bool is_program_text(std::string_view bytes) {
  std::string text;
  const auto encoding = detect_encoding(bytes);
  if (encoding) (void)append_utf8(bytes, *encoding, text);
  return kind_of_text(encoding ? std::string_view(text) : bytes).kind == TextKind::program;
}

Guess guess_control(std::string_view sample, const std::vector<GuessRows>& own) {
  constexpr std::uint32_t lines_looked_at = 500;
  if (sample.starts_with("\xEF\xBB\xBF")) sample.remove_prefix(3);
  const KindOfText text = kind_of_text(sample);
  if (text.kind != TextKind::program && text.kind != TextKind::empty) return unknown(text);
  std::vector<Candidate> candidates;
  for (const GuessRows& rows : built_in_guess_rows()) candidates.emplace_back(rows);
  for (const GuessRows& rows : own) candidates.emplace_back(rows);
  Traits traits;
  for (std::uint32_t number = 1; !sample.empty() && number <= lines_looked_at; ++number) {
    const std::size_t end = std::min(sample.find('\n'), sample.size());
    const GuessLine line = guess_line(sample.substr(0, end));
    if (!line.raw.empty())
      for (Candidate& c : candidates) c.take(line, number);
    if (!line.written.empty()) traits.take(line.written);
    sample.remove_prefix(std::min(end + 1, sample.size()));
  }
  for (Candidate& c : candidates) c.take(traits);
  return guess_of(candidates);
}

std::string common_control(const std::vector<Guess>& guesses) {
  std::set<std::string> decided;
  std::map<std::string, double> sums;
  for (const Guess& guess : guesses) {
    if (guess.control.empty()) continue;
    if (guess.decisive) decided.insert(guess.control);
    for (const auto& [control, score] : guess.scores) sums[control] += score;
  }
  if (decided.size() > 1 || sums.empty()) return {};
  if (!decided.empty()) return *decided.begin();
  const auto better = [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second < b.second : a.first != usual_control && b.first == usual_control;
  };
  return std::max_element(sums.begin(), sums.end(), better)->first;
}

}  // namespace kadr
