#pragma once
// Rewrites a program block by block for another control, and writes it out only where that control cannot express it or would do something
// else. What is written out grows from where the proof fails, no further than needed: the line, its loop, the call that executes it.

#include "convert/conversion.h"

namespace kadr {

class Proving;

/// Returns the best result, proven or not.
///   shape    of the program
///   returns  an error sentence: a session could not be opened
tl::expected<ConversionTry, std::string> word_by_word(const ConversionSpec& spec, const ProgramShape& shape, const Proving& proving);

}  // namespace kadr
