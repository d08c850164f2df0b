#pragma once
// The limits of motion/look_ahead/limited_by in words.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "motion/look_ahead/limited_by.h"

namespace kadr {

/// "corner", "acceleration", …: the kind alone.
const char* limit_name(Limit limit, Lang lang);

/// "corner, X"; of the feed, where the axes were not what limits: that of a rapid is another.
std::string limit_text(LimitedBy by, bool rapid, const std::vector<std::string>& axes, Lang lang);

}  // namespace kadr
