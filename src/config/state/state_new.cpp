// Creates a new state file with rows. The file is written completely under a temporary name, then renamed, if no file with the new name
// exists. Used by config/state/state_check, config/state/state_file.

#include "config/state_new.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "config/read_file.h"
#include "texts/state_file.h"

namespace kadr::state {
namespace {

namespace fs = std::filesystem;

struct CloseBase {
  void operator()(sqlite3* base) const { sqlite3_close(base); }
};
struct FreeImage {
  void operator()(unsigned char* image) const { sqlite3_free(image); }
};
using Image = std::unique_ptr<unsigned char, FreeImage>;

bool put_about(sqlite3* base, const char* name, const std::string& value) {
  sqlite3_stmt* made = nullptr;
  sqlite3_prepare_v2(base, "INSERT INTO about VALUES (?, ?)", -1, &made, nullptr);
  const SqlStatement put(made);
  bind_text(put.get(), 1, name);
  bind_text(put.get(), 2, value);
  return sqlite3_step(put.get()) == SQLITE_DONE;
}

/// Returns the bytes of the file: fills a database in memory, and serialises it.
Image image_of(const std::string& control, const std::vector<StateRow>& rows, sqlite3_int64& size) {
  sqlite3* opened = nullptr;
  if (sqlite3_open(":memory:", &opened) != SQLITE_OK) return {};
  const std::unique_ptr<sqlite3, CloseBase> base(opened);
  const std::string make = std::string("PRAGMA page_size = 1024; BEGIN;") + about_table + ";" + state_table +
                           "; PRAGMA application_id = " + std::to_string(application_id) +
                           "; PRAGMA user_version = " + std::to_string(major_version * minors_of_major + minor_version);
  if (sqlite3_exec(base.get(), make.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) return {};
  sqlite3_stmt* made = nullptr;
  sqlite3_prepare_v2(base.get(), put_row, -1, &made, nullptr);
  const SqlStatement put(made);
  Whole whole = Whole::of_control(control);
  for (const StateRow& row : rows) {
    const std::uint64_t sum = sum_of_row(state_table_names[static_cast<std::size_t>(row.table)], row.key, row.value);
    whole.add(sum);
    bind_row(put.get(), row, sum, whole);
    sqlite3_step(put.get());
    if (sqlite3_reset(put.get()) != SQLITE_OK) return {};
  }
  ++whole.turn;
  if (!put_about(base.get(), "control", control) || !put_about(base.get(), "whole", whole.text())) return {};
  if (sqlite3_exec(base.get(), "COMMIT", nullptr, nullptr, nullptr) != SQLITE_OK) return {};
  return Image(sqlite3_serialize(base.get(), "main", &size, 0));
}

/// Writes the file and flushes it to the disk. Returns 0, or the errno of the failure.
int write_out(const std::string& path, const unsigned char* bytes, sqlite3_int64 size) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file < 0) return errno;
  int error = 0;
  for (sqlite3_int64 done = 0; done < size && error == 0;) {
    const ssize_t wrote = ::write(file, bytes + done, static_cast<std::size_t>(size - done));
    if (wrote >= 0) done += wrote;
    else if (errno != EINTR) error = errno;
  }
  if (error == 0 && ::fsync(file) != 0) error = errno;
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

/// Renames a file if no file with the new name exists. Returns 0, or the errno of the failure.
int rename_file(const std::string& from, const std::string& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  // link() fails if the new name exists, and also works on file systems without RENAME_NOREPLACE
  if (::link(from.c_str(), to.c_str()) == 0) {
    ::unlink(from.c_str());
    return 0;
  }
  return errno;
}

}  // namespace

void bind_row(sqlite3_stmt* put, const StateRow& row, std::uint64_t sum, Whole& whole) {
  bind_text(put, 1, state_table_names[static_cast<std::size_t>(row.table)]);
  bind_text(put, 2, row.key);
  if (const auto* const text = std::get_if<std::string>(&row.value)) bind_text(put, 3, *text);
  else if (const auto* const number = std::get_if<double>(&row.value)) sqlite3_bind_double(put, 3, *number);
  ++whole.turn;
  int column = 4;
  for (const std::uint64_t n : {whole.turn, whole.rows, whole.sum, whole.sealed(sum)})
    sqlite3_bind_int64(put, column++, static_cast<sqlite3_int64>(n));
}

Done make_state(const std::string& path, const std::string& control, const std::vector<StateRow>& rows) {
  std::error_code none;
  // A log of a former file with this name is a fault, because SQLite would apply it to the new file
  for (const char* const log : {"-wal", "-journal"})
    if (fs::exists(path + log, none)) return tl::unexpected(translated(texts::state_file::old_log, path, path + log));
  sqlite3_int64 size = 0;
  const Image image = image_of(control, rows, size);
  if (!image) return tl::unexpected(translated(texts::state_file::cannot_be_made, path));
  const std::string temporary = path + ".new-" + std::to_string(::getpid());
  int error = write_out(temporary, image.get(), size);
  if (error == 0) error = rename_file(temporary, path);
  if (error == 0) return {};
  ::unlink(temporary.c_str());
  if (error == EEXIST) return tl::unexpected(translated(texts::state_file::there_already, path));
  // ENOENT and ENOTDIR both mean that the folder of the file does not exist, so both give the same message
  if (error == ENOENT || error == ENOTDIR) error = ENOTDIR;
  return tl::unexpected(translated(texts::state_file::cannot_be_made_why, path, errno_message(error)));
}

}  // namespace kadr::state
