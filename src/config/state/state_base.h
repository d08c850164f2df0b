#pragma once
// The SQLite database of a state file: its connection, its application id and version, and its errors in words. Only state_*.cpp use it.

#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "config/texts.h"

namespace kadr::state {

using Done = tl::expected<void, std::string>;

inline constexpr int application_id = 0x4B616472;  // the bytes of "Kadr", which identify a state file
// Major version of the format: raised if an older Kadr must not read the file; files of version 1 had no checksums
inline constexpr int major_version = 2;
// Minor version of the format: raised if the file gets additional data that an older Kadr may ignore
inline constexpr int minor_version = 0;
inline constexpr int minors_of_major = 1000;
inline constexpr std::uintmax_t max_bytes = 256u << 20;  // greatest size of a state file in bytes; a file with all tables full has 1 MB

/// The SQL statements that create the tables, by version. A file with any other table is not a state file.
inline constexpr const char* about_table = "CREATE TABLE about (name TEXT PRIMARY KEY, value NOT NULL) WITHOUT ROWID";
inline constexpr const char* state_table =
    "CREATE TABLE state (kind TEXT, key TEXT, value NOT NULL, turn INTEGER NOT NULL, rows INTEGER NOT NULL, whole INTEGER NOT NULL, "
    "sum INTEGER NOT NULL, PRIMARY KEY (kind, key)) WITHOUT ROWID";
inline constexpr const char* put_row =
    "INSERT INTO state VALUES (?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO UPDATE SET value = excluded.value, turn = excluded.turn, "
    "rows = excluded.rows, whole = excluded.whole, sum = excluded.sum";
inline constexpr const char* about_table_1 = "CREATE TABLE about (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID";
inline constexpr const char* state_table_1 =
    "CREATE TABLE state (kind TEXT, key TEXT, value NOT NULL, PRIMARY KEY (kind, key)) WITHOUT ROWID";

struct Finalize {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using SqlStatement = std::unique_ptr<sqlite3_stmt, Finalize>;

// Binds a text to a parameter of an SQL statement; the text must exist until the statement is reset
void bind_text(sqlite3_stmt* statement, int index, std::string_view text);
std::string_view text_at(sqlite3_stmt* statement, int column);

class Base {
 public:
  /// `path` is the file to open. Messages use `name`: for a copy, the name of the original file.
  Base(std::string path, std::string name) : path_(std::move(path)), name_(std::move(name)) {}
  explicit Base(const std::string& path) : Base(path, path) {}
  Base(const Base&) = delete;
  Base& operator=(const Base&) = delete;
  ~Base();

  /// Opens the existing file and locks it. Unless merges(true) is called, the file is not changed, not even when it is closed.
  Done connect();
  void merges(bool may);  // sets whether closing the database may merge the log into the file
  /// Makes closing the database leave the file and its log unchanged. The caller must call this function if the path now leads to another
  /// file.
  void let_go() {
    merges(false);
    had_log_ = true;
  }

  SqlStatement prepared(const char* statement) const;
  /// Executes a query and returns the first column of its first row as text; nullopt if the query returns no rows, or fails.
  std::optional<std::string> answer(const char* question) const;
  int run(const char* statements) const { return sqlite3_exec(connection_, statements, nullptr, nullptr, nullptr); }
  int last_error() const { return sqlite3_extended_errcode(connection_); }
  bool in_transaction() const { return sqlite3_get_autocommit(connection_) == 0; }
  int version() const;  // returns the file's format version: the major version times 1000, plus the minor version

  /// Returns an error with this text. The first placeholder of the text is replaced by the file's name, the others by `args`.
  template <std::size_t Holes, typename... Args>
  tl::unexpected<std::string> error(TextId<Holes> text, const Args&... args) const {
    return tl::unexpected(translated(text, name_, args...));
  }
  /// Returns an error with a sentence that explains the result code of SQLite.
  tl::unexpected<std::string> failed(int code) const;

 private:
  std::string path_, name_;
  sqlite3* connection_ = nullptr;
  bool had_log_ = false;
  bool merges_ = false;
};

/// Returns the error sentence that a file is no state file of Kadr.
std::string no_state_file_message(const std::string& name);

/// Checks the file without opening it: the path must not be empty, and the file must be regular, not empty, and not too large. Never
/// blocks.
///   returns  on failure, an error sentence
Done vetted(const std::string& path);

}  // namespace kadr::state
