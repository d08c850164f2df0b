#pragma once
// BlackBox: a file with everything that was sent to a machine and that came back, with times. Each record is written by one call of the
// system, at once, so that the file is complete when the process is killed. (If the computer loses power, the last seconds may be lost.)
//
//   2026-11-30 08:15:02.114 > G1X10Y5F600
//   2026-11-30 08:15:02.117 < ok
//   2026-11-30 08:15:02.300 * hold: line 12

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace kadr::drive {

class BlackBox {
 public:
  /// Opens the file, and appends to it. Returns an error sentence if it cannot be written.
  static tl::expected<std::unique_ptr<BlackBox>, std::string> open(const std::string& path);
  ~BlackBox();
  BlackBox(const BlackBox&) = delete;
  BlackBox& operator=(const BlackBox&) = delete;

  void sent(std::string_view bytes) { record('>', bytes); }
  void received(std::string_view bytes) { record('<', bytes); }
  void note(std::string_view text) { record('*', text); }
  /// False after a write has failed, for example because the disk is full.
  bool is_right() const { return is_right_; }

  // When the file is this long, it becomes FILE.1 and a new file begins; an older FILE.1 is replaced.
  static constexpr std::uint64_t most_bytes = 64U << 20;

 private:
  BlackBox(std::string path, int fd, std::uint64_t size) : path_(std::move(path)), fd_(fd), size_(size) {}
  void record(char direction, std::string_view bytes);
  void begin_new_file();

  std::string path_;
  int fd_;
  std::uint64_t size_;
  bool is_right_ = true;
};

}  // namespace kadr::drive
