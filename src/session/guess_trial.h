#pragma once
// guess_trial: improves an uncertain guess of a control. Each possible control reads the beginning of the program; a control that knows
// all codes and words there is preferred to one that does not.

#include <string_view>

#include "config/control/guess.h"

namespace kadr {

/// Does not change the guess if it is certain, or if Kadr cannot read files of this kind.
///   sample  the beginning of the program, UTF-8; only some hundred lines are read
void try_guess(Guess& guess, std::string_view sample);

}  // namespace kadr
