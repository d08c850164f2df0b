#pragma once
// guess_trial: improves an uncertain guess of a control. Each possible control executes the beginning of the program. A control that knows
// all codes and words there is preferred to a control that does not.

#include <string_view>

#include "config/control/guess.h"

namespace kadr {

/// Changes the guess only if it is uncertain and at least two controls are possible.
///   sample  the beginning of the program in UTF-8; only the first 200 lines are used
void try_guess(Guess& guess, std::string_view sample);

}  // namespace kadr
