// Reads small files as a whole: set-up, control, machine, contour. Used by cli, config, out; tested by tests/config/read_file_test.cpp.

#include "config/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "lang/text/text_spool.h"
#include "texts/reading.h"

namespace kadr {
namespace {

struct Descriptor {
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  int number;
};

std::string file_type_in_words(mode_t mode) {
  if (S_ISREG(mode)) return {};
  if (S_ISDIR(mode)) return translated(texts::reading::a_directory);
  if (S_ISFIFO(mode)) return translated(texts::reading::a_pipe);
  if (S_ISSOCK(mode)) return translated(texts::reading::a_socket);
  return translated(texts::reading::a_device);
}

tl::unexpected<std::string> failed(const std::string& path, const std::string& why) { return tl::unexpected(path + ": " + why); }

tl::unexpected<std::string> unreadable(const std::string& path, int error) {
  return failed(path, translated(texts::reading::cannot_be_read, errno_message(error)));
}

}  // namespace

std::string file_type_in_words(const std::string& path) {
  struct stat there = {};
  return ::stat(path.c_str(), &there) == 0 ? file_type_in_words(there.st_mode) : std::string();
}

std::string errno_message(int error) {
  switch (error) {
    case ENOENT: return translated(texts::reading::no_such_file);
    case ENOTDIR: return translated(texts::reading::no_such_directory);
    case EACCES:
    case EPERM: return translated(texts::reading::permission_denied);
    case ELOOP: return translated(texts::reading::links_in_a_circle);
    case ENAMETOOLONG: return translated(texts::reading::name_too_long);
    case EIO: return translated(texts::reading::disk_fails);
    case EISDIR: return translated(texts::reading::is_a_directory);
    case EFBIG: return translated(texts::reading::too_large);
    case ENOSPC: return translated(texts::reading::disk_full);
    case EROFS: return translated(texts::reading::read_only_file_system);
    case EPIPE: return translated(texts::reading::reader_gone);
    case EEXIST: return translated(texts::reading::there_already);
    case EMSGSIZE: return translated(texts::reading::gives_too_much, limits::piped_bytes >> 20, limits::device_bytes >> 20);
    case EBADF: return translated(texts::reading::not_open);
    case EMFILE:
    case ENFILE: return translated(texts::reading::too_many_open_files);
    case ENOMEM: return translated(texts::reading::out_of_memory);
    case ENXIO: return translated(texts::reading::nobody_at_other_end);
    default: return thread_language() == Lang::en ? std::strerror(error) : translated(texts::reading::system_error, error);
  }
}

tl::expected<std::string, std::string> read_file(const std::string& path, std::size_t most, const FileAccess* door) {
  // With O_NONBLOCK, opening a FIFO does not wait until another process opens it for writing.
  const Descriptor file(door != nullptr ? door->open_for_reading(path)
                                        : ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  struct stat there = {};
  if (file.number < 0 || ::fstat(file.number, &there) != 0) {
    const int error = errno;
    if (const std::string kind = door == nullptr ? file_type_in_words(path) : std::string(); !kind.empty())
      return failed(path, translated(texts::reading::is_not_a_file, kind));
    return unreadable(path, error);
  }
  if (const std::string kind = file_type_in_words(there.st_mode); !kind.empty())
    return failed(path, translated(texts::reading::is_not_a_file, kind));
  const auto too_long = [&] { return failed(path, translated(texts::reading::too_long, most >> 20)); };
  if (static_cast<std::uintmax_t>(there.st_size) > most) return too_long();
  std::string text;
  text.reserve(static_cast<std::size_t>(there.st_size));
  char piece[1 << 16];
  for (;;) {  // reads until the end and ignores the reported size: the file may grow meanwhile, and files of /proc report size 0
    const ssize_t got = ::read(file.number, piece, sizeof piece);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return unreadable(path, errno);
    if (got == 0) return text;
    text.append(piece, static_cast<std::size_t>(got));
    if (text.size() > most) return too_long();
  }
}

std::string no_text_message(std::string_view text, const std::string& file) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return location_prefix(file, 1, 1) + translated(texts::reading::utf_16);
  const std::size_t nul = text.find('\0');
  if (nul == std::string_view::npos) return {};
  return location_prefix(file, text, nul) + translated(texts::reading::nul_byte);
}

std::string location_prefix(const std::string& file, std::size_t line, std::size_t column) {
  if (file.empty()) return translated(texts::reading::position, line, column);
  return file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
}

std::string location_prefix(const std::string& file, std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, std::min(at, text.size()));
  const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t end = before.rfind('\n');
  const std::string_view row = end == std::string_view::npos ? before : before.substr(end + 1);
  const auto column = std::count_if(row.begin(), row.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  return location_prefix(file, line + 1, static_cast<std::size_t>(column) + 1);
}

}  // namespace kadr
