#pragma once
// PackedColumns: numbers of a report, column by column, as they compress best: differences, the sign in the lowest bit, then all least
// bytes, all next ones, … (docs/panel-protocol.md, A report).

#include <cstdint>
#include <span>
#include <string>
#include <tl/expected.hpp>

namespace kadr {

class PackedColumns {
 public:
  void put_u32(std::uint32_t value);
  void put_f64(double value);
  /// Differences are taken modulo 2³².
  void put(std::span<const std::int32_t> column);
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// In steps of `unit`; what is no number is 0.
///   pre  |value| ≤ 2e9 · unit
std::int32_t in_steps(double value, double unit);
/// `unit`, or as many times of it as values up to `most` need.
double unit_for(double unit, double most);

/// A stream of zlib.
///   returns  an error sentence: this machine has no zlib
tl::expected<std::string, std::string> zlib_packed(std::string_view bytes);

}  // namespace kadr
