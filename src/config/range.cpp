// Permitted ranges of numbers in set-ups, machine files and control files. Used by the rest of config.

#include "config/range.h"

namespace kadr {

std::string range_in_words(const NumberRange& range) {
  if (range.least == ranges::any.least && range.most == ranges::any.most) return translated(texts::ranges::a_number);
  if (!range.unit) return translated(texts::ranges::a_number_within, range.least, range.most);
  return translated(texts::ranges::a_number_of_unit, range.least, range.most, plain_text(*range.unit));
}

}  // namespace kadr
