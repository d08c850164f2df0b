// The state file (--state FILE): stores what survives power-off. Used by cli, config, control; tested by tests/config/state_file_test.cpp.

#include "config/state/state_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <unordered_map>

#include "base/file_id.h"
#include "config/state/state_content.h"
#include "config/state_new.h"
#include "texts/state_file.h"

namespace kadr {

using namespace state;

namespace {

// Merging the log into the file flushes the disk, so the log is merged rarely: when it has 4000 pages, which are 4 MB.
constexpr const char* after_opening = "PRAGMA synchronous = NORMAL; PRAGMA wal_autocheckpoint = 4000";

}  // namespace

class StateFile::Database {
 public:
  explicit Database(const std::string& path) : path_(path), base_(path) {}
  ~Database() {
    if (!stands()) base_.let_go();
  }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  Done open(const std::string& control_id);
  tl::expected<StoredState, std::string> load();
  Done save(const std::vector<StateRow>& rows);

 private:
  using Sums = std::unordered_map<std::string, std::uint64_t>;

  Done check(const std::string& control_id);
  Done prepare();
  int prepare_rows();
  int upgrade();
  int step(const StateRow& row);
  static int step(const SqlStatement& statement);
  int put_whole();
  void sum_is(const std::string& row, std::optional<std::uint64_t> sum);
  tl::unexpected<std::string> damaged(const std::vector<std::string>& faults) const;
  bool stands() const;

  std::string path_;
  Base base_;
  SqlStatement begin_, commit_, put_, remove_, whole_row_;
  Sums sums_;  // checksums of the rows in the file, by table and key
  Whole whole_;
  // Checksums that the rows had before the save in progress. They are restored if the save fails.
  std::vector<std::pair<std::string, std::optional<std::uint64_t>>> before_;
  std::vector<StateRow> unchecked_;   // all rows of the file, if the file has no checksums yet
  bool old_ = false;                  // true if the file has no checksums yet
  std::optional<FileId> file_, log_;  // identities of the file and its log at the time when they were opened; nullopt: not opened yet
};

/// Returns true if the paths of file and log still lead to the files that were opened. Otherwise, data written to the open files would be
/// lost.
bool StateFile::Database::stands() const { return (!file_ || file_id_of(path_) == file_) && (!log_ || file_id_of(path_ + "-wal") == log_); }

/// Returns the message for a damaged file, with advice to the user. The file is not changed.
tl::unexpected<std::string> StateFile::Database::damaged(const std::vector<std::string>& faults) const {
  const std::size_t more = faults.size() - 1;
  if (more == 0) return base_.error(texts::state_file::damaged, faults[0]);
  return base_.error(texts::state_file::damaged_more, faults[0], more);
}

/// Checks that the file is a valid state of the control with this id, in a version that this program can read.
Done StateFile::Database::check(const std::string& control_id) {
  if (const std::string newer = newer_version_message(base_, path_); !newer.empty()) return tl::unexpected(newer);
  Content content = read_content(base_);
  if (!content.ours) return tl::unexpected(no_state_file_message(path_));
  if (!content.faults.empty()) return damaged(content.faults);
  if (content.control != control_id) return base_.error(texts::state_file::other_control, content.control, control_id);
  whole_ = content.checked ? content.whole : Whole::of_control(content.control);
  for (std::size_t i = 0; i < content.rows.size(); ++i) {
    const StateRow& row = content.rows[i];
    sums_.emplace(static_cast<char>(row.table) + row.key, content.sums[i]);
    if (!content.checked) whole_.add(content.sums[i]);
  }
  old_ = !content.checked;
  if (old_) unchecked_ = std::move(content.rows);
  return {};
}

Done StateFile::Database::prepare() {
  if (base_.answer("PRAGMA journal_mode = WAL") != "wal") return base_.failed(base_.last_error());
  if (const int code = base_.run(after_opening); code != SQLITE_OK) return base_.failed(code);
  begin_ = base_.prepared("BEGIN IMMEDIATE");
  commit_ = base_.prepared("COMMIT");
  const int code = old_ ? SQLITE_OK : prepare_rows();
  return begin_ && commit_ && code == SQLITE_OK ? Done{} : base_.failed(SQLITE_CORRUPT);
}

int StateFile::Database::prepare_rows() {
  put_ = base_.prepared(put_row);
  remove_ = base_.prepared("DELETE FROM state WHERE kind = ? AND key = ?");
  whole_row_ = base_.prepared("UPDATE about SET value = ? WHERE name = 'whole'");
  return put_ && remove_ && whole_row_ ? SQLITE_OK : SQLITE_CORRUPT;
}

Done StateFile::Database::open(const std::string& control_id) {
  std::error_code none;
  if (!path_.empty() && !std::filesystem::exists(path_, none))
    if (auto made = make_state(path_, control_id, {}); !made && !std::filesystem::exists(path_, none)) return made;
  if (auto done = vetted(path_); !done) return done;
  if (auto done = base_.connect(); !done) return done;
  if (auto done = check(control_id); !done) return done;
  if (const int code = base_.run("COMMIT"); code != SQLITE_OK) return base_.failed(code);
  base_.merges(true);
  file_ = file_id_of(path_);
  return prepare();
}

tl::expected<StoredState, std::string> StateFile::Database::load() {
  Content content = read_content(base_);
  if (!content.faults.empty()) return damaged(content.faults);
  return StoredState{std::move(content.rows)};
}

int StateFile::Database::step(const SqlStatement& statement) {
  sqlite3_step(statement.get());
  return sqlite3_reset(statement.get());  // returns the error code of the statement's last step
}

/// Records the new checksum of a row of the file; nullopt: the row is removed from the file.
void StateFile::Database::sum_is(const std::string& row, std::optional<std::uint64_t> sum) {
  const auto old = sums_.find(row);
  before_.emplace_back(row, old == sums_.end() ? std::nullopt : std::optional(old->second));
  if (old != sums_.end()) whole_.take(old->second);
  if (sum) whole_.add(*sum), sums_[row] = *sum;
  else if (old != sums_.end()) sums_.erase(old);
}

int StateFile::Database::step(const StateRow& row) {
  const std::string name = static_cast<char>(row.table) + row.key;
  const std::string_view kind = state_table_names[static_cast<std::size_t>(row.table)];
  if (std::holds_alternative<std::monostate>(row.value)) {
    bind_text(remove_.get(), 1, kind);
    bind_text(remove_.get(), 2, row.key);
    sum_is(name, std::nullopt);
    const int code = step(remove_);
    return code == SQLITE_OK ? put_whole() : code;
  }
  const std::uint64_t sum = sum_of_row(kind, row.key, row.value);
  const bool is_new = !sums_.contains(name);
  sum_is(name, sum);
  bind_row(put_.get(), row, sum, whole_);
  const int code = step(put_);
  // After a new row, the totals are also stored as `whole`. Otherwise the loss of the new row would not be detected, because a file without
  // the row still fits the totals of the previous turn.
  return code == SQLITE_OK && is_new ? put_whole() : code;
}

/// Stores the totals as `whole` in the table `about`. This is a turn that writes no row (state_content.h).
int StateFile::Database::put_whole() {
  ++whole_.turn;
  const std::string text = whole_.text();
  bind_text(whole_row_.get(), 1, text);
  return step(whole_row_);
}

/// Converts a file without checksums: creates the tables again, in the same transaction as the first save.
int StateFile::Database::upgrade() {
  put_.reset(), remove_.reset(), whole_row_.reset();
  const std::string make = std::string("ALTER TABLE about RENAME TO about_1; DROP TABLE state;") + about_table + ";" + state_table +
                           "; INSERT INTO about SELECT name, value FROM about_1; DROP TABLE about_1;"
                           "INSERT INTO about VALUES ('whole', '" +
                           whole_.text() + "'); PRAGMA user_version = " + std::to_string(major_version * minors_of_major + minor_version);
  int code = base_.run(make.c_str());
  if (code == SQLITE_OK) code = prepare_rows();
  for (std::size_t i = 0; i < unchecked_.size() && code == SQLITE_OK; ++i) {
    const StateRow& row = unchecked_[i];
    const std::string_view kind = state_table_names[static_cast<std::size_t>(row.table)];
    bind_row(put_.get(), row, sum_of_row(kind, row.key, row.value), whole_);
    code = step(put_);
  }
  if (code == SQLITE_OK) code = put_whole();
  return code;
}

Done StateFile::Database::save(const std::vector<StateRow>& rows) {
  for (const StateRow& row : rows)
    if (const auto* const number = std::get_if<double>(&row.value); number != nullptr && !std::isfinite(*number))
      return base_.error(texts::state_file::no_number, row.key);
  if (rows.empty()) return {};
  if (!stands()) {
    base_.let_go();
    return base_.error(texts::state_file::deleted_or_replaced);
  }
  before_.clear();
  const bool alone = rows.size() == 1 && !old_ && !std::holds_alternative<std::monostate>(rows[0].value) &&
                     sums_.contains(static_cast<char>(rows[0].table) + rows[0].key);
  // A save that writes a single row needs no BEGIN, because a single SQL statement is a transaction by itself
  int code = alone ? SQLITE_OK : step(begin_);
  if (code == SQLITE_OK && old_) code = upgrade();
  for (std::size_t i = 0; i < rows.size() && code == SQLITE_OK; ++i) code = step(rows[i]);
  if (code == SQLITE_OK && !alone) code = step(commit_);
  if (code == SQLITE_OK) {
    old_ = false;
    unchecked_.clear();
    if (!log_) log_ = file_id_of(path_ + "-wal");
    return {};
  }
  auto sentence = base_.failed(code);
  if (base_.in_transaction()) base_.run("ROLLBACK");
  const auto undone = std::move(before_);
  for (auto row = undone.rbegin(); row != undone.rend(); ++row) sum_is(row->first, row->second);
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
