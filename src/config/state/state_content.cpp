// Reads a state file with its checksums: finds the valid rows, and all faults. Used by the rest of config.

#include "config/state/state_content.h"

#include <algorithm>
#include <bit>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <tuple>

#include "texts/state_content.h"
#include "texts/state_file.h"

namespace kadr::state {
namespace {

class Fnv {
 public:
  Fnv() = default;
  explicit Fnv(std::uint64_t of_before) : hash_(of_before) {}
  void byte(unsigned char b) { hash_ = (hash_ ^ b) * 0x100000001B3; }
  void whole(std::uint64_t n) {
    for (int i = 0; i < 8; ++i) byte(static_cast<unsigned char>(n >> (8 * i)));
  }
  void text(std::string_view t) {
    whole(t.size());
    for (const char c : t) byte(static_cast<unsigned char>(c));
  }
  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325;
};

constexpr std::size_t max_faults = 1000;  // greatest number of faults that are reported per file

/// Replaces characters that are not printable, because kinds and keys of a damaged file may contain any bytes.
std::string printable(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string shown;
  for (const char c : text.substr(0, longest)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown;
}

class Reader {
 public:
  explicit Reader(const Base& base) : base_(base) {}

  Content run() {
    tables();
    if (!content_.ours) return std::move(content_);
    about();
    order();
    rows();
    whole();
    return std::move(content_);
  }

 private:
  void fault(std::string sentence) {
    if (content_.faults.size() < max_faults) content_.faults.push_back(std::move(sentence));
  }

  /// Checks the application id, the version, and the tables: the file must have exactly the tables of a state file, and no triggers.
  void tables() {
    const bool marked = base_.answer("PRAGMA application_id") == std::to_string(application_id);
    // Format versions of the tables `about` and `state`, 0 if the table is missing; and the number of tables with other names
    int about = 0, state = 0, others = 0;
    const SqlStatement all = base_.prepared("SELECT sql FROM sqlite_master");
    while (all && sqlite3_step(all.get()) == SQLITE_ROW) {
      const std::string_view sql = text_at(all.get(), 0);
      if (sql == about_table || sql == about_table_1) about = sql == about_table ? 2 : 1;
      else if (sql == state_table || sql == state_table_1) state = sql == state_table ? 2 : 1;
      else ++others;
    }
    content_.ours = marked || state != 0;
    content_.checked = state != 1;
    if (!marked) fault(translated(texts::state_content::foreign_mark));
    if (base_.version() / minors_of_major != state) fault(translated(texts::state_content::version_does_not_fit));
    if (about == 0 || about != state || others != 0) fault(translated(texts::state_content::foreign_tables));
  }

  void about() {
    const SqlStatement all = base_.prepared("SELECT name, value FROM about");
    while (all && sqlite3_step(all.get()) == SQLITE_ROW) {
      const std::string_view name = text_at(all.get(), 0), value = text_at(all.get(), 1);
      if (name == "control") content_.control = value;
      else if (name == "whole" && content_.checked) whole_text(std::string(value));
      else fault(translated(texts::state_content::unknown_row, printable(name)));
    }
    if (content_.control.empty()) fault(translated(texts::state_content::control_missing));
  }

  void whole_text(const std::string& text) {
    const auto whole = Whole::parsed(text);
    if (whole) last_ = *whole;
    else fault(translated(texts::state_content::whole_does_not_fit));
  }

  /// Reports the faults that SQLite's own check finds.
  void order() {
    const SqlStatement check = base_.prepared("PRAGMA integrity_check(20)");
    if (!check) return fault(translated(texts::state_content::order_broken));
    int code = sqlite3_step(check.get());
    for (; code == SQLITE_ROW; code = sqlite3_step(check.get())) {
      std::string found(text_at(check.get(), 0));
      if (found == "ok") continue;
      std::replace(found.begin(), found.end(), '\n', ' ');
      fault(translated(texts::state_content::order_broken_sqlite, found));
    }
    if (code != SQLITE_DONE) fault(translated(texts::state_content::order_broken));
  }

  /// Reads the rows from the first to the last. If a page between them is unreadable, also reads from the last row backwards.
  void rows() {
    const bool checked = content_.checked;
    const auto read = [&](const char* order) {
      const std::string what = std::string("SELECT kind, key, value") + (checked ? ", turn, rows, whole, sum" : "") +
                               " FROM state ORDER BY kind " + order + ", key " + order;
      const SqlStatement all = base_.prepared(what.c_str());
      int code = all ? sqlite3_step(all.get()) : SQLITE_CORRUPT;
      for (; code == SQLITE_ROW; code = sqlite3_step(all.get()))
        if (!take(all.get())) return SQLITE_DONE;
      return code;
    };
    if (read("ASC") != SQLITE_DONE) {
      fault(translated(texts::state_content::rows_unreadable));
      back_ = true;
      read("DESC");
    }
    sort();
  }

  /// Adds one row to the content, or reports its fault. Returns false if this row has already been read in forward order.
  bool take(sqlite3_stmt* row) {
    const std::string kind(text_at(row, 0)), key(text_at(row, 1));
    if (back_ && seen_ && std::pair(kind, key) <= *seen_) return false;
    if (!back_) seen_.emplace(kind, key);
    const int type = sqlite3_column_type(row, 2);
    StateValue value;
    if (type == SQLITE_TEXT) value = std::string(text_at(row, 2));
    else if (type == SQLITE_FLOAT || type == SQLITE_INTEGER) value = sqlite3_column_double(row, 2);
    const std::string name = name_of_row(kind, key);
    const auto table = std::find(state_table_names.begin(), state_table_names.end(), kind);
    const std::uint64_t sum = sum_of_row(kind, key, value);
    const auto number = [&](int column) { return static_cast<std::uint64_t>(sqlite3_column_int64(row, column)); };
    const Whole written = content_.checked ? Whole{number(3), number(4), number(5)} : Whole{};
    const bool sealed = !content_.checked || number(6) == written.sealed(sum);
    if (sealed && written.turn > last_.turn) last_ = written;
    if (!sealed) fault(translated(texts::state_content::row_does_not_fit, name, shown(value)));
    else if (table == state_table_names.end()) fault(translated(texts::state_content::row_of_unknown_kind, name));
    else if (std::holds_alternative<std::monostate>(value)) fault(translated(texts::state_content::row_without_value, name));
    else {
      content_.rows.push_back({static_cast<StateTable>(table - state_table_names.begin()), key, std::move(value)});
      content_.sums.push_back(sum);
    }
    return true;
  }

  static std::string shown(const StateValue& value) {
    if (const auto* const text = std::get_if<std::string>(&value)) return "'" + printable(*text) + "'";
    if (std::holds_alternative<std::monostate>(value)) return translated(texts::state_content::nothing);
    char number[40];
    std::snprintf(number, sizeof number, "%.17g", std::get<double>(value));
    return number;
  }

  void sort() {
    std::vector<std::pair<StateRow, std::uint64_t>> both;
    for (std::size_t i = 0; i < content_.rows.size(); ++i) both.emplace_back(std::move(content_.rows[i]), content_.sums[i]);
    std::sort(both.begin(), both.end(),
              [](const auto& a, const auto& b) { return std::tie(a.first.table, a.first.key) < std::tie(b.first.table, b.first.key); });
    for (std::size_t i = 0; i < both.size(); ++i) content_.rows[i] = std::move(both[i].first), content_.sums[i] = both[i].second;
  }

  void whole() {
    if (!content_.checked) return;
    Whole found = Whole::of_control(content_.control);
    for (const std::uint64_t sum : content_.sums) found.add(sum);
    content_.whole = {last_.turn, found.rows, found.sum};
    if (found.rows == last_.rows && found.sum == last_.sum) return;
    fault(translated(texts::state_content::rows_missing, found.rows, last_.rows));
  }

  const Base& base_;
  Content content_;
  Whole last_;                                               // totals of the file, as the latest turn recorded them
  std::optional<std::pair<std::string, std::string>> seen_;  // kind and key of the last row that was read in forward order
  bool back_ = false;
};

}  // namespace

std::uint64_t sum_of_row(std::string_view kind, std::string_view key, const StateValue& value) {
  Fnv sum;
  sum.text(kind);
  sum.text(key);
  sum.byte(static_cast<unsigned char>(value.index()));
  if (const auto* const text = std::get_if<std::string>(&value)) sum.text(*text);
  else if (const auto* const number = std::get_if<double>(&value))
    sum.whole(std::bit_cast<std::uint64_t>(*number + 0.0));  // adding 0.0 changes -0 to 0, because the file stores -0 as 0
  return sum.hash();
}

Whole Whole::of_control(std::string_view control) { return {0, 0, sum_of_row("about", "control", std::string(control))}; }

std::uint64_t Whole::sealed(std::uint64_t row) const {
  Fnv seal(row);
  for (const std::uint64_t number : {turn, rows, sum}) seal.whole(number);
  return seal.hash();
}

std::string Whole::text() const {
  char text[96];
  std::snprintf(text, sizeof text, "%" PRIu64 " %" PRIu64 " %016" PRIx64 " %016" PRIx64, turn, rows, sum, sealed(0));
  return text;
}

std::optional<Whole> Whole::parsed(const std::string& text) {
  Whole whole;
  std::uint64_t seal = 0;
  const int read =
      std::sscanf(text.c_str(), "%" SCNu64 " %" SCNu64 " %16" SCNx64 " %16" SCNx64, &whole.turn, &whole.rows, &whole.sum, &seal);
  return read == 4 && whole.text() == text ? std::optional(whole) : std::nullopt;
}

Content read_content(const Base& base) { return Reader(base).run(); }

std::string newer_version_message(const Base& base, const std::string& name) {
  const int major = base.version() / minors_of_major;
  if (major <= major_version || base.answer("PRAGMA application_id") != std::to_string(application_id)) return {};
  return translated(texts::state_file::newer_version, name, major, major_version);
}

std::string name_of_row(std::string_view kind, std::string_view key) { return printable(kind) + " " + printable(key); }

}  // namespace kadr::state
