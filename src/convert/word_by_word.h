#pragma once
// Rewrites a program block by block for the target control. Expands lines into single motions only where that control cannot express them
// or would do something else. An expanded range starts where the proof fails and grows only as far as needed: the line, its loop, the
// call that executes it.

#include "convert/conversion.h"

namespace kadr {

class Proving;

/// Returns the best result, proven or not.
///   shape    structure of the source program
///   returns  an error sentence if a session could not be opened
tl::expected<ConversionTry, std::string> word_by_word(const ConversionSpec& spec, const ProgramShape& shape, const Proving& proving);

}  // namespace kadr
