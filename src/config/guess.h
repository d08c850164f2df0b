#pragma once
// Which control a program was written for, guessed from its text.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/guess_rows.h"

namespace kadr {

struct Guess {
  std::string control;    // empty: none that Kadr knows
  std::string reason_en;  // what in the text speaks for it, and in which lines
  std::string reason_ru;
  bool decisive = false;                               // a mark that tells the control by itself; else the guess is weak
  std::vector<std::pair<std::string, double>> scores;  // of every control, in the order of their rows
};

/// `sample`: the beginning of the program, UTF-8. `own`: rows of controls of one's own beside the built-in ones.
Guess guess_control(std::string_view sample, const std::vector<GuessRows>& own = {});

/// The control that guesses of programs lying together agree in: that of all the decisive ones, if they name one; without any decisive
/// one that with the greatest sum of scores. Empty: they do not agree.
std::string common_control(const std::vector<Guess>& guesses);

/// `bytes`: the beginning of a file. It reads like a part program of some control that Kadr knows.
bool is_program_text(std::string_view bytes);

}  // namespace kadr
