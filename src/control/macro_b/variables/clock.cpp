// Date and time as a program reads them (spec/nct/23 23.1.9): the clock of the set-up plus virtual time. Used by
// control/macro_b/variables/system_variables.

#include "control/macro_b/variables/clock.h"

#include <cmath>
#include <cstdio>

namespace kadr::macro_b {
namespace {

struct Clock {
  int year = 2000, month = 1, day = 1, hour = 0, minute = 0, second = 0;
};

Clock read(const std::string& text) {
  Clock c;
  Clock read;
  if (std::sscanf(text.c_str(), "%d-%d-%dT%d:%d:%d", &read.year, &read.month, &read.day, &read.hour, &read.minute, &read.second) == 6)
    c = read;  // NOLINT
  return c;
}

}  // namespace

double date_number(const std::string& clock) {
  const Clock c = read(clock);
  return c.year * 10000.0 + c.month * 100.0 + c.day;
}

double time_number(const std::string& clock, double ms) {
  constexpr int seconds_per_day = 86400;
  const Clock c = read(clock);
  const long long now = (c.hour * 3600LL + c.minute * 60LL + c.second + static_cast<long long>(std::floor(ms / 1000))) % seconds_per_day;
  return static_cast<double>(now / 3600 * 10000 + now / 60 % 60 * 100 + now % 60);
}

}  // namespace kadr::macro_b
