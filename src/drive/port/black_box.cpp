// The record of a conversation with a machine. Tested by tests/drive.py.

#include "drive/port/black_box.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>

#include "config/texts.h"
#include "texts/drive.h"

namespace kadr::drive {
namespace {

int open_to_append(const std::string& path) { return ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644); }

/// Returns the bytes as one line of text: control characters and bytes above 126 become \xNN, an end of line at the end is left out.
std::string in_one_line(std::string_view bytes) {
  while (!bytes.empty() && (bytes.back() == '\n' || bytes.back() == '\r')) bytes.remove_suffix(1);
  std::string text;
  for (const char byte : bytes) {
    const auto code = static_cast<unsigned char>(byte);
    if (code >= ' ' && code < 0x7f) text += byte;
    else if (byte == '\n') text += "\\n";
    else if (byte != '\r') text += fmt::format("\\x{:02x}", code);
  }
  return text;
}

}  // namespace

tl::expected<std::unique_ptr<BlackBox>, std::string> BlackBox::open(const std::string& path) {
  const int fd = open_to_append(path);
  struct stat now {};
  if (fd < 0 || ::fstat(fd, &now) != 0) {
    const std::string why = std::strerror(errno);  // NOLINT(concurrency-mt-unsafe): glibc's is safe
    if (fd >= 0) ::close(fd);
    return tl::unexpected(translated(texts::drive::log_not_opened, path, why));
  }
  return std::unique_ptr<BlackBox>(new BlackBox(path, fd, static_cast<std::uint64_t>(now.st_size)));
}

BlackBox::~BlackBox() {
  if (fd_ >= 0) ::close(fd_);
}

void BlackBox::record(char direction, std::string_view bytes) {
  const auto now = std::chrono::system_clock::now();
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count() % 1000;
  const std::string line = fmt::format("{:%F %H:%M:%S}.{:03} {} {}\n", fmt::localtime(std::chrono::system_clock::to_time_t(now)), ms,
                                       direction, in_one_line(bytes));
  if (size_ + line.size() > most_bytes) begin_new_file();
  const ssize_t put = fd_ < 0 ? -1 : ::write(fd_, line.data(), line.size());
  if (put != static_cast<ssize_t>(line.size())) is_right_ = false;
  if (put > 0) size_ += static_cast<std::uint64_t>(put);
}

void BlackBox::begin_new_file() {
  ::close(fd_);
  (void)std::rename(path_.c_str(), (path_ + ".1").c_str());
  fd_ = open_to_append(path_);
  size_ = 0;
}

}  // namespace kadr::drive
