#pragma once
// Wire: a serial line with a baud rate, for tests on a simulated clock.

#include <algorithm>
#include <deque>
#include <optional>
#include <string_view>

namespace kadr::drive::test {

/// A serial line in one direction: bytes arrive one after the other at the baud rate.
class Wire {
 public:
  explicit Wire(double baud = 115200) : byte_seconds_(10 / baud) {}
  void send(std::string_view bytes, double now) {
    for (const char byte : bytes) {
      free_at_ = std::max(free_at_, now) + byte_seconds_;
      bytes_.push_back({free_at_, byte});
    }
  }
  /// Returns the next byte that has arrived.
  std::optional<char> next(double now) {
    if (bytes_.empty() || bytes_.front().at > now) return std::nullopt;
    const char byte = bytes_.front().byte;
    bytes_.pop_front();
    return byte;
  }
  void clear() { bytes_.clear(); }

 private:
  struct Flying {
    double at;
    char byte;
  };
  double byte_seconds_, free_at_ = 0;
  std::deque<Flying> bytes_;
};

}  // namespace kadr::drive::test
