// Guesses from a program's text the control that it was written for. The evidence is the marks in the controls' files (patterns of
// [guess]), and the style of the text as a whole. Used by session/folder_guess, cli/job/program_files; tested by
// tests/config/guess_test.cpp.

#include "config/control/guess.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "base/ascii.h"
#include "config/control/control_file.h"
#include "config/control/guess_pattern.h"
#include "config/text_kind.h"
#include "lang/text/encoding.h"
#include "texts/guess.h"

namespace kadr {
namespace {

constexpr std::uint32_t lines_of_guess = 500;
constexpr double near = 4;  // greatest difference from the best score with which a control is still considered

/// The default guess: the control that is guessed if no evidence points to another control. It is the most common control on hobbyists'
/// machines.
constexpr std::string_view usual_control = "mach3";

/// A piece of evidence: a text found in the program, with its first line; with line 0, the style of the program, or the name of the file or
/// folder.
struct Found {
  double weight = 0;
  std::uint32_t line = 0;
  std::string en, ru;
};

/// A candidate of the guess: a control, or a program language that Kadr does not read, with the evidence found for this candidate so far.
struct Candidate {
  const GuessRows* rows;
  bool is_dialect;
  std::vector<Found> found{};
  double strongest_mark = 0;

  void take(std::string_view text, double weight, std::uint32_t number) {
    strongest_mark = std::max(strongest_mark, weight);
    found.push_back({weight, number, translated_in(Lang::en, texts::guess::line_has, number, text),
                     translated_in(Lang::ru, texts::guess::line_has, number, text)});
  }

  void take_name(std::string_view path) {
    for (const auto& [pattern, weight, place, needs, rarest] : rows->marks)
      if (place == MarkLocation::name && is_named_like(path, pattern)) {
        const bool of_folder = pattern.find('/') != std::string::npos;
        // `path` has the form "/folder/part.nc", so it contains at least one '/' and rfind() finds it
        const std::size_t last = path.rfind('/');
        const std::string name(of_folder ? path.substr(1, last - 1) : path.substr(last + 1));
        const TextId<1> what = of_folder ? texts::guess::folder_is : texts::guess::name_is;
        found.push_back({weight, 0, translated_in(Lang::en, what, name), translated_in(Lang::ru, what, name)});
        strongest_mark = std::max(strongest_mark, weight);
      }
  }

  void take(const Traits& text) {
    for (const auto& [trait, weight] : rows->traits)
      if (text.holds(trait))
        found.push_back({weight, 0, plain_text(text_of(trait).text, Lang::en), plain_text(text_of(trait).text, Lang::ru)});
  }

  double score() const {
    double sum = 0;
    for (const Found& f : found) sum += f.weight;
    return sum;
  }

  /// Returns the strongest evidence: first that with a line, in order of lines, then the style of the text: "line 3: M97P, line 12: G187".
  std::vector<Found> strongest() const {
    constexpr std::size_t most = 5;
    std::vector<Found> all;
    std::copy_if(found.begin(), found.end(), std::back_inserter(all), [](const Found& f) { return f.weight > 0; });
    std::stable_sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.weight > b.weight; });
    // Evidence with the same sentence counts only once, because two patterns may have matched the same word
    for (std::size_t i = 0; i < all.size(); ++i)
      all.erase(
          std::remove_if(all.begin() + static_cast<std::ptrdiff_t>(i) + 1, all.end(), [&](const Found& f) { return f.en == all[i].en; }),
          all.end());
    if (all.size() > most) all.resize(most);
    // Evidence with line 0 (the style of the text) gets the greatest number in this comparison, so that it is last.
    std::stable_sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.line - 1U < b.line - 1U; });
    return all;
  }
};

/// The marks of all candidates that have not been found yet. Each mark is stored under the rarest character that it needs, so that most
/// marks need not be compared with most lines.
class OpenMarks {
 public:
  void add(Candidate& candidate) {
    for (const GuessMark& mark : candidate.rows->marks)
      if (mark.place != MarkLocation::name) marks_[mark.rarest].push_back({&candidate, &mark});
  }

  /// Searches a line for marks. `signs`: the characters of the line as written, with its comments. With `only_against`, evidence for
  /// program languages that Kadr does not read is ignored.
  void take(const GuessLine& line, LineSigns signs, std::uint32_t number, bool only_against) {
    hits_.clear();
    for (LineSigns rest = signs; rest != 0; rest &= rest - 1)
      look(static_cast<std::size_t>(std::countr_zero(rest)), line, signs, only_against);
    look(any_sign, line, signs, only_against);
    // The hits are processed in the order of the marks' rows, independent of the characters that the marks are stored under.
    std::sort(hits_.begin(), hits_.end(), [](const Hit& a, const Hit& b) { return std::less<>()(a.mark, b.mark); });
    for (const Hit& hit : hits_) hit.of->take(hit.text, hit.mark->weight, number);
  }

 private:
  struct Open {
    Candidate* of;
    const GuessMark* mark;
  };
  struct Hit : Open {
    std::string_view text;
  };

  void look(std::size_t sign, const GuessLine& line, LineSigns signs, bool only_against) {
    std::vector<Open>& marks = marks_[sign];
    for (std::size_t i = 0; i < marks.size();) {
      const Open open = marks[i++];
      const GuessMark& mark = *open.mark;
      if ((mark.needs & ~signs) != 0 || (only_against && open.of->is_dialect && mark.weight > 0)) continue;
      const std::string_view text =
          mark.place == MarkLocation::comment ? found_in_words(line.comments, mark.pattern) : found_in(line, mark.pattern);
      if (text.empty()) continue;
      hits_.push_back({open, text});
      marks[--i] = marks.back();
      marks.pop_back();
    }
  }

  std::array<std::vector<Open>, any_sign + 1> marks_;
  std::vector<Hit> hits_;
};

std::string reason_of(const std::vector<Found>& found, std::string Found::*language) {
  std::string all;
  for (const Found& f : found) all += (all.empty() ? "" : ", ") + f.*language;
  return all;
}

/// Order by score, the greatest first. Among controls with equal scores, the default guess (usual_control) comes first.
template <class Row>
bool stands_before(const Row& a, const Row& b) {
  return a.second != b.second ? a.second > b.second : a.first == usual_control && b.first != usual_control;
}

/// Decides by the scores alone. A control with a mark that identifies it by itself needs only a small margin over the next control. Several
/// weaker marks need a large margin. Hints alone decide nothing.
void decide(Guess& guess) {
  constexpr double margin = 2, great_margin = 6, more_than_hint = 5;
  auto ranked = guess.scores;
  std::stable_sort(ranked.begin(), ranked.end(), stands_before<std::pair<std::string, double>>);
  guess.control = ranked[0].first;
  for (std::size_t i = 0; i < guess.scores.size(); ++i)
    if (guess.scores[i].first == guess.control) std::tie(guess.reason_en, guess.reason_ru) = guess.reasons[i];
  const double mark = guess.strongest_marks[guess.control], before = ranked[0].second - ranked[1].second;
  guess.decisive = ranked[0].second >= decisive_weight &&
                   ((mark >= decisive_weight && before >= margin) || (mark >= more_than_hint && before >= great_margin));
}

Guess guess_of(const std::vector<Candidate>& candidates) {
  Guess guess;
  for (const Candidate& c : candidates) {
    guess.scores.emplace_back(c.rows->control, c.score());
    guess.strongest_marks[c.rows->control] = c.strongest_mark;
    const auto strongest = c.strongest();
    guess.reasons.emplace_back(strongest.empty() ? plain_text(texts::guess::tells_little, Lang::en) : reason_of(strongest, &Found::en),
                               strongest.empty() ? plain_text(texts::guess::tells_little, Lang::ru) : reason_of(strongest, &Found::ru));
  }
  decide(guess);
  return guess;
}

/// Returns the score of a program language that Kadr does not read. A language that some controls read competes as these controls instead.
double score_of_unread(const Candidate& language) { return language.rows->read_by.empty() ? language.score() : -decisive_weight; }

/// Returns the program language that Kadr does not read, if the evidence identifies one; else nullptr.
const Candidate* dialect_of(const std::vector<Candidate>& dialects) {
  const auto best = std::max_element(dialects.begin(), dialects.end(),
                                     [](const Candidate& a, const Candidate& b) { return score_of_unread(a) < score_of_unread(b); });
  return best != dialects.end() && score_of_unread(*best) >= decisive_weight ? &*best : nullptr;
}

std::string reason_with_name(const Candidate& dialect, Lang lang) {
  const bool en = lang == Lang::en;
  return (en ? dialect.rows->name_en : dialect.rows->name_ru) + ", " + reason_of(dialect.strongest(), en ? &Found::en : &Found::ru);
}

/// Lowers the scores of the controls that read only a certain program language, such as that of lathes, if the text has little evidence for
/// this language: the control of the same maker's mill, whose evidence they share, is then the more likely one.
void prefer_mills(std::vector<Candidate>& controls, const std::vector<Candidate>& dialects) {
  constexpr double no_evidence = 4, some_evidence = 6;  // a text without Y has 4: such a program may be for either
  for (const Candidate& language : dialects) {
    const double score = language.score(), handicap = score < no_evidence ? 8 : score < some_evidence ? 2.5 : 0;
    for (const LanguageReader& reader : language.rows->read_by)
      for (Candidate& control : controls)
        if (control.rows->control == reader.id && handicap > 0) control.found.push_back({-handicap, 0, {}, {}});
  }
}

/// Notes which controls must not read the program, if the evidence identifies a program language that the guessed control reads.
void take_refusal(Guess& guess, const std::vector<Candidate>& dialects) {
  for (const Candidate& language : dialects) {
    const auto& readers = language.rows->read_by;
    const bool read = std::any_of(readers.begin(), readers.end(), [&](const LanguageReader& of) { return of.id == guess.control; });
    if (!read || language.score() < decisive_weight) continue;
    guess.refused_by = language.rows->refused_by;
    guess.refusal_en = reason_with_name(language, Lang::en), guess.refusal_ru = reason_with_name(language, Lang::ru);
  }
}

Guess of_dialect(const Candidate& dialect) {
  Guess guess;
  guess.decisive = true;
  guess.dialect = dialect.rows->control;
  guess.language_en = dialect.rows->name_en, guess.language_ru = dialect.rows->name_ru;
  guess.reason_en = reason_with_name(dialect, Lang::en), guess.reason_ru = reason_with_name(dialect, Lang::ru);
  return guess;
}

Guess unknown(const KindOfText& text) {
  const auto reason = [&](Lang lang) {
    return text.kind == TextKind::prose ? translated_in(lang, texts::guess::few_blocks, text.line, text.found)
                                        : translated_in(lang, texts::guess::no_text);
  };
  Guess guess;
  guess.decisive = true;
  guess.reason_en = reason(Lang::en), guess.reason_ru = reason(Lang::ru);
  return guess;
}

/// Returns true if the line has a name in angle brackets (#<…>, O<…>). Such a name of LinuxCNC may contain any letters, so the line is not
/// used as evidence for another program language.
bool has_names(const GuessLine& line) {
  return line.written.find("#<") != std::string::npos || line.written.find("O<") != std::string::npos;
}

}  // namespace

bool is_program_text(std::string_view bytes) {
  const std::string_view first_line = bytes.substr(0, bytes.find_first_of("\r\n"));
  if (first_line.find("BEGIN PGM ") != std::string_view::npos) return true;  // long texts of cycles look like prose
  std::string text;
  const auto encoding = detect_encoding(bytes);
  if (encoding) (void)append_utf8(bytes, *encoding, text);
  return kind_of_text(encoding ? std::string_view(text) : bytes).kind == TextKind::program;
}

std::string Guess::runner_up() const {
  auto ranked = scores;
  std::stable_sort(ranked.begin(), ranked.end(), stands_before<std::pair<std::string, double>>);
  for (const auto& [id, score] : ranked)
    if (id != control) return score > 0 ? id : std::string();
  return {};
}

Guess guess_control(std::string_view sample, std::string_view path, const std::vector<GuessRows>& own) {
  if (own.empty()) return guess_among(sample, path, built_in_guess_rows(), dialect_rows());
  std::vector<GuessRows> all = built_in_guess_rows();
  all.insert(all.end(), own.begin(), own.end());
  return guess_among(sample, path, all, dialect_rows());
}

Guess guess_among(std::string_view sample, std::string_view path, const std::vector<GuessRows>& controls,
                  const std::vector<GuessRows>& dialects_known) {
  if (sample.starts_with("\xEF\xBB\xBF")) sample.remove_prefix(3);
  const KindOfText text = kind_of_text(sample);
  if (text.kind == TextKind::binary) return unknown(text);
  std::vector<Candidate> candidates, dialects;
  for (const GuessRows& rows : controls) candidates.push_back({&rows, false});
  for (const GuessRows& rows : dialects_known) dialects.push_back({&rows, true});
  OpenMarks marks;
  for (auto* all : {&candidates, &dialects})
    for (Candidate& c : *all) marks.add(c);
  Traits traits;
  for (std::uint32_t number = 1; !sample.empty() && number <= lines_of_guess; ++number) {
    const std::size_t end = std::min(sample.find('\n'), sample.size());
    const GuessLine line = guess_line(sample.substr(0, end));
    sample.remove_prefix(std::min(end + 1, sample.size()));
    if (line.raw.empty()) continue;
    marks.take(line, signs_of(line.raw), number, has_names(line));
    if (!line.written.empty()) traits.take(line.written);
  }
  for (auto* all : {&candidates, &dialects})
    for (Candidate& c : *all) {
      c.take(traits);
      if (!path.empty()) c.take_name(path);
    }
  prefer_mills(candidates, dialects);
  if (const Candidate* const dialect = dialect_of(dialects)) return of_dialect(*dialect);
  Guess guess = guess_of(candidates);
  // Conversational blocks look like prose, so evidence that is twice as strong as a decisive mark counts more than the look.
  const auto is_strong = [&](const auto& score) { return score.first == guess.control && score.second >= 2 * decisive_weight; };
  if (text.kind == TextKind::prose && !(guess.decisive && std::any_of(guess.scores.begin(), guess.scores.end(), is_strong)))
    return unknown(text);
  take_refusal(guess, dialects);
  for (const Candidate& c : dialects)
    if (c.rows->read_by.empty()) guess.dialect_scores.emplace_back(c.rows->control, c.score());
  return guess;
}

std::string refused_by_control(std::string_view sample, std::string_view control, Lang lang) {
  std::string id;
  for (const char c : control) id += to_lower(c);
  for (const auto& [alias, meant] : control_aliases())
    if (alias == id) id = meant;
  const auto refuses = [&](const std::vector<std::string>& by) { return std::find(by.begin(), by.end(), id) != by.end(); };
  const auto& rows = dialect_rows();
  if (std::none_of(rows.begin(), rows.end(), [&](const GuessRows& of) { return refuses(of.refused_by); })) return {};
  const Guess guess = guess_control(sample);
  if (!refuses(guess.refused_by)) return {};
  return translated_in(lang, texts::guess::milling_alone, lang == Lang::ru ? guess.refusal_ru : guess.refusal_en, id, guess.control);
}

std::vector<std::string> candidates_of(const Guess& guess) {
  constexpr std::size_t most = 5;
  std::vector<std::string> ids;
  if (guess.control.empty() || guess.decisive) return ids;
  auto ranked = guess.scores;
  std::stable_sort(ranked.begin(), ranked.end(), stands_before<std::pair<std::string, double>>);
  for (const auto& [id, score] : ranked)
    if (score + near >= ranked[0].second && ids.size() < most && (score > 0 || id == usual_control)) ids.push_back(id);
  return ids;
}

void take_trial(Guess& guess, const std::vector<std::pair<std::string, std::size_t>>& faults) {
  // Number by which the score of a control with faults is reduced. It is so large that a control without faults wins.
  constexpr double of_faults = near + 1;
  // If every candidate has faults in the trial, the trial proves nothing, and the scores stay unchanged.
  if (std::none_of(faults.begin(), faults.end(), [](const auto& row) { return row.second == 0; })) return;
  for (const auto& [id, count] : faults)
    for (auto& [control, score] : guess.scores)
      if (control == id && count > 0) score -= of_faults;
  decide(guess);
}

CommonGuess common_guess(const std::vector<Guess>& guesses) {
  std::map<std::string, std::size_t> controls, dialects;
  std::map<std::string, double> sums;
  std::size_t decided = 0;
  for (const Guess& guess : guesses) {
    if (guess.control.empty() && guess.dialect.empty()) continue;
    decided += guess.decisive;
    if (!guess.dialect.empty()) ++dialects[guess.dialect];
    else if (guess.decisive) ++controls[guess.control];
    for (const auto& [control, score] : guess.scores) sums[control] += score;
  }
  const auto agree = [decided](std::size_t count) { return count == decided || (count >= 3 && 4 * count >= 3 * decided); };
  for (const auto& [control, count] : controls)
    if (agree(count)) return {control, {}};
  for (const auto& [dialect, count] : dialects)
    if (agree(count) && count >= 2) return {{}, dialect};
  if (decided != 0 || sums.empty()) return {};
  return {std::min_element(sums.begin(), sums.end(), stands_before<std::pair<const std::string, double>>)->first, {}};
}

bool may_be(const Guess& guess, const CommonGuess& neighbours, bool same_ending) {
  constexpr double most_below = 6;
  const auto score_in = [](const auto& scores, const std::string& id) {
    const auto found = std::find_if(scores.begin(), scores.end(), [&](const auto& row) { return row.first == id; });
    return found == scores.end() ? -decisive_weight : found->second;
  };
  if (!neighbours.dialect.empty()) return score_in(guess.dialect_scores, neighbours.dialect) >= (same_ending ? 0 : 1);
  return score_in(guess.scores, neighbours.control) + most_below >= score_in(guess.scores, guess.control);
}

}  // namespace kadr
