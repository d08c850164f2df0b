#pragma once
// Describes the result of a comparison in words.

#include <string>

#include "compare/comparison.h"
#include "config/alarm_texts.h"

namespace kadr {

/// Returns the difference in words, for example "feed: F100 mm/min, F200 mm/min", or "another way: up to 0.5 mm apart".
std::string sentence_of(const CourseDifference& d, Lang lang);
/// Returns the result of the comparison in words, for example "equal: 412 motions, greatest distance 0.0004 mm".
std::string summary_of(const Comparison& c, Lang lang);
/// Returns the kind of difference as a key for programs that read the output: "way", "feed", ….
const char* name_of(CourseDifference::Kind kind);

}  // namespace kadr
