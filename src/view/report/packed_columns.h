#pragma once
// PackedColumns: stores the numbers of a report column by column, in a form that can be compressed well. For each column it stores the
// differences of successive numbers, with the sign in the lowest bit: first the least significant bytes of all differences, then the next
// bytes of all differences, and so on (docs/panel-protocol.md, A report).

#include <cstdint>
#include <span>
#include <string>
#include <tl/expected.hpp>

namespace kadr {

class PackedColumns {
 public:
  void put_u32(std::uint32_t value);
  void put_f64(double value);
  /// Appends a column. Differences are computed modulo 2³², so that each difference fits into 32 bits.
  void put(std::span<const std::int32_t> column);
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Returns the value as a number of multiples of `unit`, rounded to the nearest integer; 0 for NaN and infinity.
///   pre  |value| ≤ 2e9 · unit
std::int32_t in_steps(double value, double unit);
/// Returns `unit`, or the smallest multiple of `unit` with which in_steps() can convert values up to `most`.
double unit_for(double unit, double most);

/// Compresses the bytes to a zlib stream.
///   returns  the stream, or an error sentence if zlib is missing on this computer
tl::expected<std::string, std::string> zlib_packed(std::string_view bytes);

}  // namespace kadr
