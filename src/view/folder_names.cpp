// Names of files beneath the served folder. Used by view/served_folder and view/folder_changes; tested by tests/view/served_folder_test.cpp
// and tests/serve_files.py.

#include "view/folder_names.h"

#include <dirent.h>
#include <fmt/core.h>
#ifdef __linux__
#include <linux/openat2.h>
#include <sys/syscall.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <memory>

#include "base/ascii.h"
#include "config/read_file.h"
#include "out/text/source_line.h"
#include "texts/view.h"
#include "view/served_folder.h"

namespace kadr::served {
namespace {

constexpr std::size_t longest_name =
    200;  // bytes; file systems allow 255, and the unfinished copy of a file has a longer name than the file

/// Returns the name in lower case, as Windows compares names: ASCII and Cyrillic letters.
std::string folded(std::string_view name) {
  std::string low;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto byte = static_cast<unsigned char>(name[i]), next = static_cast<unsigned char>(i + 1 < name.size() ? name[i + 1] : '\0');
    if (byte == 0xd0 && next >= 0x90 && next <= 0xaf) {  // А … Я in UTF-8
      const unsigned letter = 0x410U + next - 0x90U + 0x20U;
      low += static_cast<char>(0xc0U | (letter >> 6U));
      low += static_cast<char>(0x80U | (letter & 0x3fU));
      ++i;
    } else {
      low += to_lower(name[i]);
    }
  }
  return low;
}

/// Returns true for names that Windows does not allow: its special characters, names of devices with or without an ending, a dot or a space
/// at the end.
bool is_refused_by_windows(std::string_view name) {
  constexpr std::string_view special = "<>:\"|?*\\";
  if (name.find_first_of(special) != std::string_view::npos) return true;
  if (name.front() == ' ' || name.back() == ' ' || name.back() == '.') return true;
  const std::string front = folded(name.substr(0, name.find('.')));
  constexpr std::array devices = {"con", "prn", "aux", "nul"};
  if (std::find(devices.begin(), devices.end(), front) != devices.end()) return true;
  return front.size() == 4 && (front.starts_with("com") || front.starts_with("lpt")) && front[3] >= '1' && front[3] <= '9';
}

/// Returns another name in the folder that is the same in lower case; empty if there is none.
std::string same_in_other_case(const OpenFile& folder, const std::string& last, const std::string& besides) {
  const std::unique_ptr<DIR, int (*)(DIR*)> rows(::fdopendir(open(folder.fd(), "", O_RDONLY | O_DIRECTORY).release()), ::closedir);
  const std::string wanted = folded(last);
  while (const dirent* const row = rows ? ::readdir(rows.get()) : nullptr) {
    const std::string name = row->d_name;
    if (name != last && name != besides && folded(name) == wanted) return name;
  }
  return {};
}

}  // namespace

OpenFile::~OpenFile() {
  if (fd_ >= 0) ::close(fd_);
}

OpenFile open_by_parts(int folder, const std::string& name, int flags, mode_t mode) {
  constexpr int always = O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW;
  OpenFile parent(-1);
  int at = folder;
  for (std::size_t begin = 0;;) {
    const std::size_t end = name.find('/', begin);
    const std::string part = name.empty() ? "." : name.substr(begin, end - begin);
    if (part.empty() || part == "..") {  // begins with a slash, or leads upwards
      errno = EXDEV;
      return OpenFile(-1);
    }
    if (end == std::string::npos) return OpenFile(::openat(at, part.c_str(), flags | always, mode));
    OpenFile next(::openat(at, part.c_str(), O_RDONLY | O_DIRECTORY | always));
    if (!next.is_open()) return next;
    parent.replace(std::move(next));
    at = parent.fd();
    begin = end + 1;
  }
}

OpenFile open(int folder, const std::string& name, int flags, mode_t mode) {
#ifdef __linux__
  open_how how{};
  how.flags = std::uint64_t(flags) | O_CLOEXEC | O_NONBLOCK;
  how.mode = mode;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS;
  const long opened = ::syscall(SYS_openat2, folder, name.empty() ? "." : name.c_str(), &how, sizeof how);
  if (opened >= 0 || errno != ENOSYS) return OpenFile(int(opened));  // known since Linux 5.6
#endif
  return open_by_parts(folder, name, flags, mode);
}

bool is_hidden(std::string_view name) {
  if (name.empty() || name.find('\0') != std::string_view::npos || name.front() == '/') return true;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    if (end == begin || name[begin] == '.') return true;
    begin = end + 1;
  }
  return false;
}

bool is_plain_name(std::string_view name) { return visible_name(name) == name; }

std::string ending_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  std::string ending(dot == std::string_view::npos ? std::string_view() : name.substr(dot + 1));
  std::transform(ending.begin(), ending.end(), ending.begin(), to_lower);
  return ending;
}

bool is_with_programs(std::string_view name) {
  constexpr std::array endings = {"stl", "3mf", "ply", "dxf", "svg", "ini", "var", "csv"};
  return std::find(endings.begin(), endings.end(), ending_of(name)) != endings.end();
}

std::string refusal(const std::string& file) { return translated(texts::view::not_of_folder, file); }

std::string of_errno(const std::string& file, int error) {
  if (error == EXDEV || error == ELOOP) return refusal(file);
  return fmt::format("{}: {}", file, errno_message(error));
}

std::string folder_part(const std::string& file) {
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? std::string() : file.substr(0, slash);
}

std::string last_part(const std::string& file) { return file.substr(file.rfind('/') + 1); }

std::string fault_of_new_name(const OpenFile& folder, const std::string& last, const std::string& besides) {
  if (kind_of_file(last) == FolderEntry::Kind::other && !is_with_programs(last)) return translated(texts::view::not_a_name_to_save, last);
  if (last.size() > longest_name) return translated(texts::view::name_too_long, last, longest_name);
  if (is_refused_by_windows(last)) return translated(texts::view::not_for_windows, last);
  const std::string other = same_in_other_case(folder, last, besides);
  return other.empty() ? std::string() : translated(texts::view::differs_by_case, last, other);
}

int rename_to_new(const OpenFile& from_folder, const std::string& from, const OpenFile& to_folder, const std::string& to) {
#ifdef __linux__
  if (::renameat2(from_folder.fd(), from.c_str(), to_folder.fd(), to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
#endif
  // The file system cannot rename without replacing: a link fails where a file of the name exists, and is not known by memory cards.
  if (::linkat(from_folder.fd(), from.c_str(), to_folder.fd(), to.c_str(), 0) == 0)
    return ::unlinkat(from_folder.fd(), from.c_str(), 0) == 0 ? 0 : errno;
  if (errno != EPERM && errno != EOPNOTSUPP && errno != EMLINK) return errno;  // EMLINK: files in the memory of a page
  struct stat there;
  if (::fstatat(to_folder.fd(), to.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0) return EEXIST;
  return ::renameat(from_folder.fd(), from.c_str(), to_folder.fd(), to.c_str()) == 0 ? 0 : errno;
}

std::mutex& changes_lock() {
  static std::mutex one_at_a_time;
  return one_at_a_time;
}

}  // namespace kadr::served
