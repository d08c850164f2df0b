#pragma once
// Names the limits of motion/look_ahead/limited_by.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "motion/look_ahead/limited_by.h"

namespace kadr {

/// Returns the kind alone: "corner", "acceleration", ….
const char* limit_name(Limit limit, Lang lang);

/// Returns "corner, X". If the limit was not an axis but the rate itself, returns its name: programmed feed or, of a rapid, the rapid rate.
std::string limit_text(LimitedBy by, bool rapid, const std::vector<std::string>& axes, Lang lang);

}  // namespace kadr
