// Renames, copies, removes and restores files of the served folder (ServedFolder). Used by view/page/page_files; tested by
// tests/view/served_folder_test.cpp and tests/serve_files.py.

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <mutex>
#include <optional>
#include <utility>

#include "config/read_file.h"
#include "out/text/source_line.h"
#include "texts/view.h"
#include "view/folder_names.h"
#include "view/served_folder.h"

namespace kadr {

using namespace served;

namespace {

using Refused = ServedFolder::Refused;

tl::unexpected<Refused> refused_with(const std::string& file, int error) {
  if (error == EEXIST) return tl::unexpected(Refused{translated(texts::view::name_is_taken, file), true});
  return tl::unexpected(Refused{of_errno(file, error)});
}

bool is_good_path(const std::string& file) { return !is_hidden(file) && is_plain_name(file); }

/// Opens the folder in which a file of this name is or will be.
OpenFile folder_of(int top, const std::string& file) { return served::open(top, folder_part(file), O_RDONLY | O_DIRECTORY); }

/// Creates the folders of the path `folder` beneath `top` that are missing, and opens the last one.
OpenFile made_folders(const OpenFile& top, const std::string& folder) {
  OpenFile at = served::open(top.fd(), "", O_RDONLY | O_DIRECTORY);
  for (std::size_t begin = 0; begin < folder.size() && at.is_open();) {
    const std::size_t end = std::min(folder.find('/', begin), folder.size());
    const std::string name = folder.substr(begin, end - begin);
    if (::mkdirat(at.fd(), name.c_str(), 0755) != 0 && errno != EEXIST) return OpenFile(-1);
    at.replace(served::open(at.fd(), name, O_RDONLY | O_DIRECTORY));
    begin = end + 1;
  }
  return at;
}

/// Creates a folder of its own for a removed file: 20261129-162500, with a number if there is one already.
///   returns  its name; empty if it cannot be created, with the reason in errno
std::string made_place(const OpenFile& trash) {
  const std::string time = fmt::format("{:%Y%m%d-%H%M%S}", fmt::gmtime(std::time(nullptr)));
  constexpr int max_tries = 10'000;
  for (int i = 1; i < max_tries; ++i) {
    std::string name = i == 1 ? time : fmt::format("{}-{}", time, i);
    if (::mkdirat(trash.fd(), name.c_str(), 0700) == 0) return name;
    if (errno != EEXIST) return {};
  }
  return {};
}

/// Removes the folders of a restored file that are empty now.
void take_away_empty(const OpenFile& trash, const std::string& place, const std::string& file) {
  for (std::string folder = folder_part(file); !folder.empty(); folder = folder_part(folder))
    if (::unlinkat(trash.fd(), (place + "/" + folder).c_str(), AT_REMOVEDIR) != 0) return;
  (void)::unlinkat(trash.fd(), place.c_str(), AT_REMOVEDIR);
}

}  // namespace

tl::expected<void, Refused> ServedFolder::rename(const std::string& file, const std::string& to) const {
  if (!is_good_path(to)) return tl::unexpected(Refused{refusal(visible_name(to))});
  const std::lock_guard hold(changes_lock());
  if (const auto there = path_of(file); !there) return tl::unexpected(Refused{there.error()});
  const OpenFile from_folder = folder_of(fd_, file), to_folder = folder_of(fd_, to);
  if (!from_folder.is_open()) return refused_with(file, errno);
  if (!to_folder.is_open()) return refused_with(to, errno);
  const bool is_here = folder_part(file) == folder_part(to);
  if (std::string fault = fault_of_new_name(to_folder, last_part(to), is_here ? last_part(file) : ""); !fault.empty())
    return tl::unexpected(Refused{std::move(fault)});
  if (const int error = rename_to_new(from_folder, last_part(file), to_folder, last_part(to)); error != 0) return refused_with(to, error);
  return {};
}

tl::expected<FileDigest, Refused> ServedFolder::duplicate(const std::string& file, const std::string& to) const {
  if (!is_good_path(to)) return tl::unexpected(Refused{refusal(visible_name(to))});
  const std::lock_guard hold(changes_lock());
  const auto text = read(file, max_copied);
  if (!text) return tl::unexpected(Refused{text.error()});
  const OpenFile folder = folder_of(fd_, to);
  if (!folder.is_open()) return refused_with(to, errno);
  if (std::string fault = fault_of_new_name(folder, last_part(to)); !fault.empty()) return tl::unexpected(Refused{std::move(fault)});
  if (const int error = write_new(folder, last_part(to), text->bytes); error != 0) return refused_with(to, error);
  auto made = digest(to);
  if (!made) return tl::unexpected(Refused{made.error()});
  return *made;
}

tl::expected<std::string, Refused> ServedFolder::remove(const std::string& file) const {
  const std::lock_guard hold(changes_lock());
  if (const auto there = path_of(file); !there) return tl::unexpected(Refused{there.error()});
  const OpenFile top = served::open(fd_, "", O_RDONLY | O_DIRECTORY), folder = folder_of(fd_, file);
  if (!folder.is_open()) return refused_with(file, errno);
  const OpenFile trash = made_folders(top, trash_folder);
  if (!trash.is_open()) return refused_with(trash_folder, errno);
  const std::string place = made_place(trash);
  if (place.empty()) return refused_with(trash_folder, errno);
  const OpenFile kept = made_folders(trash, place + (folder_part(file).empty() ? "" : "/" + folder_part(file)));
  const int error = kept.is_open() ? rename_to_new(folder, last_part(file), kept, last_part(file)) : errno;
  if (error == 0) return place;
  take_away_empty(trash, place, file);
  return refused_with(file, error);
}

tl::expected<void, Refused> ServedFolder::restore(const std::string& trash, const std::string& file) const {
  if (!is_place_in_trash(trash) || !is_good_path(file)) return tl::unexpected(Refused{refusal(visible_name(file))});
  const std::lock_guard hold(changes_lock());
  const OpenFile all = served::open(fd_, trash_folder, O_RDONLY | O_DIRECTORY);
  if (!all.is_open()) return refused_with(file, errno);
  const OpenFile kept = served::open(all.fd(), trash + (folder_part(file).empty() ? "" : "/" + folder_part(file)), O_RDONLY | O_DIRECTORY);
  if (!kept.is_open()) return refused_with(file, errno);
  const OpenFile folder = folder_of(fd_, file);
  if (!folder.is_open()) return refused_with(file, errno);
  if (const int error = rename_to_new(kept, last_part(file), folder, last_part(file)); error != 0) return refused_with(file, error);
  take_away_empty(all, trash, file);
  return {};
}

tl::expected<void, Refused> ServedFolder::make_folder(const std::string& folder) const {
  if (!is_good_path(folder)) return tl::unexpected(Refused{refusal(visible_name(folder))});
  const OpenFile top = served::open(fd_, "", O_RDONLY | O_DIRECTORY);
  if (!made_folders(top, folder).is_open()) return refused_with(folder, errno);
  return {};
}

}  // namespace kadr
