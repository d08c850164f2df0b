#pragma once
// Which control a program was written for, guessed from its text.

#include <string>
#include <string_view>

namespace kadr {

struct Guess {
  std::string control;
  std::string reason_en;  // what in the text speaks for it
  std::string reason_ru;
};

/// `sample`: the beginning of the program, UTF-8.
Guess guess_control(std::string_view sample);

}  // namespace kadr
