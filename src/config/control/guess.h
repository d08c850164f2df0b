#pragma once
// Guesses from a program's text and name which control the program was written for, or, if Kadr supports no such control, in which
// language the program is written.

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/control/guess_rows.h"
#include "config/language.h"

namespace kadr {

struct Guess {
  std::string control;  // id of the guessed control; empty: the program is for no control that Kadr supports
  // Id (in controls/dialects.toml) of the program's language, if Kadr does not read that language; else empty.
  std::string dialect;
  std::string language_en, language_ru;  // name of that language
  // Controls that would read such a text wrongly: for a lathe program, a control that Kadr reads as a mill
  std::vector<std::string> refused_by;
  std::string reason_en;  // the evidence in the text, with its lines, in order of lines
  std::string reason_ru;
  bool decisive = false;                                     // the evidence suffices; if false, the guess is weak
  std::vector<std::pair<std::string, double>> scores;        // score of every control, in the order of the controls' rows
  std::vector<std::pair<std::string, std::string>> reasons;  // evidence for every control as sentences in English and Russian

  // Score of every language that Kadr does not read; only if the guess is a control
  std::vector<std::pair<std::string, double>> dialect_scores;

  std::map<std::string, double> strongest_marks;  // for every control, the greatest weight of a mark (GuessMark) found in the text

  /// Returns the control with the next best score; empty if no evidence points to another one.
  std::string runner_up() const;
};

/// Guesses the control of a program. `sample`: the start of the program, UTF-8. `path`: its folder and name, may be empty. `own`: rows of
/// the user's own controls, in addition to the built-in ones.
Guess guess_control(std::string_view sample, std::string_view path = {}, const std::vector<GuessRows>& own = {});

/// Like guess_control(), with only these controls and languages.
Guess guess_among(std::string_view sample, std::string_view path, const std::vector<GuessRows>& controls,
                  const std::vector<GuessRows>& dialects);

/// Checks whether the text is certainly in a language for which the named control must not be used: a lathe program, where Kadr reads the
/// control as a mill. A control file of the user's own is never refused.
///   control  an id or alias
///   returns  an error sentence; empty if the control may be used
std::string refused_by_control(std::string_view sample, std::string_view control, Lang lang);

/// Returns the controls that a weak guess leaves possible, most likely first: each has some evidence, and there are few enough to try
/// them all.
std::vector<std::string> candidates_of(const Guess& guess);

/// Lowers the score of the controls whose trial reading found faults in the program. If all of them found faults, nothing changes.
///   faults  for each of candidates_of(), the number of alarms in reading the program's start
void take_trial(Guess& guess, const std::vector<std::pair<std::string, std::size_t>>& faults);

/// What the guesses for neighbouring programs have in common.
struct CommonGuess {
  std::string control;  // the common control; empty if there is none
  std::string dialect;  // a language that Kadr does not read; empty if there is none
};
/// Returns the control or language that all decisive guesses name, or at least three quarters of them if there are three or more. A
/// language must be named by at least two guesses. Without a decisive guess, returns the control with the greatest sum of scores. Both
/// fields are empty if the guesses disagree.
CommonGuess common_guess(const std::vector<Guess>& guesses);

/// Returns true if a program with a weak guess may be for the same control as its neighbours: its text has no strong evidence against it.
///   same_ending  the file names have the same ending; if not, a language that Kadr does not read also needs some evidence in the text
bool may_be(const Guess& guess, const CommonGuess& neighbours, bool same_ending);

/// Returns true if `bytes`, the start of a file, reads like a part program of some control that Kadr supports.
bool is_program_text(std::string_view bytes);

}  // namespace kadr
