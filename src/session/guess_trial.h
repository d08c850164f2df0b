#pragma once
// guess_trial: checks a weak guess of a control. Each control that is possible reads the beginning of the program; one that reports no
// unknown code or word is preferred to one that does.

#include <string_view>

#include "config/guess.h"

namespace kadr {

/// Leaves the guess as it is if it is decisive, or if Kadr reads no such file.
///   sample  the beginning of the program, UTF-8; only some hundred lines of it are read
void try_guess(Guess& guess, std::string_view sample);

}  // namespace kadr
