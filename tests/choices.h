#pragma once
// Random choices for RapidCheck properties, read one by one from a row of bytes. When RapidCheck shrinks the row to nothing, every
// further choice is the first one, so a failing program shrinks to a short and plain one.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <vector>

namespace kadr::test {

class Choices {
 public:
  explicit Choices(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}
  /// Returns a number in 0 … count - 1; 0 when the bytes are used up.
  std::size_t below(std::size_t count) {
    std::size_t number = 0;
    for (std::size_t reach = 1; reach < count; reach *= 256) number = number * 256 + next();
    return number % count;
  }
  int between(int least, int most) { return least + static_cast<int>(below(static_cast<std::size_t>(most - least) + 1)); }
  bool one_in(std::size_t count) { return below(count) + 1 == count; }  // false when the bytes are used up
  template <class T, std::size_t N>
  T of(const T (&all)[N]) {
    return all[below(N)];
  }

 private:
  std::uint8_t next() { return at_ < bytes_.size() ? bytes_[at_++] : std::uint8_t{0}; }
  std::vector<std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

/// Returns a row of at most `bytes` random bytes to choose by.
inline Choices choices(std::size_t bytes) {
  const auto all = rc::gen::resize(100, rc::gen::container<std::vector<std::uint8_t>>(bytes, rc::gen::arbitrary<std::uint8_t>()));
  return Choices(*all);
}

}  // namespace kadr::test
