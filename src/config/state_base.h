#pragma once
// The SQLite database that a state file is: its connection, its marks, its errors in words. Only state_*.cpp use it.

#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace kadr::state {

using Done = tl::expected<void, std::string>;

inline constexpr int application_id = 0x4B616472;  // "Kadr"
inline constexpr int major_version = 2;            // another one: an older Kadr must not read the file; 1 had no checksums
inline constexpr int minor_version = 0;            // another one: there is more that this version passes over
inline constexpr int minors_of_major = 1000;
inline constexpr std::uintmax_t most_bytes = 256u << 20;  // of a file; a full one has 1 MB

/// The tables as they are made, by version; what else stands in a file is none of ours.
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

void bind_text(sqlite3_stmt* statement, int index, std::string_view text);  // the text must live until the statement is reset
std::string_view text_at(sqlite3_stmt* statement, int column);

class Base {
 public:
  /// `path` is opened, `name` stands in sentences: of a copy, that of the original.
  Base(std::string path, std::string name) : path_(std::move(path)), name_(std::move(name)) {}
  explicit Base(const std::string& path) : Base(path, path) {}
  Base(const Base&) = delete;
  Base& operator=(const Base&) = delete;
  ~Base();

  /// Opens the file, which is there, and locks it. As long as merges(false) holds, nothing of it is changed, nor at closing.
  Done connect();
  void merges(bool may);  // whether closing may merge the log into the file
  /// What its names mean now is another's: closing leaves it alone.
  void let_go() {
    merges(false);
    had_log_ = true;
  }

  SqlStatement prepared(const char* statement) const;
  /// The first column of the first row as text; nothing if there is none, or it cannot be read.
  std::optional<std::string> answer(const char* question) const;
  int run(const char* statements) const { return sqlite3_exec(connection_, statements, nullptr, nullptr, nullptr); }
  int last_error() const { return sqlite3_extended_errcode(connection_); }
  bool in_transaction() const { return sqlite3_get_autocommit(connection_) == 0; }
  int version() const;  // major and minor

  tl::unexpected<std::string> error(const std::string& en, const std::string& ru) const;
  /// The sentence of SQLite's result code.
  tl::unexpected<std::string> failed(int code) const;

 private:
  std::string path_, name_;
  sqlite3* connection_ = nullptr;
  bool had_log_ = false;
  bool merges_ = false;
};

/// "… is no state file of Kadr".
std::string told_no_state(const std::string& name);

/// What can be seen from outside: a name, a regular file, not empty, not endless. Waits for nobody.
///   returns  an error sentence
Done vetted(const std::string& path);

}  // namespace kadr::state
