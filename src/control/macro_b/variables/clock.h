#pragma once
// Date and time as a program reads them (spec/nct/23 23.1.9): the set-up's clock plus virtual time.

#include <string>

namespace kadr::macro_b {

/// "2014-05-18T15:32:41" → 20140518. Without a clock it is 2000-01-01, so that the same input gives the same output.
double date_number(const std::string& clock);
/// Converts "2014-05-18T15:32:41" to 153241, after adding `ms` milliseconds (the time wraps around at midnight).
double time_number(const std::string& clock, double ms);

}  // namespace kadr::macro_b
