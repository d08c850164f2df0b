// Reads small files as a whole: set-up, control, machine, contour. Used by cli, config, out; tested by tests/config/read_file_test.cpp.

#include "config/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "config/language.h"
#include "lang/text/text_spool.h"

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
  if (S_ISDIR(mode)) return told("a directory", "каталог");
  if (S_ISFIFO(mode)) return told("a pipe", "канал (FIFO)");
  if (S_ISSOCK(mode)) return told("a socket", "сокет");
  return told("a device", "устройство");
}

tl::unexpected<std::string> failed(const std::string& path, const std::string& en, const std::string& ru) {
  return tl::unexpected(path + ": " + told(en, ru));
}

tl::unexpected<std::string> unreadable(const std::string& path, int error) {
  const std::string why = errno_message(error);
  return failed(path, "cannot be read: " + why, "не читается: " + why);
}

}  // namespace

std::string file_type_in_words(const std::string& path) {
  struct stat there = {};
  return ::stat(path.c_str(), &there) == 0 ? file_type_in_words(there.st_mode) : std::string();
}

std::string errno_message(int error) {
  switch (error) {
    case ENOENT: return told("there is no such file", "такого файла нет");
    case ENOTDIR: return told("there is no such directory", "такого каталога нет");
    case EACCES:
    case EPERM: return told("permission denied", "нет прав доступа");
    case ELOOP: return told("its links go in a circle", "ссылки замкнуты в кольцо");
    case ENAMETOOLONG: return told("the name is too long", "слишком длинное имя");
    case EIO: return told("the disk fails", "ошибка диска");
    case EISDIR: return told("it is a directory", "это каталог");
    case EFBIG: return told("it is too large", "слишком велик");
    case ENOSPC: return told("the disk is full", "на диске нет места");
    case EROFS: return told("the file system is read-only", "файловая система только для чтения");
    case EPIPE: return told("its reader has gone", "читающая программа завершилась");
    case EEXIST: return told("it is there already", "такой файл уже есть");
    case EMSGSIZE: {
      const std::string pipe = std::to_string(limits::piped_bytes >> 20), device = std::to_string(limits::device_bytes >> 20);
      return told("it gives too much: a pipe may give " + pipe + " MiB, a device " + device + " MiB; put it into a file",
                  "слишком много: канал может дать " + pipe + " МиБ, устройство " + device + " МиБ; сохраните в файл");
    }
    case EBADF: return told("it is not open", "не открыт");
    case EMFILE:
    case ENFILE: return told("too many files are open", "открыто слишком много файлов");
    case ENOMEM: return told("out of memory", "не хватает памяти");
    case ENXIO: return told("nobody is at its other end", "с другой стороны никого нет");
    default: return told(std::strerror(error), "ошибка системы " + std::to_string(error));
  }
}

tl::expected<std::string, std::string> read_file(const std::string& path, std::size_t most, const FileAccess* door) {
  // O_NONBLOCK: opening a FIFO would block until a writer opens it.
  const Descriptor file(door != nullptr ? door->open_for_reading(path)
                                        : ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  struct stat there = {};
  if (file.number < 0 || ::fstat(file.number, &there) != 0) {
    const int error = errno;
    if (const std::string kind = door == nullptr ? file_type_in_words(path) : std::string(); !kind.empty())
      return failed(path, "is " + kind + ", not a file", "это " + kind + ", а не файл");
    return unreadable(path, error);
  }
  if (const std::string kind = file_type_in_words(there.st_mode); !kind.empty())
    return failed(path, "is " + kind + ", not a file", "это " + kind + ", а не файл");
  const std::string mebibytes = std::to_string(most >> 20);
  const auto too_long = [&] {
    return failed(path, "is longer than " + mebibytes + " MiB, the most that such a file may have",
                  "длиннее " + mebibytes + " МиБ, больше для таких файлов не допускается");
  };
  if (static_cast<std::uintmax_t>(there.st_size) > most) return too_long();
  std::string text;
  text.reserve(static_cast<std::size_t>(there.st_size));
  char piece[1 << 16];
  for (;;) {  // reads until the end, whatever size was reported: the file may grow meanwhile, and files of /proc have size 0
    const ssize_t got = ::read(file.number, piece, sizeof piece);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return unreadable(path, errno);
    if (got == 0) return text;
    text.append(piece, static_cast<std::size_t>(got));
    if (text.size() > most) return too_long();
  }
}

std::string no_text_message(std::string_view text, const std::string& file) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return location_prefix(file, 1, 1) + told("the file is UTF-16; save it as UTF-8", "файл в кодировке UTF-16, сохраните его в UTF-8");
  const std::size_t nul = text.find('\0');
  if (nul == std::string_view::npos) return {};
  return location_prefix(file, text, nul) + told("a NUL byte: this is no text", "нулевой байт: это не текст");
}

std::string location_prefix(const std::string& file, std::size_t line, std::size_t column) {
  const std::string l = std::to_string(line), c = std::to_string(column);
  if (file.empty()) return told("line " + l + ", column " + c + ": ", "строка " + l + ", позиция " + c + ": ");
  return file + ":" + l + ":" + c + ": ";
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
