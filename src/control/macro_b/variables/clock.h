#pragma once
// Date and time that a program reads (spec/nct/23 23.1.9): the set-up's clock plus virtual time.

#include <string>

namespace kadr::macro_b {

/// "2014-05-18T15:32:41" → 20140518. Nothing given: 2000-01-01, so that the same input gives the same output.
double date_number(const std::string& clock);
/// The same → 153241, `ms` later (within the day).
double time_number(const std::string& clock, double ms);

}  // namespace kadr::macro_b
