#pragma once
// Literals for the numbers of G and M codes. Words and table rows store these numbers in tenths: 43.4_g is 434, 6_m is 60.

#include <cstdint>

namespace kadr {

/// Returns ten times the number that the literal's characters state; the literal has at most one decimal.
template <char... Digits>
consteval std::int32_t tenths_of_code() {
  std::int32_t tenths = 0, decimals = -1;
  for (const char c : {Digits...}) {
    if (c == '.' && decimals < 0) {
      decimals = 0;
    } else {
      if (c < '0' || c > '9' || decimals > 0) throw "a code is written as 43 or 43.4";
      tenths = 10 * tenths + (c - '0');
      decimals += decimals < 0 ? 0 : 1;
    }
  }
  return decimals > 0 ? tenths : 10 * tenths;
}

template <char... Digits>
consteval std::int32_t operator""_g() {
  return tenths_of_code<Digits...>();
}

template <char... Digits>
consteval std::int32_t operator""_m() {
  return tenths_of_code<Digits...>();
}

}  // namespace kadr
