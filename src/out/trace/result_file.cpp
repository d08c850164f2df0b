// ResultFile: writes a file that appears complete or not at all. It is used by every command that writes a file (cli/job/outputs) and for
// pictures (out/text/page_file), and tested by tests/out/result_file_test.cpp.

#include "out/trace/result_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "base/file_id.h"
#include "config/read_file.h"

namespace kadr {
namespace {

std::string sentence(const std::string& name, int error) { return fmt::format("{}: {}", name, errno_message(error)); }

/// The list of temporary files that have not been moved to their final paths yet. discard_all() deletes these files.
struct UnfinishedFiles {
  std::mutex lock;
  std::set<std::string> names;
};
UnfinishedFiles& unfinished_files() {
  static auto* const files = new UnfinishedFiles;  // the list is never freed, since discard_all() may be called while the process ends
  return *files;
}

/// Returns standard output or standard error if the name refers to the same file. If the file were opened again, the two streams would have
/// separate positions and overwrite each other.
std::FILE* standard_stream(const std::string& name) {
  const auto id = file_id_of(name);
  for (std::FILE* const stream : {stdout, stderr})
    if (id && id == file_id_of(::fileno(stream))) return stream;
  return nullptr;
}

/// Creates a new file in the folder and stores its name in `name`. Returns the file descriptor; -1 if the file cannot be created.
int make_in(const std::filesystem::path& folder, std::string& name) {
  constexpr int max_tries = 1000;
  constexpr mode_t rights = 0666;  // permissions of a new file, from which the operating system removes the umask
  for (int i = 0; i < max_tries; ++i) {
    name = (folder / fmt::format(".kadr-{}-{}", ::getpid(), i)).string();
    const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, rights);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

/// Copies the bytes of a file, if the file cannot be renamed (other file system, mounted file, folder without write permission).
bool copy(const std::string& from, const std::string& to) {
  using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
  const File in(std::fopen(from.c_str(), "rb"), &std::fclose);
  File out(in ? std::fopen(to.c_str(), "wb") : nullptr, &std::fclose);
  if (!out) return false;
  std::array<char, 1 << 16> piece;  // NOLINT: filled by fread
  for (std::size_t count; (count = std::fread(piece.data(), 1, piece.size(), in.get())) > 0;)
    if (std::fwrite(piece.data(), 1, count, out.get()) != count) return false;
  return std::ferror(in.get()) == 0 && std::fclose(out.release()) == 0;
}

}  // namespace

int error_of(std::FILE* file) {
  errno = 0;
  if (std::fflush(file) == 0 && std::ferror(file) == 0) return 0;
  const int error = errno != 0 ? errno : EIO;
  pollfd end = {::fileno(file), 0, 0};
  return ::poll(&end, 1, 0) == 1 && (end.revents & POLLERR) != 0 ? EPIPE : error;
}

ResultFile::ResultFile(ResultFile&& other) noexcept { *this = std::move(other); }

ResultFile& ResultFile::operator=(ResultFile&& other) noexcept {
  if (this == &other) return *this;
  discard();
  name_ = std::move(other.name_);
  place_ = std::exchange(other.place_, {});
  temporary_ = std::exchange(other.temporary_, {});
  file_ = std::exchange(other.file_, nullptr);
  owned_ = std::exchange(other.owned_, false);
  return *this;
}

tl::expected<ResultFile, std::string> ResultFile::open(const std::string& name) {
  ResultFile result(name);
  struct stat there {};
  const bool exists = name != "-" && ::stat(name.c_str(), &there) == 0;
  if (exists && S_ISDIR(there.st_mode)) return tl::unexpected(sentence(name, EISDIR));
  if (std::FILE* const stream = name == "-" ? stdout : exists ? standard_stream(name) : nullptr) {
    result.file_ = stream;
    return result;
  }
  if (!exists || S_ISREG(there.st_mode)) {
    if (auto opened = result.open_temporary(); !opened) return tl::unexpected(opened.error());
    return result;
  }
  result.owned_ = true;
  result.file_ = std::fopen(name.c_str(), "wb");
  if (result.file_ == nullptr) return tl::unexpected(sentence(name, errno));
  return result;
}

tl::expected<void, std::string> ResultFile::open_temporary() {
  namespace fs = std::filesystem;
  place_ = true_path(name_);
  struct stat there {};
  const bool exists = ::stat(place_.c_str(), &there) == 0;
  if (exists && ::access(place_.c_str(), W_OK) != 0) return tl::unexpected(sentence(name_, errno));
  UnfinishedFiles& files = unfinished_files();
  const std::lock_guard guard(files.lock);
  int file = make_in(fs::path(place_).parent_path(), temporary_);
  if (file < 0 && exists) file = make_in(fs::temp_directory_path(), temporary_);
  if (file < 0) return tl::unexpected(sentence(name_, errno));
  files.names.insert(temporary_);
  constexpr mode_t all_rights = 07777;
  // A failure is ignored: if the system refuses the permissions of the old file, the new file has those of any new file.
  if (exists) (void)::fchmod(file, there.st_mode & all_rights);
  owned_ = true;
  file_ = ::fdopen(file, "wb");
  return {};
}

bool ResultFile::take_place() const { return std::rename(temporary_.c_str(), place_.c_str()) == 0 || copy(temporary_, place_); }

tl::expected<void, std::string> ResultFile::keep() {
  if (file_ == nullptr) return {};
  int error = error_of(file_);
  if (owned_ && std::fclose(file_) != 0 && error == 0) error = errno;
  file_ = nullptr;
  if (error == 0 && !temporary_.empty() && !take_place()) error = errno != 0 ? errno : EIO;
  discard();
  if (error == 0) return {};
  return tl::unexpected(error == EPIPE ? std::string() : sentence(name_ == "-" ? "standard output" : name_, error));
}

void ResultFile::discard() {
  if (file_ != nullptr && owned_) std::fclose(file_);
  file_ = nullptr;
  if (temporary_.empty()) return;
  UnfinishedFiles& files = unfinished_files();
  const std::lock_guard guard(files.lock);
  if (files.names.erase(temporary_) != 0) (void)::unlink(temporary_.c_str());
  temporary_.clear();
}

void ResultFile::discard_all() {
  UnfinishedFiles& files = unfinished_files();
  // The lock is never released, since the process ends. The wait is limited, since a signal handler may call this function while the thread
  // that it has interrupted holds the lock.
  constexpr int max_polls = 100;
  for (int look = 0; !files.lock.try_lock(); ++look) {
    if (look == max_polls) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  for (const std::string& name : files.names) (void)::unlink(name.c_str());
}

}  // namespace kadr
