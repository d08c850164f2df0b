// The SQLite database of a state file: its connection, its application id and version, and its errors in words. Used by
// config/state/state_content.

#include "config/state/state_base.h"

#include <cstdlib>
#include <filesystem>

#include "config/read_file.h"
#include "texts/state_file.h"

namespace kadr::state {
namespace {

namespace fs = std::filesystem;

// The pages are small, because a save writes only the pages that it changes. Merging the log into the file flushes the disk, so the log is
// merged rarely (state_file.cpp).
constexpr const char* before_opening = "PRAGMA page_size = 1024; PRAGMA locking_mode = EXCLUSIVE; PRAGMA trusted_schema = OFF";

}  // namespace

void bind_text(sqlite3_stmt* statement, int index, std::string_view text) {
  sqlite3_bind_text(statement, index, text.data(), static_cast<int>(text.size()), SQLITE_STATIC);
}

std::string_view text_at(sqlite3_stmt* statement, int column) {
  const auto* const text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
  return {text == nullptr ? "" : text, static_cast<std::size_t>(sqlite3_column_bytes(statement, column))};
}

Base::~Base() {
  sqlite3_close(connection_);
  if (merges_ || had_log_) return;
  std::error_code none;  // opening the database may have created an empty log, which is removed here
  const std::string log = path_ + "-wal";
  if (fs::exists(log, none) && fs::file_size(log, none) == 0) fs::remove(log, none);
}

Done Base::connect() {
  std::error_code none;
  had_log_ = fs::exists(path_ + "-wal", none);
  // The prefix "./" keeps SQLite from treating names such as ":memory:" and "file:…" as special names
  const std::string name = path_[0] == '/' ? path_ : "./" + path_;
  constexpr int how = SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX;
  if (const int code = sqlite3_open_v2(name.c_str(), &connection_, how, nullptr); code != SQLITE_OK) return failed(code);
  merges(false);
  if (sqlite3_db_readonly(connection_, "main") == 1) return failed(SQLITE_READONLY);
  if (const int code = run(before_opening); code != SQLITE_OK) return failed(code);
  if (const int code = run("BEGIN EXCLUSIVE"); code != SQLITE_OK) return failed(code);
  return {};
}

void Base::merges(bool may) {
  merges_ = may;
  sqlite3_db_config(connection_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, may ? 0 : 1, nullptr);
}

SqlStatement Base::prepared(const char* statement) const {
  sqlite3_stmt* made = nullptr;
  sqlite3_prepare_v3(connection_, statement, -1, SQLITE_PREPARE_PERSISTENT, &made, nullptr);
  return SqlStatement(made);
}

std::optional<std::string> Base::answer(const char* question) const {
  const SqlStatement statement = prepared(question);
  if (!statement || sqlite3_step(statement.get()) != SQLITE_ROW) return std::nullopt;
  return std::string(text_at(statement.get(), 0));
}

int Base::version() const { return std::atoi(answer("PRAGMA user_version").value_or("0").c_str()); }

tl::unexpected<std::string> Base::failed(int code) const {
  const int system_error = sqlite3_system_errno(connection_);
  const std::string sqlite = sqlite3_errstr(code & 0xFF);
  switch (code & 0xFF) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED: return error(texts::state_file::in_use);
    case SQLITE_NOTADB: return tl::unexpected(no_state_file_message(name_));
    case SQLITE_READONLY:
    case SQLITE_PERM: return error(texts::state_file::read_only);
    case SQLITE_CANTOPEN:
      if (system_error == 0) return error(texts::state_file::cannot_be_opened);
      return error(texts::state_file::cannot_be_opened_why, errno_message(system_error));
    case SQLITE_FULL: return error(texts::state_file::disk_full);
    case SQLITE_IOERR: return error(texts::state_file::cannot_be_read_or_written, sqlite);
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:
    case SQLITE_CONSTRAINT:
    case SQLITE_MISMATCH: return error(texts::state_file::is_damaged);
    default: return error(texts::state_file::cannot_be_used, sqlite);
  }
}

std::string no_state_file_message(const std::string& name) { return translated(texts::state_file::no_state_file, name); }

Done vetted(const std::string& path) {
  if (path.empty()) return tl::unexpected(translated(texts::state_file::no_name));
  if (const std::string kind = file_type_in_words(path); !kind.empty())
    return tl::unexpected(translated(texts::state_file::is_not_a_file, path, kind));
  // file_size() is used because it does not open the file; closing an opened file would release the locks that this process has on it
  std::error_code none;
  const std::uintmax_t size = fs::file_size(path, none);
  if (!none && size == 0) return tl::unexpected(translated(texts::state_file::is_empty, path));
  if (!none && size > max_bytes) return tl::unexpected(translated(texts::state_file::too_long, path));
  return {};
}

}  // namespace kadr::state
