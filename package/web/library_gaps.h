#pragma once
// What the standard library of Debian 12's Emscripten (libc++ 13) lacks of C++20, and Kadr uses. Each file of a build for browsers includes
// this file first; a newer library has these functions, and then nothing is added.

#ifdef __cplusplus

#include <fast_float/fast_float.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>
#include <type_traits>
#include <version>

namespace std {

#ifndef __cpp_lib_bit_cast
template <class To, class From>
To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>);
  To to;
  memcpy(&to, &from, sizeof to);
  return to;
}
#endif

#ifndef __cpp_lib_smart_ptr_for_overwrite
template <class Array>
unique_ptr<Array> make_unique_for_overwrite(size_t size) {
  return unique_ptr<Array>(new remove_extent_t<Array>[size]);
}
#endif

#ifndef __cpp_lib_atomic_ref
/// There are no threads, so every access is atomic.
template <class Value>
class atomic_ref {
 public:
  explicit atomic_ref(Value& value) : value_(value) {}
  template <class Order>
  Value fetch_add(Value by, Order) {
    const Value before = value_;
    value_ += by;
    return before;
  }

 private:
  Value& value_;
};
#endif

#ifndef __cpp_lib_to_chars
/// A number that is too great or too small is an error, and leaves `value` as it is.
template <class Value>
enable_if_t<is_floating_point_v<Value>, from_chars_result> from_chars(const char* first, const char* last, Value& value) {
  Value read = 0;
  const fast_float::from_chars_result got = fast_float::from_chars(first, last, read);
  if (got.ec != errc()) return {got.ptr, got.ec};
  // the words inf and nan have letters, and a number that is too great has a digit
  const auto has = [&](char from, char until) {
    for (const char* at = first; at < got.ptr; ++at)
      if (*at >= from && *at <= until) return true;
    return false;
  };
  if (isinf(read) && has('0', '9')) return {got.ptr, errc::result_out_of_range};
  if (read == 0)  // is there a digit before the exponent that is not 0?
    for (const char* at = first; at < got.ptr && (*at | 0x20) != 'e'; ++at)
      if (*at >= '1' && *at <= '9') return {got.ptr, errc::result_out_of_range};
  value = read;
  return {got.ptr, errc()};
}
#endif

}  // namespace std

#endif
