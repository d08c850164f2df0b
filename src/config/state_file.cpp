#include "config/state_file.h"

#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>

namespace kadr {
namespace {

using Done = tl::expected<void, std::string>;

constexpr int application_id = 0x4B616472;  // "Kadr"
constexpr int major_version = 1;            // another one: an older Kadr must not read the file
constexpr int minor_version = 0;            // another one: there are rows that an older Kadr does not know
constexpr int minors_of_major = 1000;

// Small pages: a save writes those that it changes. A merge flushes the disk, so it comes seldom; 4000 pages are 4 MB.
constexpr const char* before_opening = "PRAGMA page_size = 1024; PRAGMA locking_mode = EXCLUSIVE";
constexpr const char* after_opening = "PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = 4000";
constexpr const char* new_tables =
    "CREATE TABLE about (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;"
    "CREATE TABLE state (kind TEXT, key TEXT, value NOT NULL, PRIMARY KEY (kind, key)) WITHOUT ROWID;";

struct Finalize {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Statement = std::unique_ptr<sqlite3_stmt, Finalize>;

void bind_text(sqlite3_stmt* statement, int index, std::string_view text) {  // the text must live until the statement is reset
  sqlite3_bind_text(statement, index, text.data(), static_cast<int>(text.size()), SQLITE_STATIC);
}

std::string_view text_at(sqlite3_stmt* statement, int column) {
  const auto* const text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
  return {text == nullptr ? "" : text, static_cast<std::size_t>(sqlite3_column_bytes(statement, column))};
}

}  // namespace

class StateFile::Database {
 public:
  explicit Database(std::string path) : path_(std::move(path)) {}
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database() {
    for (Statement* const s : {&begin_, &commit_, &put_, &remove_}) s->reset();
    sqlite3_close(connection_);
  }

  Done open(const std::string& control_id);
  tl::expected<StoredState, std::string> load();
  Done save(const std::vector<StateRow>& rows);

 private:
  Done connect();
  Done prepare();
  Done check_kind(const std::string& control_id);
  Done make_new(const std::string& control_id);
  Done check_order();
  int step(const StateRow& row);
  int step(const Statement& statement);
  int run(const char* statements) { return sqlite3_exec(connection_, statements, nullptr, nullptr, nullptr); }
  Statement prepared(const char* statement);
  std::optional<std::string> answer(const char* question);
  tl::unexpected<std::string> error(const std::string& what) const { return tl::unexpected(path_ + " " + what); }
  tl::unexpected<std::string> failed(int code) const;

  std::string path_;
  sqlite3* connection_ = nullptr;
  Statement begin_, commit_, put_, remove_;
};

/// The sentence of SQLite's result code.
tl::unexpected<std::string> StateFile::Database::failed(int code) const {
  const int system_error = sqlite3_system_errno(connection_);
  const std::string why = system_error == 0 ? "" : ": " + std::string(std::strerror(system_error));
  switch (code & 0xFF) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED: return error("is in use by another process");
    case SQLITE_NOTADB: return error("is no state file of Kadr");
    case SQLITE_READONLY:
    case SQLITE_PERM: return error("cannot be written: it is read-only");
    case SQLITE_CANTOPEN: return error("cannot be opened" + why);
    case SQLITE_FULL: return error("cannot be written: the disk is full");
    case SQLITE_IOERR: return error("cannot be read or written: " + std::string(sqlite3_errstr(code & 0xFF)));
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:
    case SQLITE_CONSTRAINT:
    case SQLITE_MISMATCH: return error("is damaged");
    default: return error(std::string("cannot be used: ") + sqlite3_errstr(code));
  }
}

Statement StateFile::Database::prepared(const char* statement) {
  sqlite3_stmt* made = nullptr;
  sqlite3_prepare_v3(connection_, statement, -1, SQLITE_PREPARE_PERSISTENT, &made, nullptr);
  return Statement(made);
}

/// The first column of the first row as text; nothing if there is none.
std::optional<std::string> StateFile::Database::answer(const char* question) {
  const Statement statement = prepared(question);
  if (!statement || sqlite3_step(statement.get()) != SQLITE_ROW) return std::nullopt;
  return std::string(text_at(statement.get(), 0));
}

/// Opens the file itself and locks it; nothing of it is changed.
Done StateFile::Database::connect() {
  namespace fs = std::filesystem;
  if (path_.empty()) return tl::unexpected<std::string>("the state file has no name");
  std::error_code none;
  const fs::file_status there = fs::status(path_, none);
  if (fs::exists(there) && !fs::is_regular_file(there)) return error("is no file");
  const std::string name = path_[0] == '/' ? path_ : "./" + path_;  // or SQLite would take ":memory:" and "file:…" for something else
  constexpr int how = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  if (const int code = sqlite3_open_v2(name.c_str(), &connection_, how, nullptr); code != SQLITE_OK) return failed(code);
  if (sqlite3_db_readonly(connection_, "main") == 1) return failed(SQLITE_READONLY);
  if (const int code = run(before_opening); code != SQLITE_OK) return failed(code);
  if (const int code = run("BEGIN EXCLUSIVE"); code != SQLITE_OK) return failed(code);
  return {};
}

Done StateFile::Database::make_new(const std::string& control_id) {
  const std::string marks = "PRAGMA application_id = " + std::to_string(application_id) +
                            "; PRAGMA user_version = " + std::to_string(major_version * minors_of_major + minor_version);
  if (const int code = run(new_tables); code != SQLITE_OK) return failed(code);
  if (const int code = run(marks.c_str()); code != SQLITE_OK) return failed(code);
  const Statement about = prepared("INSERT INTO about VALUES ('control', ?)");
  bind_text(about.get(), 1, control_id);
  const int code = sqlite3_step(about.get());
  return code == SQLITE_DONE ? Done{} : failed(code);
}

/// Is it a state of this control, of a version that can be read? Makes one of an empty file.
Done StateFile::Database::check_kind(const std::string& control_id) {
  const std::optional<std::string> tables = answer("SELECT count(*) FROM sqlite_master");
  if (!tables) return failed(sqlite3_extended_errcode(connection_));
  const std::string mark = answer("PRAGMA application_id").value_or("");
  if (*tables == "0" && mark == "0") return make_new(control_id);
  if (mark != std::to_string(application_id)) return failed(SQLITE_NOTADB);
  const int version = std::atoi(answer("PRAGMA user_version").value_or("0").c_str());
  const int major = version / minors_of_major;
  if (major > major_version)
    return error("was written by a newer Kadr: its state version is " + std::to_string(major) + ", this one reads up to " +
                 std::to_string(major_version));
  const std::optional<std::string> control = answer("SELECT value FROM about WHERE name = 'control'");
  if (!control || major < 1) return failed(SQLITE_CORRUPT);
  if (*control != control_id) return error("is the state of the control " + *control + ", not of " + control_id);
  return check_order();
}

Done StateFile::Database::check_order() { return answer("PRAGMA quick_check(1)") == "ok" ? Done{} : failed(SQLITE_CORRUPT); }

Done StateFile::Database::prepare() {
  if (answer("PRAGMA journal_mode = WAL") != "wal") return failed(sqlite3_extended_errcode(connection_));
  if (const int code = run(after_opening); code != SQLITE_OK) return failed(code);
  begin_ = prepared("BEGIN IMMEDIATE");
  commit_ = prepared("COMMIT");
  put_ = prepared("INSERT INTO state VALUES (?, ?, ?) ON CONFLICT DO UPDATE SET value = excluded.value");
  remove_ = prepared("DELETE FROM state WHERE kind = ? AND key = ?");
  return begin_ && commit_ && put_ && remove_ ? Done{} : failed(SQLITE_CORRUPT);
}

Done StateFile::Database::open(const std::string& control_id) {
  if (auto done = connect(); !done) return done;
  if (auto done = check_kind(control_id); !done) return done;
  if (const int code = run("COMMIT"); code != SQLITE_OK) return failed(code);
  return prepare();
}

tl::expected<StoredState, std::string> StateFile::Database::load() {
  StoredState state;
  const Statement all = prepared("SELECT kind, key, value FROM state");
  if (!all) return failed(SQLITE_CORRUPT);
  int code = sqlite3_step(all.get());
  for (; code == SQLITE_ROW; code = sqlite3_step(all.get())) {
    const auto table = std::find(state_table_names.begin(), state_table_names.end(), text_at(all.get(), 0));
    if (table == state_table_names.end()) continue;  // of a newer Kadr
    const int type = sqlite3_column_type(all.get(), 2);
    if (type == SQLITE_BLOB || type == SQLITE_NULL) return failed(SQLITE_CORRUPT);
    StateValue value = sqlite3_column_double(all.get(), 2);
    if (type == SQLITE_TEXT) value = std::string(text_at(all.get(), 2));
    state.rows.push_back(
        {static_cast<StateTable>(table - state_table_names.begin()), std::string(text_at(all.get(), 1)), std::move(value)});
  }
  if (code != SQLITE_DONE) return failed(code);
  sort_rows(state.rows);
  return state;
}

int StateFile::Database::step(const Statement& statement) {
  sqlite3_step(statement.get());
  return sqlite3_reset(statement.get());  // gives the error of the step
}

int StateFile::Database::step(const StateRow& row) {
  const bool removed = std::holds_alternative<std::monostate>(row.value);
  const Statement& statement = removed ? remove_ : put_;
  bind_text(statement.get(), 1, state_table_names[static_cast<std::size_t>(row.table)]);
  bind_text(statement.get(), 2, row.key);
  if (const auto* const text = std::get_if<std::string>(&row.value)) bind_text(statement.get(), 3, *text);
  else if (const auto* const number = std::get_if<double>(&row.value)) sqlite3_bind_double(statement.get(), 3, *number);
  return step(statement);
}

Done StateFile::Database::save(const std::vector<StateRow>& rows) {
  for (const StateRow& row : rows)
    if (const auto* const number = std::get_if<double>(&row.value); number != nullptr && std::isnan(*number))
      return error("cannot keep " + row.key + ": it is not a number");
  if (rows.empty()) return {};
  const bool alone = rows.size() == 1;  // a single statement is a transaction of its own
  int code = alone ? SQLITE_OK : step(begin_);
  for (std::size_t i = 0; i < rows.size() && code == SQLITE_OK; ++i) code = step(rows[i]);
  if (code == SQLITE_OK && !alone) code = step(commit_);
  if (code == SQLITE_OK) return {};
  auto sentence = failed(code);
  if (sqlite3_get_autocommit(connection_) == 0) run("ROLLBACK");
  return sentence;
}

StateFile::StateFile(std::unique_ptr<Database> database) : database_(std::move(database)) {}
StateFile::StateFile(StateFile&&) noexcept = default;
StateFile& StateFile::operator=(StateFile&&) noexcept = default;
StateFile::~StateFile() = default;

tl::expected<StateFile, std::string> StateFile::open(const std::string& path, const std::string& control_id) {
  auto database = std::make_unique<Database>(path);
  if (auto done = database->open(control_id); !done) return tl::unexpected(done.error());
  return StateFile(std::move(database));
}

tl::expected<StoredState, std::string> StateFile::load() { return database_->load(); }
tl::expected<void, std::string> StateFile::save(const StateChanges& changes) { return database_->save(changes.rows); }

}  // namespace kadr
