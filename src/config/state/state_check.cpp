// The functions of `kadr state`: check a state file, and recover the readable rows of a damaged file. Used by cli/job/state,
// cli/state_command.

#include "config/state/state_check.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "config/state/state_content.h"
#include "config/state_new.h"
#include "texts/state_file.h"

namespace kadr {

using namespace state;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t page_bytes = 1024;

/// A temporary folder. The destructor deletes it.
class Folder {
 public:
  Folder() {
    std::error_code none;
    std::string name = fs::temp_directory_path(none) / "kadr_state_XXXXXX";
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code none;
    if (!path_.empty()) fs::remove_all(path_, none);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Returns true if a run has the file open, because SQLite then holds a lock on the file.
bool in_use(const std::string& path) {
  constexpr off_t lock_bytes = 0x40000000, lock_count = 512;  // sqlite.org/fileformat, "the lock-byte page"
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  struct flock lock = {};
  lock.l_type = F_RDLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = lock_bytes;
  lock.l_len = lock_count;
  const bool is_known = ::fcntl(file, F_GETLK, &lock) == 0;
  ::close(file);
  return is_known && lock.l_type != F_UNLCK;
}

/// Copies the file and its log into the temporary folder, and returns the path of the copy.
tl::expected<std::string, std::string> copied(const std::string& path, const Folder& folder) {
  const auto failed = [&] { return tl::unexpected(translated(texts::state_file::cannot_be_copied, path)); };
  if (folder.path().empty()) return failed();
  const std::string copy = folder.path() / "copy";
  std::error_code error;
  fs::copy_file(path, copy, error);
  if (!error && fs::exists(path + "-wal", error)) fs::copy_file(path + "-wal", copy + "-wal", error);
  if (error) return failed();
  fs::permissions(copy, fs::perms::owner_read | fs::perms::owner_write, error);
  return copy;
}

tl::expected<Content, std::string> content_of(const std::string& copy, const std::string& path) {
  Base base(copy, path);
  if (auto done = base.connect(); !done) return tl::unexpected(done.error());
  if (const std::string newer = newer_version_message(base, path); !newer.empty()) return tl::unexpected(newer);
  Content content = read_content(base);
  base.run("ROLLBACK");
  base.merges(true);
  if (!content.ours) return tl::unexpected(no_state_file_message(path));
  return content;
}

/// Replaces the first page of the copy by the first page of a new state file, in which the tables are at the same positions.
bool lay_new_head(const std::string& copy, const Folder& folder) {
  const std::string made = folder.path() / "new";
  if (!make_state(made, "", {})) return false;
  std::array<char, page_bytes> head{};
  std::ifstream(made, std::ios::binary).read(head.data(), head.size());
  // Byte offsets of two numbers in the header of an SQLite file. If these numbers differ, SQLite computes the page count from the file's
  // size.
  constexpr std::size_t change_counter = 24, valid_for = 92;
  head[change_counter] = 1, head[valid_for] = 2;
  std::error_code none;
  fs::remove(copy + "-wal", none);
  std::fstream file(copy, std::ios::in | std::ios::out | std::ios::binary);
  file.write(head.data(), head.size());
  return static_cast<bool>(file);
}

/// Reads the file unchanged. If its first page is damaged, also reads it with a new first page, and returns the result that has more rows.
tl::expected<Content, std::string> best_content(const std::string& path) {
  const Folder folder;
  const auto copy = copied(path, folder);
  if (!copy) return tl::unexpected(copy.error());
  auto content = content_of(*copy, path);
  if (content && (content->faults.empty() || !content->rows.empty())) return content;
  auto mended = lay_new_head(*copy, folder) ? content_of(*copy, path) : content;
  if (!mended || mended->rows.empty()) return content;
  const std::string fault = content ? content->faults[0] : translated(texts::state_file::first_page_damaged);
  mended->faults.insert(mended->faults.begin(), fault);
  return mended;
}

Done may_look(const std::string& path) {
  std::error_code none;
  if (!fs::exists(path, none)) return tl::unexpected(translated(texts::state_file::no_such_file, path));
  if (auto done = vetted(path); !done) return done;
  if (in_use(path)) return tl::unexpected(translated(texts::state_file::in_use, path));
  return {};
}

StateReport report_of(const Content& content) { return {content.control, content.checked, content.rows.size(), content.faults}; }

}  // namespace

tl::expected<StateReport, std::string> check_state(const std::string& path) {
  if (auto done = may_look(path); !done) return tl::unexpected(done.error());
  const Folder folder;
  const auto copy = copied(path, folder);
  if (!copy) return tl::unexpected(copy.error());
  const auto content = content_of(*copy, path);
  if (!content) return tl::unexpected(content.error());
  return report_of(*content);
}

tl::expected<StateReport, std::string> recover_state(const std::string& path, const std::string& to, const std::string& control) {
  if (auto done = may_look(path); !done) return tl::unexpected(done.error());
  auto content = best_content(path);
  if (!content) return tl::unexpected(content.error());
  if (content->rows.empty() && !content->faults.empty()) return tl::unexpected(translated(texts::state_file::nothing_readable, path));
  const std::string whose = control.empty() ? content->control : control;
  if (whose.empty()) return tl::unexpected(translated(texts::state_file::no_control, path));
  if (auto made = make_state(to, whose, content->rows); !made) return tl::unexpected(made.error());
  content->control = whose;
  return report_of(*content);
}

bool state_is_unchecked(const std::string& path) {
  constexpr std::streamoff user_version = 60;  // byte offset of user_version (big-endian) in SQLite's header
  std::array<unsigned char, 4> bytes{};
  std::error_code none;
  if (!fs::is_regular_file(path, none)) return false;
  std::ifstream file(path, std::ios::binary);
  file.seekg(user_version).read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  const int version = bytes[0] << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
  return file && version / minors_of_major == 1;
}

}  // namespace kadr
