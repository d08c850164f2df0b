#pragma once
// Random choices for RapidCheck properties: a row of bytes read one by one. Shrinking the bytes to nothing makes every
// further choice the first one, so that a failing program shrinks to a short and plain one.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <vector>

namespace kadr::test {

class Choices {
 public:
  explicit Choices(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}
  /// A number in 0 … count - 1; 0 when the bytes are used up.
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

/// At most `bytes` choices.
inline Choices choices(std::size_t bytes) {
  const auto all = rc::gen::resize(100, rc::gen::container<std::vector<std::uint8_t>>(bytes, rc::gen::arbitrary<std::uint8_t>()));
  return Choices(*all);
}

}  // namespace kadr::test
