#pragma once
// LineMarks: a rough record of the lines that a run has reached; one mark stands for 32 lines. A search for a line can skip a run that has
// no mark for the line.

#include <array>
#include <cstdint>

namespace kadr {

class LineMarks {
 public:
  static constexpr std::uint32_t lines_a_mark = 32, marks = 1U << 15;  // marks for a million lines; further lines use the same marks again

  void note(std::uint16_t file, std::uint32_t line) {
    const std::uint32_t mark = mark_of(file, line);
    bits_[mark / 64] |= std::uint64_t{1} << mark % 64;
    ++blocks_;
  }
  /// Returns false if the run has certainly not reached the line, and true if the run may have reached it.
  bool may_hold(std::uint16_t file, std::uint32_t line) const {
    const std::uint32_t mark = mark_of(file, line);
    return (bits_[mark / 64] >> mark % 64 & 1U) != 0;
  }
  /// Returns the number of blocks for which the run has recorded a mark.
  std::uint64_t blocks() const { return blocks_; }
  /// Adds the marks of another run to the marks of this run.
  void add(const LineMarks& other) {
    for (std::size_t i = 0; i < bits_.size(); ++i) bits_[i] |= other.bits_[i];
    blocks_ += other.blocks_;
  }

 private:
  static std::uint32_t mark_of(std::uint16_t file, std::uint32_t line) { return (line / lines_a_mark + file * 7919U) % marks; }

  std::array<std::uint64_t, marks / 64> bits_{};
  std::uint64_t blocks_ = 0;
};

}  // namespace kadr
