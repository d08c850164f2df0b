// Reads and saves files of the served folder (ServedFolder). Used by view/page/page_session; tested by tests/view/served_folder_test.cpp.

#include "view/served_folder.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <mutex>
#include <utility>

#include "base/ascii.h"
#include "config/control/guess.h"
#include "config/control/remembered_control.h"
#include "config/program_names.h"
#include "config/read_file.h"
#include "out/text/source_line.h"
#include "texts/view.h"
#include "view/folder_names.h"

namespace kadr {

using namespace served;

namespace {

/// Returns true for a file named .kadr.toml in a folder that is not hidden. In this file Kadr remembers which control the folder's programs
/// are for.
bool is_memory(const std::string& name) {
  const std::filesystem::path path(name);
  return path.filename() == remembering_file && (!path.has_parent_path() || !is_hidden(path.parent_path().string()));
}

std::uint64_t hash_of(std::string_view bytes) {  // the hash FNV-1a with 64 bits, which detects changes of a file but not forgery
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

/// Returns the size of a file and the time of its last change, as its digest begins.
std::string attributes_of(const struct stat& stat) {
  return fmt::format("{}-{}.{:09}-", stat.st_size, stat.st_mtim.tv_sec, stat.st_mtim.tv_nsec);
}

FileDigest digest_of(const struct stat& stat, std::string_view bytes) {
  return fmt::format("{}{:016x}", attributes_of(stat), hash_of(bytes));
}

struct Opened {
  OpenFile file;
  struct stat stat;
};
constexpr std::string_view begin_of_key = "-----BEGIN ";

std::string beginning_of(int fd) {
  std::string sample(std::size_t{4} << 10, '\0');
  const ssize_t got = ::pread(fd, sample.data(), sample.size(), 0);
  sample.resize(std::size_t(std::max<ssize_t>(got, 0)));
  return sample;
}

/// Returns true for programs, set-ups, tools and related files. The name decides or, if the name is not sufficient, the contents. Key files
/// are never served.
bool is_served(std::string_view name, int fd) {
  const std::string sample = beginning_of(fd);
  if (sample.starts_with(begin_of_key)) return false;
  if (kind_of_file(name) != FolderEntry::Kind::other) return true;
  if (is_with_programs(name)) return true;
  return judge_name(name) == NameVerdict::nothing && is_program_text(sample);
}

tl::expected<Opened, std::string> open_regular(int folder, const std::string& name) {
  if (is_hidden(name)) return tl::unexpected(refusal(name));
  Opened opened{served::open(folder, name, O_RDONLY), {}};
  if (!opened.file.is_open()) return tl::unexpected(of_errno(name, errno));
  if (::fstat(opened.file.fd(), &opened.stat) != 0) return tl::unexpected(of_errno(name, errno));
  if (!S_ISREG(opened.stat.st_mode) || !is_served(name, opened.file.fd())) return tl::unexpected(refusal(name));
  return opened;
}

tl::expected<std::string, int> all_of(int fd, std::size_t size) {
  std::string bytes(size, '\0');
  std::size_t got = 0;
  while (got < size) {
    const ssize_t n = ::read(fd, bytes.data() + got, size - got);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return tl::unexpected(errno);
    if (n == 0) break;
    got += std::size_t(n);
  }
  bytes.resize(got);
  return bytes;
}

bool write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(fd, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    text.remove_prefix(std::size_t(n));
  }
  return ::fsync(fd) == 0;
}

constexpr std::size_t max_hashed = std::size_t{64} << 20;

}  // namespace

FolderEntry::Kind kind_of_file(std::string_view name) {
  using Kind = FolderEntry::Kind;
  const std::string ending = ending_of(name);
  if (ending == "json") return Kind::setup;
  if (ending == "toml" || ending == "tbl" || ending == "fctb") return Kind::tools;
  return judge_name(name) == NameVerdict::program || is_number_name(name) ? Kind::program : Kind::other;
}

tl::expected<ServedFolder, std::string> ServedFolder::open(const std::string& path) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(path, error);
  if (error) return tl::unexpected(fmt::format("{}: {}", path, errno_message(error.value())));
  const int fd = ::open(real.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return tl::unexpected(fmt::format("{}: {}", path, errno_message(errno)));
  return ServedFolder(fd, real.string(), real.filename().string());
}

ServedFolder::ServedFolder(ServedFolder&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)), path_(std::move(other.path_)), name_(std::move(other.name_)) {}

ServedFolder::~ServedFolder() {
  if (fd_ >= 0) ::close(fd_);
}

tl::expected<FolderList, std::string> ServedFolder::list(const std::string& folder) const {
  if (!folder.empty() && is_hidden(folder)) return tl::unexpected(refusal(folder));
  OpenFile opened = served::open(fd_, folder, O_RDONLY | O_DIRECTORY);
  if (!opened.is_open()) return tl::unexpected(of_errno(folder, errno));
  const std::unique_ptr<DIR, int (*)(DIR*)> rows(::fdopendir(::dup(opened.fd())), ::closedir);
  if (!rows) return tl::unexpected(of_errno(folder, errno));
  constexpr int max_looked_into = 500;  // greatest number of files whose contents are examined
  int looked_into = 0;
  FolderList list;
  while (const dirent* const row = ::readdir(rows.get())) {
    const std::string name = row->d_name;
    struct stat stat;
    if (is_hidden(name) || ::fstatat(opened.fd(), name.c_str(), &stat, AT_SYMLINK_NOFOLLOW) != 0) continue;
    const bool is_folder = S_ISDIR(stat.st_mode);
    if (!is_folder && !S_ISREG(stat.st_mode)) continue;
    if (list.entries.size() >= max_entries) {
      list.more = true;
      break;
    }
    FolderEntry::Kind kind = is_folder ? FolderEntry::Kind::folder : kind_of_file(name);
    if (kind == FolderEntry::Kind::other && judge_name(name) == NameVerdict::nothing && looked_into < max_looked_into) {
      ++looked_into;
      const OpenFile file = served::open(opened.fd(), name, O_RDONLY);
      if (file.is_open() && is_served(name, file.fd())) kind = FolderEntry::Kind::program;
    }
    list.entries.push_back({name, kind, std::uint64_t(stat.st_size), stat.st_mtim.tv_sec});
  }
  std::sort(list.entries.begin(), list.entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
    const bool af = a.kind == FolderEntry::Kind::folder, bf = b.kind == FolderEntry::Kind::folder;
    return af != bf ? af : a.name < b.name;
  });
  return list;
}

tl::expected<std::string, std::string> ServedFolder::path_of(const std::string& file) const {
  const auto opened = open_regular(fd_, file);
  if (!opened) return tl::unexpected(opened.error());
  return path_ + "/" + file;
}

/// Returns the path relative to the served folder; nullopt if the path is outside the folder. `..` is resolved in the text only. This is
/// correct, because links are not followed when the file is opened.
std::optional<std::string> ServedFolder::beneath(const std::string& path) const {
  const std::string plain = std::filesystem::path(path).lexically_normal().string(), front = path_ == "/" ? path_ : path_ + "/";
  if (!plain.starts_with(front)) return std::nullopt;
  return plain.substr(front.size());
}

int ServedFolder::open_for_reading(const std::string& path) const {
  const auto name = beneath(path);
  if (!name || (is_hidden(*name) && !is_memory(*name))) {
    errno = EACCES;
    return -1;
  }
  OpenFile file = served::open(fd_, *name, O_RDONLY | O_NOCTTY);
  struct stat stat;
  if (!file.is_open() || ::fstat(file.fd(), &stat) != 0) return -1;
  if (!S_ISREG(stat.st_mode) || !is_served(*name, file.fd())) {
    errno = EACCES;
    return -1;
  }
  return file.release();
}

tl::expected<FileText, std::string> ServedFolder::read(const std::string& file, std::size_t most) const {
  const auto opened = open_regular(fd_, file);
  if (!opened) return tl::unexpected(opened.error());
  const auto size = std::size_t(opened->stat.st_size);
  if (size > most) return tl::unexpected(translated(texts::view::longer_than, file, most >> 20));
  auto bytes = all_of(opened->file.fd(), size);
  if (!bytes) return tl::unexpected(of_errno(file, bytes.error()));
  FileDigest digest = digest_of(opened->stat, *bytes);
  return FileText{std::move(*bytes), std::move(digest)};
}

tl::expected<FileDigest, std::string> ServedFolder::digest(const std::string& file, const FileDigest& known) const {
  const auto opened = open_regular(fd_, file);
  if (!opened) return tl::unexpected(opened.error());
  if (known.starts_with(attributes_of(opened->stat))) return known;
  if (std::size_t(opened->stat.st_size) > max_hashed) return digest_of(opened->stat, "");
  const auto text = read(file, max_hashed);
  if (!text) return tl::unexpected(text.error());
  return text->digest;
}

namespace {

/// Removes unfinished copies of the file, which a killed server or this server has left in the folder. A copy remains if its server is
/// still running.
void take_away_unfinished(const OpenFile& folder, const std::string& file) {
  const std::unique_ptr<DIR, int (*)(DIR*)> rows(::fdopendir(served::open(folder.fd(), "", O_RDONLY | O_DIRECTORY).release()), ::closedir);
  const std::string front = "." + file + ".";
  constexpr std::string_view ending = ".kadr";
  while (const dirent* const row = rows ? ::readdir(rows.get()) : nullptr) {
    const std::string_view name = row->d_name;
    if (!name.starts_with(front) || !name.ends_with(ending)) continue;
    const long pid = std::strtol(name.data() + front.size(), nullptr, 10);
    if (pid <= 0 || (::kill(pid_t(pid), 0) != 0 && errno == ESRCH)) ::unlinkat(folder.fd(), row->d_name, 0);
  }
}

/// Gives the file `made` the access rights and the owner that `like` states, as far as this process may set them.
void make_alike(int made, const struct stat& like) {
  if (::fchown(made, like.st_uid, like.st_gid) != 0) (void)::fchown(made, uid_t(-1), like.st_gid);
  (void)::fchmod(made, like.st_mode & 0777);
}

/// Writes the text to a new file in the same folder, gives this file the attributes of the replaced file, and renames it to `last`.
///   replaces  attributes of the file to be replaced; nullopt: no file of this name may exist
///   returns   an errno; 0 on success
int put_in_place(const OpenFile& folder, const std::string& last, std::string_view text, const std::optional<struct stat>& replaces) {
  static std::atomic<unsigned> count{0};
  const std::string unfinished = fmt::format(".{}.{}.{}.kadr", last, ::getpid(), ++count);
  const OpenFile made = served::open(folder.fd(), unfinished, O_WRONLY | O_CREAT | O_EXCL, 0644);
  if (!made.is_open()) return errno;
  const auto give_up = [&](int error) {
    ::unlinkat(folder.fd(), unfinished.c_str(), 0);
    return error;
  };
  if (replaces) make_alike(made.fd(), *replaces);
  if (!write_all(made.fd(), text)) return give_up(errno);
  if (replaces) {
    if (::renameat(folder.fd(), unfinished.c_str(), folder.fd(), last.c_str()) != 0) return give_up(errno);
  } else if (const int error = rename_to_new(folder, unfinished, folder, last); error != 0) {
    return give_up(error);
  }
  (void)::fsync(folder.fd());
  return 0;
}

}  // namespace

int served::write_new(const OpenFile& folder, const std::string& last, std::string_view text) {
  take_away_unfinished(folder, last);
  return put_in_place(folder, last, text, std::nullopt);
}

tl::expected<FileDigest, ServedFolder::Refused> ServedFolder::save(const std::string& file, std::string_view text,
                                                                   const std::optional<FileDigest>& replaces) const {
  if (is_hidden(file) || !is_plain_name(file)) return tl::unexpected(Refused{refusal(visible_name(file))});
  if (text.size() > max_saved) return tl::unexpected(Refused{translated(texts::view::too_long_to_save, file)});
  if (text.starts_with(begin_of_key)) return tl::unexpected(Refused{refusal(file)});
  // If two pages save the same file, the second page finds that the file has changed.
  const std::lock_guard hold(changes_lock());
  const auto now = digest(file);
  if (now ? !replaces || *now != *replaces : replaces.has_value())
    return tl::unexpected(Refused{translated(texts::view::changed_since, file), true});
  const std::string last = last_part(file);
  const OpenFile parent = served::open(fd_, folder_part(file), O_RDONLY | O_DIRECTORY);
  if (!parent.is_open()) return tl::unexpected(Refused{of_errno(file, errno)});
  // This check is only for new files: a file that is to be replaced was read before, and has therefore passed is_served().
  if (!replaces)
    if (std::string fault = fault_of_new_name(parent, last); !fault.empty()) return tl::unexpected(Refused{std::move(fault)});
  std::optional<struct stat> there(std::in_place);
  if (::fstatat(parent.fd(), last.c_str(), &*there, AT_SYMLINK_NOFOLLOW) != 0) there.reset();
  // The file is refused, because a link, a folder or a device has this name.
  if (!now && there) return tl::unexpected(Refused{refusal(file)});
  take_away_unfinished(parent, last);
  if (const int error = put_in_place(parent, last, text, now ? there : std::nullopt); error != 0)
    return tl::unexpected(Refused{of_errno(file, error)});
  const auto saved = digest(file);
  if (!saved) return tl::unexpected(Refused{saved.error()});
  return *saved;
}

}  // namespace kadr
