// Returns names for the speed limits of motion/look_ahead/limited_by. This file is used by out/picture/plot/plot_legend and
// out/text/lost_time_text.

#include "out/text/limit_text.h"

#include <array>

#include "texts/speed_limit_text.h"

namespace kadr {
namespace {

/// Names of the limits, in the order of the enum Limit.
constexpr std::array<PlainText, limit_count> limit_names = {texts::speed_limit_text::programmed_feed,
                                                            texts::speed_limit_text::corner,
                                                            texts::speed_limit_text::curve,
                                                            texts::speed_limit_text::axis_speed,
                                                            texts::speed_limit_text::acceleration,
                                                            texts::speed_limit_text::jerk,
                                                            texts::speed_limit_text::pause};

}  // namespace

const char* limit_name(Limit limit, Lang lang) { return plain_text(limit_names[static_cast<std::size_t>(limit)], lang); }

std::string limit_text(LimitedBy by, bool rapid, const std::vector<std::string>& axes, Lang lang) {
  if (by.limit == Limit::feed && rapid) return plain_text(texts::speed_limit_text::rapid_rate, lang);
  const bool has_axis = by.limit != Limit::feed && by.limit != Limit::pause && by.axis < axes.size();
  return limit_name(by.limit, lang) + (has_axis ? ", " + axes[by.axis] : std::string());
}

}  // namespace kadr
