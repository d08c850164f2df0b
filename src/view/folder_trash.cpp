// Lists and empties the trash of the served folder (ServedFolder): `.kadr-trash/20261129-162500/sub/part.nc`. Used by
// view/page/page_changes; tested by tests/serve_files.py.

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <memory>

#include "texts/view.h"
#include "view/folder_names.h"
#include "view/served_folder.h"

namespace kadr {

using namespace served;

namespace {

using Rows = std::unique_ptr<DIR, int (*)(DIR*)>;

constexpr int deepest = 100;  // greatest number of folders within each other

Rows rows_of(const OpenFile& folder) { return {::fdopendir(served::open(folder.fd(), "", O_RDONLY | O_DIRECTORY).release()), ::closedir}; }

/// Calls `take` with the name and kind of each row of a folder.
template <class Take>
void each_row(const OpenFile& folder, const Take& take) {
  const Rows rows = rows_of(folder);
  while (const dirent* const row = rows ? ::readdir(rows.get()) : nullptr) {
    const std::string name = row->d_name;
    struct stat stat;
    if (name != "." && name != ".." && ::fstatat(folder.fd(), name.c_str(), &stat, AT_SYMLINK_NOFOLLOW) == 0) take(name, stat);
  }
}

/// Returns the time in the name of a place, 20261129-162500 or 20261129-162500-2, in s since 1970; 0 if the name has none.
std::int64_t time_of(const std::string& place) {
  std::tm time{};
  if (::strptime(place.c_str(), "%Y%m%d-%H%M%S", &time) == nullptr) return 0;
  return ::timegm(&time);
}

void list_files(const OpenFile& folder, const TrashEntry& of, std::vector<TrashEntry>& list, int depth) {
  each_row(folder, [&](const std::string& name, const struct stat& stat) {
    TrashEntry entry = of;
    entry.file += (of.file.empty() ? "" : "/") + name;
    if (S_ISREG(stat.st_mode) && !is_hidden(name) && list.size() <= ServedFolder::max_entries) {
      entry.size = std::uint64_t(stat.st_size);
      list.push_back(std::move(entry));
    } else if (S_ISDIR(stat.st_mode) && depth < deepest) {
      if (const OpenFile inner = served::open(folder.fd(), name, O_RDONLY | O_DIRECTORY); inner.is_open())
        list_files(inner, entry, list, depth + 1);
    }
  });
}

/// Deletes what is in a folder. Returns an errno; 0: all is deleted.
int delete_content(const OpenFile& folder, std::size_t& count, int depth) {
  int error = 0;
  each_row(folder, [&](const std::string& name, const struct stat& stat) {
    if (S_ISDIR(stat.st_mode) && depth < deepest) {
      const OpenFile inner = served::open(folder.fd(), name, O_RDONLY | O_DIRECTORY);
      if (const int failed = inner.is_open() ? delete_content(inner, count, depth + 1) : errno; failed != 0) error = failed;
    }
    if (::unlinkat(folder.fd(), name.c_str(), S_ISDIR(stat.st_mode) ? AT_REMOVEDIR : 0) != 0) error = errno;
    else if (!S_ISDIR(stat.st_mode)) ++count;
  });
  return error;
}

}  // namespace

bool is_place_in_trash(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) { return (c >= '0' && c <= '9') || c == '-'; });
}

tl::expected<TrashList, std::string> ServedFolder::trash() const {
  TrashList list;
  const OpenFile all = served::open(fd_, trash_folder, O_RDONLY | O_DIRECTORY);
  if (!all.is_open()) {
    if (errno == ENOENT) return list;
    return tl::unexpected(of_errno(trash_folder, errno));
  }
  each_row(all, [&](const std::string& place, const struct stat& stat) {
    if (!S_ISDIR(stat.st_mode) || !is_place_in_trash(place)) return;
    if (const OpenFile kept = served::open(all.fd(), place, O_RDONLY | O_DIRECTORY); kept.is_open())
      list_files(kept, {place, "", 0, time_of(place)}, list.entries, 0);
  });
  std::sort(list.entries.begin(), list.entries.end(), [](const TrashEntry& a, const TrashEntry& b) {
    return a.deleted != b.deleted ? a.deleted > b.deleted : a.trash != b.trash ? a.trash > b.trash : a.file < b.file;
  });
  list.more = list.entries.size() > max_entries;
  if (list.more) list.entries.resize(max_entries);
  return list;
}

tl::expected<std::size_t, ServedFolder::Refused> ServedFolder::empty_trash(const std::string& only) const {
  if (!only.empty() && !is_place_in_trash(only)) return tl::unexpected(Refused{refusal(only)});
  const std::lock_guard hold(changes_lock());
  const OpenFile all = served::open(fd_, trash_folder, O_RDONLY | O_DIRECTORY);
  std::size_t count = 0;
  if (!all.is_open()) {
    if (errno == ENOENT && only.empty()) return count;
    return tl::unexpected(Refused{of_errno(trash_folder, errno)});
  }
  std::vector<std::string> places;
  if (!only.empty()) places.push_back(only);
  else
    each_row(all, [&](const std::string& place, const struct stat& stat) {
      if (S_ISDIR(stat.st_mode) && is_place_in_trash(place)) places.push_back(place);
    });
  for (const std::string& place : places) {
    const OpenFile kept = served::open(all.fd(), place, O_RDONLY | O_DIRECTORY);
    int error = kept.is_open() ? delete_content(kept, count, 0) : errno;
    if (error == 0 && ::unlinkat(all.fd(), place.c_str(), AT_REMOVEDIR) != 0) error = errno;
    if (error != 0) return tl::unexpected(Refused{of_errno(trash_folder, error)});
  }
  return count;
}

}  // namespace kadr
