// The program memory on the disk: finds the folder and file for a path, and opens the file. Used by file_writer.cpp; tested by
// tests/control/macro_b/output_file_test.cpp.

#include "control/files/file_place.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

#include "base/ascii.h"

namespace kadr::files {
namespace {

/// Returns the name under which a folder has the file `name`: `name` itself if the folder has it; if not, the first name that differs only
/// in letter case; if there is none, `name` itself.
std::string entry_like(int folder, const std::string& name) {
  struct stat there {};
  if (::fstatat(folder, name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0) return name;
  Descriptor own(::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  DIR* list = own.number() >= 0 ? ::fdopendir(own.number()) : nullptr;
  if (list == nullptr) return name;
  own.release();  // closedir() closes the descriptor
  const std::string wanted = capitals(name);
  std::string found;
  while (const dirent* entry = ::readdir(list)) {
    const std::string_view file = entry->d_name;
    if (file.size() == wanted.size() && capitals(file) == wanted && (found.empty() || file < found)) found = file;
  }
  ::closedir(list);
  return found.empty() ? name : found;
}

There what_is(int folder, const std::string& name) {
  struct stat there {};
  if (::fstatat(folder, name.c_str(), &there, AT_SYMLINK_NOFOLLOW) != 0) return errno == ENOENT ? There::nothing : There::other;
  if (S_ISLNK(there.st_mode)) return There::outside;
  if (!S_ISREG(there.st_mode)) return There::other;
  // The file has a second name (hard link), which may be in any folder, so the file counts as outside.
  return there.st_nlink > 1 ? There::outside : There::file;
}

}  // namespace

std::string capitals(std::string_view text) {
  std::string all(text);
  std::transform(all.begin(), all.end(), all.begin(), to_upper);
  return all;
}

std::vector<std::string> parts_of(std::string_view path, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = path.find(separator);
    parts.emplace_back(path.substr(0, end));
    if (end == std::string_view::npos) return parts;
    path.remove_prefix(end + 1);
  }
}

std::string joined_parts(const std::vector<std::string>& parts) {
  std::string path;
  for (const std::string& part : parts) path += (path.empty() ? "" : "/") + part;
  return path;
}

Place look_up(const std::string& root, const std::string& path) {
  std::vector<std::string> parts = parts_of(path, '/');
  Place place;
  place.folder = Descriptor(::open(root.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  for (std::size_t i = 0; place.folder.number() >= 0 && i + 1 < parts.size(); ++i) {
    parts[i] = entry_like(place.folder.number(), parts[i]);
    Descriptor next(::openat(place.folder.number(), parts[i].c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (next.number() < 0) {
      if (what_is(place.folder.number(), parts[i]) == There::outside) place.what = There::outside;
      return place;
    }
    place.folder = std::move(next);
  }
  if (place.folder.number() < 0) return place;
  parts.back() = entry_like(place.folder.number(), parts.back());
  place.file = parts.back();
  place.path = joined_parts(parts);
  place.what = what_is(place.folder.number(), place.file);
  return place;
}

Result<int> open_regular(const Place& place, const FileMode& rule, std::string_view shown, const FileSet& untouched) {
  const auto bad = [&](AlarmId id) { return fail(alarm(id, {}, shown)); };
  constexpr int flags = O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  const int makes = place.what == There::nothing ? O_CREAT | O_EXCL : 0;
  constexpr mode_t rights = 0666;  // rights of a new file; the system removes those in the umask
  Descriptor opened(::openat(place.folder.number(), place.file.c_str(), flags | makes, rights));
  if (opened.number() < 0) return bad(errno == ELOOP ? AlarmId::file_outside : AlarmId::file_write);
  struct stat there {};
  if (::fstat(opened.number(), &there) != 0 || !S_ISREG(there.st_mode)) return bad(AlarmId::file_write);
  if (there.st_nlink > 1) return bad(AlarmId::file_outside);
  if (const auto id = file_id_of(opened.number()); id && untouched.has(*id)) return bad(AlarmId::file_already_open);
  const bool placed = rule.appends ? ::lseek(opened.number(), 0, SEEK_END) >= 0 : ::ftruncate(opened.number(), 0) == 0;
  if (!placed) return bad(AlarmId::file_write);
  return opened.release();
}

}  // namespace kadr::files
