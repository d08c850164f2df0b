#pragma once
// Guesses the control that a program was written for, from the program's text and name. If Kadr supports no such control, guesses the
// program language, such as that of Okuma or Fidia.

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/control/guess_rows.h"
#include "config/language.h"

namespace kadr {

struct Guess {
  std::string control;  // id of the guessed control; empty: Kadr supports no control for this program
  // Id (in controls/dialects.toml) of the program language, if it is one that Kadr does not read; else empty.
  std::string dialect;
  std::string language_en, language_ru;  // name of the program language `dialect`, for people
  // Controls that would execute such a program wrongly: for a lathe program, a control that Kadr reads as a mill.
  std::vector<std::string> refused_by;
  std::string refusal_en, refusal_ru;  // the evidence for `refused_by`; empty if `refused_by` is empty
  std::string reason_en;  // sentence with the evidence for the guess; it names the program's lines in ascending order
  std::string reason_ru;
  bool decisive = false;  // true if the evidence for the guessed control is sufficient; false: the guess is weak
  std::vector<std::pair<std::string, double>> scores;        // score of each control, in the order of the controls' rows
  std::vector<std::pair<std::string, std::string>> reasons;  // evidence for each control, as sentences in English and Russian

  // Score of each program language that Kadr does not read; only if the guess is a control.
  std::vector<std::pair<std::string, double>> dialect_scores;

  std::map<std::string, double> strongest_marks;  // for each control, the greatest weight of a mark (GuessMark) that the text contains

  /// Returns the control with the second best score; empty if no evidence points to a second control.
  std::string runner_up() const;
};

/// Guesses the control of a program. `sample`: the start of the program, UTF-8. `path`: folder and name of the program; may be empty.
/// `own`: rows of the user's own controls, which are considered in addition to the built-in ones.
Guess guess_control(std::string_view sample, std::string_view path = {}, const std::vector<GuessRows>& own = {});

/// Guesses the control of a program as guess_control() does, but considers only the given controls and program languages.
Guess guess_among(std::string_view sample, std::string_view path, const std::vector<GuessRows>& controls,
                  const std::vector<GuessRows>& dialects);

/// Checks whether the text is certainly in a program language for which the given control must not be used, such as a lathe program if Kadr
/// reads the control as a mill. A control file of the user's own is never refused.
///   control  id or alias of the control
///   returns  an error sentence that names the control for such programs; empty if the control may be used
std::string refused_by_control(std::string_view sample, std::string_view control, Lang lang);

/// Returns the controls that a weak guess leaves possible, most likely first. There are at most five, few enough to try them all. Each
/// of these controls has some evidence, except for Mach3, the default guess, which may be listed without evidence.
std::vector<std::string> candidates_of(const Guess& guess);

/// Lowers the score of each control under which the program's start has faults. If the start has faults under all of them, nothing changes.
///   faults  each control of candidates_of(), with the number of alarms while the program's start was read
void take_trial(Guess& guess, const std::vector<std::pair<std::string, std::size_t>>& faults);

/// What the guesses for the programs of one folder have in common.
struct CommonGuess {
  std::string control;  // id of the common control; empty: the guesses have no common control
  std::string dialect;  // id of the common program language that Kadr does not read; empty: the guesses have no such language in common
};
/// Returns the control, or the program language that Kadr does not read, that all decisive guesses name; of three or more decisive guesses,
/// three quarters suffice. A program language must be named by at least two guesses. Without a decisive guess, returns the control with the
/// greatest sum of scores. Both members are empty if the guesses disagree.
CommonGuess common_guess(const std::vector<Guess>& guesses);

/// Returns true if a program with a weak guess may be for the same control as its neighbours, because its text has no strong evidence
/// against this control.
///   same_ending  the file names have the same ending; if not, a program language that Kadr does not read also needs evidence in the text
bool may_be(const Guess& guess, const CommonGuess& neighbours, bool same_ending);

/// Returns true if `bytes`, the start of a file, reads like a part program of some control that Kadr supports.
bool is_program_text(std::string_view bytes);

}  // namespace kadr
