#pragma once
// Random numbers for the property tests.

#include <rapidcheck.h>

namespace kadr::test {

/// Returns a number from `least` to `most` in steps of a thousandth.
inline double any_number(int least, int most) { return *rc::gen::inRange(least * 1000, most * 1000 + 1) / 1000.0; }

}  // namespace kadr::test
