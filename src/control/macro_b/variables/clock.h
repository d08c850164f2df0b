#pragma once
// Date and time as a program reads them (spec/nct/23 23.1.9): the clock of the set-up plus virtual time.

#include <string>

namespace kadr::macro_b {

/// Converts the date of a clock text, "2014-05-18T15:32:41", to the number 20140518. An empty text means 2000-01-01, so that the same input
/// gives the same output.
double date_number(const std::string& clock);
/// Converts the time of a clock text, "2014-05-18T15:32:41", to the number 153241, after adding `ms` milliseconds. After 23:59:59 the time
/// continues at 0.
double time_number(const std::string& clock, double ms);

}  // namespace kadr::macro_b
