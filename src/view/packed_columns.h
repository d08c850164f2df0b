#pragma once
// PackedColumns: stores the numbers of a report column by column in a form that compresses well: as differences with the sign in the lowest
// bit, first all least significant bytes, then all next ones, … (docs/panel-protocol.md, A report).

#include <cstdint>
#include <span>
#include <string>
#include <tl/expected.hpp>

namespace kadr {

class PackedColumns {
 public:
  void put_u32(std::uint32_t value);
  void put_f64(double value);
  /// Differences are computed modulo 2³².
  void put(std::span<const std::int32_t> column);
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Converts a value to multiples of `unit`; NaN and infinity become 0.
///   pre  |value| ≤ 2e9 · unit
std::int32_t in_steps(double value, double unit);
/// Returns `unit`, or the multiple of it that values up to `most` need.
double unit_for(double unit, double most);

/// Compresses to a zlib stream.
///   returns  an error sentence if this machine has no zlib
tl::expected<std::string, std::string> zlib_packed(std::string_view bytes);

}  // namespace kadr
