#pragma once
// Word by word: a program rewritten block by block for another control, and written out only where that control cannot say it or would do
// something else. What is written out grows from where the proof fails, no further than it must: the line, its loop, the call that it is
// carried out by.

#include "convert/conversion.h"

namespace kadr {

class Proving;

/// The best that could be done; proven or not.
///   shape    of the program
///   returns  an error sentence: a session could not be opened
tl::expected<ConversionTry, std::string> word_by_word(const ConversionSpec& spec, const ProgramShape& shape, const Proving& proving);

}  // namespace kadr
