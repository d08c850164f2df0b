// Permitted ranges of numbers in files, the same for set-ups, machine files and control files. Used by the rest of config.

#include "config/range.h"

#include <fmt/format.h>

#include "config/language.h"

namespace kadr {

std::string told(const NumberRange& range) {
  if (range.least == ranges::any.least && range.most == ranges::any.most) return told("a number", "число");
  const std::string unit = told(range.unit_en, range.unit_ru);
  const std::string limits = told(fmt::format("{} to {}", range.least, range.most), fmt::format("от {} до {}", range.least, range.most));
  return told("a number, ", "число ") + limits + (unit.empty() ? "" : " " + unit);
}

}  // namespace kadr
