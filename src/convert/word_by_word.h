#pragma once
// Rewrites a program block by block for the target control. A line is expanded into single motions only if that control cannot express it
// or would do something else. An expanded range starts where the proof fails and grows only as far as needed: the line, its loop, the call
// that executes it.

#include "convert/conversion.h"

namespace kadr {

class Proving;

/// Returns the best result of all rounds, proven or not.
///   shape    structure of the source program
///   returns  an error sentence if a session could not be opened
tl::expected<ConversionTry, std::string> word_by_word(const ConversionSpec& spec, const ProgramShape& shape, const Proving& proving);

}  // namespace kadr
