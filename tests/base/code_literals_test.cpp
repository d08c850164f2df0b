// base/code_literals: the value of a literal such as 43.4_g.

#include "base/code_literals.h"

#include <gtest/gtest.h>

namespace kadr::code_literals_test {
namespace {

TEST(code_literals, are_tenths) {
  static_assert(0_g == 0 && 1_g == 10 && 43_g == 430 && 43.4_g == 434 && 5.1_g == 51 && 54.0_g == 540 && 150.9_g == 1509);
  static_assert(6_m == 60 && 198_m == 1980 && 0.5_m == 5);
  switch (std::int32_t{861}) {
    case 86.1_g: SUCCEED(); break;
    default: FAIL();
  }
}

}  // namespace
}  // namespace kadr::code_literals_test
