#pragma once
// Which control a program was written for, guessed from its text and its name; or which language that Kadr does not read it is in.

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/guess_rows.h"

namespace kadr {

struct Guess {
  std::string control;                   // empty: none that Kadr knows
  std::string dialect;                   // the language it is in instead, an id of controls/dialects.toml; empty: none
  std::string language_en, language_ru;  // what that is called
  std::vector<std::string> refused_by;   // controls that Kadr reads as something else than this language: a lathe's as a mill's
  std::string reason_en;                 // what in the text speaks for it, and in which lines, in their order
  std::string reason_ru;
  bool decisive = false;                                     // what speaks for it suffices; else the guess is weak
  std::vector<std::pair<std::string, double>> scores;        // of every control, in the order of their rows
  std::vector<std::pair<std::string, std::string>> reasons;  // of each of them: English, Russian

  std::vector<std::pair<std::string, double>> dialect_scores;  // of the languages, where nothing is against them

  std::map<std::string, double> strongest_marks;  // of every control

  /// Which control comes next; empty: nothing speaks for another.
  std::string runner_up() const;
};

/// `sample`: the beginning of the program, UTF-8. `path`: its name and the folder it lies in; empty: it has none.
/// `own`: rows of controls of one's own beside the built-in ones.
Guess guess_control(std::string_view sample, std::string_view path = {}, const std::vector<GuessRows>& own = {});

/// The same among the rows of these controls and languages alone.
Guess guess_among(std::string_view sample, std::string_view path, const std::vector<GuessRows>& controls,
                  const std::vector<GuessRows>& dialects);

/// The text is surely in a language that the named control is not read as: a lathe's program, where Kadr reads the mill. A control file
/// of one's own is taken at its word.
///   control  an id or alias
///   returns  an error sentence; empty: it is not
std::string refused_by_control(std::string_view sample, std::string_view control, bool ru);

/// Which controls of a weak guess may be meant, the best first: something speaks for each, and not more than a trial is worth.
std::vector<std::string> candidates_of(const Guess& guess);

/// A control that finds faults in the program stands behind those that find none; where all do, nothing changes.
///   faults  of each of candidates_of(), how many alarms the reading of its beginning gave
void take_trial(Guess& guess, const std::vector<std::pair<std::string, std::size_t>>& faults);

/// What guesses of programs lying together agree in.
struct CommonGuess {
  std::string control;  // empty: none
  std::string dialect;  // a language that Kadr does not read; empty: none
};
/// What all the decisive ones name, or three quarters of three and more; a language only two and more name. Without any decisive one the
/// control with the greatest sum of scores. Both empty: they do not agree.
CommonGuess common_guess(const std::vector<Guess>& guesses);

/// A weak guess may be what its neighbours are: nothing much in it speaks against that.
///   same_ending  the names of both end alike; else something in the text must speak for a language that Kadr does not read
bool may_be(const Guess& guess, const CommonGuess& neighbours, bool same_ending);

/// `bytes`: the beginning of a file. It reads like a part program of some control that Kadr knows.
bool is_program_text(std::string_view bytes);

}  // namespace kadr
