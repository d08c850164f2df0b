// Reads and saves files of the served folder (ServedFolder). Used by view/page/page_session; tested by tests/view/served_folder_test.cpp.

#include "view/served_folder.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
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

namespace kadr {
namespace {

class OpenFile {
 public:
  explicit OpenFile(int fd) : fd_(fd) {}
  OpenFile(OpenFile&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  OpenFile& operator=(OpenFile&&) = delete;
  ~OpenFile() {
    if (fd_ >= 0) ::close(fd_);
  }
  int fd() const { return fd_; }
  bool is_open() const { return fd_ >= 0; }
  int release() { return std::exchange(fd_, -1); }

 private:
  int fd_;
};

/// Opens a file beneath a folder. Links are not followed, so the file is certainly beneath the folder.
OpenFile open_beneath(int folder, const std::string& name, int flags, mode_t mode = 0) {
  open_how how{};
  how.flags = std::uint64_t(flags) | O_CLOEXEC | O_NONBLOCK;
  how.mode = mode;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS;
  return OpenFile(int(::syscall(SYS_openat2, folder, name.empty() ? "." : name.c_str(), &how, sizeof how)));
}

/// Returns true if a component of the name is hidden (begins with a dot) or empty.
bool is_hidden(std::string_view name) {
  if (name.empty() || name.find('\0') != std::string_view::npos || name.front() == '/') return true;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    if (end == begin || name[begin] == '.') return true;
    begin = end + 1;
  }
  return false;
}

/// Returns true for a file named .kadr.toml in a folder that is not hidden. In this file Kadr remembers which control the folder's programs
/// are for.
bool is_memory(const std::string& name) {
  const std::filesystem::path path(name);
  return path.filename() == remembering_file && (!path.has_parent_path() || !is_hidden(path.parent_path().string()));
}

/// Returns the ending of a file name in lower case.
std::string ending_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  std::string ending(dot == std::string_view::npos ? std::string_view() : name.substr(dot + 1));
  std::transform(ending.begin(), ending.end(), ending.begin(), to_lower);
  return ending;
}

std::string refusal(const std::string& file) { return translated(texts::view::not_of_folder, file); }
std::string of_errno(const std::string& file, int error) {
  if (error == EXDEV || error == ELOOP) return refusal(file);
  return fmt::format("{}: {}", file, errno_message(error));
}

std::uint64_t hash_of(std::string_view bytes) {  // the hash FNV-1a with 64 bits, which detects changes of a file but not forgery
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

FileDigest digest_of(const struct stat& stat, std::string_view bytes) {
  return fmt::format("{}-{}.{:09}-{:016x}", stat.st_size, stat.st_mtim.tv_sec, stat.st_mtim.tv_nsec, hash_of(bytes));
}

struct Opened {
  OpenFile file;
  struct stat stat;
};
/// Returns true if the name has no control characters. Other names are refused, because controls and users write file names into programs.
bool is_plain_name(std::string_view name) { return visible_name(name) == name; }

std::string beginning_of(int fd) {
  std::string sample(std::size_t{4} << 10, '\0');
  const ssize_t got = ::pread(fd, sample.data(), sample.size(), 0);
  sample.resize(std::size_t(std::max<ssize_t>(got, 0)));
  return sample;
}

/// Returns true for programs, set-ups, tools and related files. The name decides or, if the name is not sufficient, the contents. Key files
/// are never served.
bool is_served(std::string_view name, int fd) {
  constexpr std::array with_programs = {"stl", "3mf", "ply", "dxf", "svg", "ini", "var", "csv"};
  const std::string sample = beginning_of(fd);
  if (sample.starts_with("-----BEGIN ")) return false;
  if (kind_of_file(name) != FolderEntry::Kind::other) return true;
  const std::string ending = ending_of(name);
  if (std::find(with_programs.begin(), with_programs.end(), ending) != with_programs.end()) return true;
  return judge_name(name) == NameVerdict::nothing && is_program_text(sample);
}

tl::expected<Opened, std::string> open_regular(int folder, const std::string& name) {
  if (is_hidden(name)) return tl::unexpected(refusal(name));
  Opened opened{open_beneath(folder, name, O_RDONLY), {}};
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

std::string folder_part(const std::string& file) {
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? std::string() : file.substr(0, slash);
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
  OpenFile opened = open_beneath(fd_, folder, O_RDONLY | O_DIRECTORY);
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
      const OpenFile file = open_beneath(opened.fd(), name, O_RDONLY);
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
  OpenFile file = open_beneath(fd_, *name, O_RDONLY | O_NOCTTY);
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

tl::expected<FileDigest, std::string> ServedFolder::digest(const std::string& file) const {
  const auto opened = open_regular(fd_, file);
  if (!opened) return tl::unexpected(opened.error());
  if (std::size_t(opened->stat.st_size) > max_hashed) return digest_of(opened->stat, "");
  const auto text = read(file, max_hashed);
  if (!text) return tl::unexpected(text.error());
  return text->digest;
}

namespace {

/// Removes unfinished copies of the file, which a killed server or this server has left in the folder. A copy remains if its server is
/// still running.
void take_away_unfinished(const OpenFile& folder, const std::string& file) {
  const std::unique_ptr<DIR, int (*)(DIR*)> rows(::fdopendir(open_beneath(folder.fd(), "", O_RDONLY | O_DIRECTORY).release()), ::closedir);
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
  const OpenFile made = open_beneath(folder.fd(), unfinished, O_WRONLY | O_CREAT | O_EXCL, 0644);
  if (!made.is_open()) return errno;
  const auto give_up = [&](int error) {
    ::unlinkat(folder.fd(), unfinished.c_str(), 0);
    return error;
  };
  if (replaces) make_alike(made.fd(), *replaces);
  if (!write_all(made.fd(), text)) return give_up(errno);
  if (replaces) {
    if (::renameat(folder.fd(), unfinished.c_str(), folder.fd(), last.c_str()) != 0) return give_up(errno);
  } else {  // linkat() fails if another process has created a file of this name, so no file is overwritten
    if (::linkat(folder.fd(), unfinished.c_str(), folder.fd(), last.c_str(), 0) != 0) return give_up(errno);
    ::unlinkat(folder.fd(), unfinished.c_str(), 0);
  }
  (void)::fsync(folder.fd());
  return 0;
}

}  // namespace

tl::expected<FileDigest, ServedFolder::Refused> ServedFolder::save(const std::string& file, std::string_view text,
                                                                   const std::optional<FileDigest>& replaces) const {
  if (is_hidden(file) || !is_plain_name(file)) return tl::unexpected(Refused{refusal(visible_name(file))});
  // This check is only for new files: a file that is to be replaced was read before, and has therefore passed is_served().
  if (!replaces && kind_of_file(file) == FolderEntry::Kind::other)
    return tl::unexpected(Refused{translated(texts::view::not_a_name_to_save, file)});
  if (text.size() > max_saved) return tl::unexpected(Refused{translated(texts::view::too_long_to_save, file)});
  // This mutex lets only one page save at a time: if two pages save the same file, the second page finds that the file has changed.
  static std::mutex one_at_a_time;
  const std::lock_guard hold(one_at_a_time);
  const auto now = digest(file);
  if (now ? !replaces || *now != *replaces : replaces.has_value())
    return tl::unexpected(Refused{translated(texts::view::changed_since, file), true});
  const std::string folder = folder_part(file), last = file.substr(folder.empty() ? 0 : folder.size() + 1);
  const OpenFile parent = open_beneath(fd_, folder, O_RDONLY | O_DIRECTORY);
  if (!parent.is_open()) return tl::unexpected(Refused{of_errno(file, errno)});
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
