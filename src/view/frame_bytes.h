#pragma once
// FrameBytes: builds a binary frame (message) for the page, value by value in little-endian order.

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

namespace kadr {

class FrameBytes {
 public:
  static_assert(std::endian::native == std::endian::little, "frames are written as they lie in memory");

  FrameBytes(std::uint32_t kind, std::uint32_t which, std::uint32_t count, std::uint32_t more) {
    put(kind), put(which), put(count), put(more);
  }

  template <class T>
  void put(T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    bytes_.append(bytes, sizeof value);
  }
  /// Appends `count` values that are stored consecutively in memory.
  template <class T>
  void put_all(const T* values, std::size_t count) {
    if (count != 0) bytes_.append(reinterpret_cast<const char*>(values), count * sizeof(T));
  }
  void reserve(std::size_t bytes) { bytes_.reserve(bytes); }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace kadr
