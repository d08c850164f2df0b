#pragma once
// MotionRows: stores motions as rows of bytes, which numpy reads as a structured array (kadr/motions.py defines the same fields).

#include <kadr/kadr.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace kadr::python {

/// The fixed fields of a row. After them come four values for each axis: start and end in work coordinates, start and end in machine
/// coordinates.
struct MotionRow {
  double begins = 0, seconds = 0, length = 0, feed = 0;  // units: s, s, mm, mm/min
  double center_x = 0, center_y = 0, turns = 0;          // of an arc: its centre in its plane, mm; swept angle / 360°
  std::uint32_t line = 0;
  std::int32_t block = -1;  // block number N; -1: none
  std::uint32_t tool = 0;
  std::uint16_t file = 0;
  std::uint8_t kind = 0, channel = 1;
};
static_assert(sizeof(MotionRow) == 72);  // kadr/motions.py relies on this size

/// Copies share their rows: a snapshot therefore needs little memory.
class MotionRows {
 public:
  explicit MotionRows(std::size_t axes) : axes_(axes) {}
  void add(const Step& step, const Motion& motion, std::uint32_t tool, int channel);
  std::size_t size() const { return count_; }
  void append_to(std::string& bytes) const;
  std::size_t bytes() const { return count_ * row_bytes(); }

 private:
  static constexpr std::size_t rows_of_chunk = 1024;
  std::size_t row_bytes() const { return sizeof(MotionRow) + 4 * axes_ * sizeof(double); }
  std::string& last_chunk();

  std::size_t axes_;
  std::size_t count_ = 0;
  std::vector<std::shared_ptr<std::string>> chunks_;
};

}  // namespace kadr::python
