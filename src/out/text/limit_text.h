#pragma once
// Returns names for the speed limits that motion/look_ahead/limited_by reports.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "motion/look_ahead/limited_by.h"

namespace kadr {

/// Returns the type of the limit without the axis: "corner", "acceleration", ….
const char* limit_name(Limit limit, Lang lang);

/// Returns the limit with its axis, e.g. "corner, X". If only the commanded speed limited the motion, the function returns "programmed
/// feed" or, for a rapid, "rapid rate".
std::string limit_text(LimitedBy by, bool rapid, const std::vector<std::string>& axes, Lang lang);

}  // namespace kadr
