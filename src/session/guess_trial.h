#pragma once
// A weak guess of a control is tried: the controls that may be meant read the beginning of the program; one that finds nothing wrong in its
// codes and words wins over one that does.

#include <string_view>

#include "config/guess.h"

namespace kadr {

/// A decisive guess, and one of nothing that Kadr reads, stay as they are.
///   sample  the beginning of the program, UTF-8; no more than some hundred lines of it are read
void try_guess(Guess& guess, std::string_view sample);

}  // namespace kadr
