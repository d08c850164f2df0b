#pragma once
// Names the speed limits that motion/look_ahead/limited_by reports.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "motion/look_ahead/limited_by.h"

namespace kadr {

/// Returns the type of the limit alone: "corner", "acceleration", ….
const char* limit_name(Limit limit, Lang lang);

/// Returns "corner, X". If no axis was the limit but the commanded speed itself, returns "programmed feed" or, for a rapid, "rapid rate".
std::string limit_text(LimitedBy by, bool rapid, const std::vector<std::string>& axes, Lang lang);

}  // namespace kadr
