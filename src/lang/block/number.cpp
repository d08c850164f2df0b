// Reads numbers with more digits than a double represents exactly. fast_float rounds them correctly.

#include <fast_float/fast_float.h>

#include "lang/expression/expression.h"

namespace kadr {

bool read_long_number(std::string_view digits, Number& number) {
  const char* const last = digits.data() + digits.size();
  // fast_float requires a digit before the decimal point, so a 0 is inserted if there is none.
  const char* first = digits.data();
  std::string buffer;
  if (*first == '.') {
    buffer.assign("0").append(digits);
    const auto parsed = fast_float::from_chars(buffer.data(), buffer.data() + buffer.size(), number.value);
    if (parsed.ec != std::errc()) return false;
  } else if (fast_float::from_chars(first, last, number.value).ec != std::errc()) {
    return false;
  }
  std::string whole;
  for (const char c : digits)
    if (c != '.') whole += c;
  return fast_float::from_chars(whole.data(), whole.data() + whole.size(), number.mantissa).ec == std::errc();
}

}  // namespace kadr
