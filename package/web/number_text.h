#pragma once
// std::to_chars of numbers with a fraction, which the standard library of Debian 12's Emscripten (libc++ 13) lacks: the fewest digits from
// which a reader gets the same number, with or without an exponent, whichever is shorter. Only 3MF files are written by it.

#ifdef __cplusplus

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <version>

#ifndef __cpp_lib_to_chars

namespace std {

template <class Value>
enable_if_t<is_floating_point_v<Value>, to_chars_result> to_chars(char* first, char* last, Value value) {
  constexpr int most_digits = sizeof(Value) == sizeof(float) ? 9 : 17;
  char with[40], plain[400];
  int digits = 0;
  do std::snprintf(with, sizeof with, "%.*e", digits, double(value));
  while (Value(is_same_v<Value, float> ? std::strtof(with, nullptr) : std::strtod(with, nullptr)) != value && ++digits < most_digits);
  const char* const exponent = std::strchr(with, 'e');
  const int power = exponent == nullptr ? 0 : std::atoi(exponent + 1);
  std::snprintf(plain, sizeof plain, "%.*f", digits > power ? digits - power : 0, double(value));
  const char* const text = exponent == nullptr || std::strlen(plain) <= std::strlen(with) ? plain : with;
  const size_t length = std::strlen(text);
  if (length > size_t(last - first)) return {last, errc::value_too_large};
  std::memcpy(first, text, length);
  return {first + length, errc()};
}

}  // namespace std

#endif
#endif
