#pragma once
// Which control a program was written for, guessed from its text.

#include <string>
#include <string_view>

namespace kadr {

struct Guess {
  std::string control;    // empty: none that Kadr knows
  std::string reason_en;  // what in the text speaks for it, and in which lines
  std::string reason_ru;
};

/// `sample`: the beginning of the program, UTF-8.
Guess guess_control(std::string_view sample);

/// `bytes`: the beginning of a file. It reads like a part program of some control that Kadr knows.
bool is_program_text(std::string_view bytes);

}  // namespace kadr
