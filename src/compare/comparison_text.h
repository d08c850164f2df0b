#pragma once
// A comparison in words.

#include <string>

#include "compare/comparison.h"
#include "config/alarm_texts.h"

namespace kadr {

/// "feed: F100 mm/min, F200 mm/min"; "another way: up to 0.5 mm apart".
std::string sentence_of(const CourseDifference& d, Lang lang);
/// "equal: 412 motions, greatest distance 0.0004 mm".
std::string summary_of(const Comparison& c, Lang lang);
/// "way", "feed" …: for programs.
const char* name_of(CourseDifference::Kind kind);

}  // namespace kadr
