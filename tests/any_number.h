#pragma once
// A random number for the property tests.

#include <rapidcheck.h>

namespace kadr::test {

/// From `least` to `most`, in thousandths.
inline double any_number(int least, int most) { return *rc::gen::inRange(least * 1000, most * 1000 + 1) / 1000.0; }

}  // namespace kadr::test
