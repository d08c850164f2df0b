// Names the speed limits of motion/look_ahead/limited_by. Used by out/picture/plot/plot_legend and out/text/lost_time_text.

#include "out/text/limit_text.h"

#include <array>

namespace kadr {
namespace {

struct LimitNames {
  const char *en, *ru;
};
/// Names in the order of the enum Limit.
constexpr std::array<LimitNames, limit_count> limit_names = {{{"programmed feed", "программная подача"},
                                                              {"corner", "угол"},
                                                              {"curve", "кривизна"},
                                                              {"axis speed", "скорость оси"},
                                                              {"acceleration", "ускорение"},
                                                              {"jerk", "рывок"},
                                                              {"pause", "пауза"}}};
constexpr LimitNames rapid_rate = {"rapid rate", "быстрый ход"};

const char* in(const LimitNames& name, Lang lang) { return lang == Lang::ru ? name.ru : name.en; }

}  // namespace

const char* limit_name(Limit limit, Lang lang) { return in(limit_names[static_cast<std::size_t>(limit)], lang); }

std::string limit_text(LimitedBy by, bool rapid, const std::vector<std::string>& axes, Lang lang) {
  if (by.limit == Limit::feed) return in(rapid ? rapid_rate : limit_names[0], lang);
  const bool has_axis = by.limit != Limit::pause && by.axis < axes.size();
  return limit_name(by.limit, lang) + (has_axis ? ", " + axes[by.axis] : std::string());
}

}  // namespace kadr
