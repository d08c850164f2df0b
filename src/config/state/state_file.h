#pragma once
// The state file (--state FILE): stores what survives power-off. NCT 9, 12.3, 23.1.4, 23.1.9, 24.1.
//
// It is an SQLite database with one row per value. Only one process opens it at a time, and each save is one transaction in a write-ahead
// log:
//   If the process is killed: once save() returns, the operating system has the log's pages, so the last completed block is kept.
//   A block that was being saved is in the file completely or not at all.
//   If the power fails: the last blocks may be lost, but the file stays consistent, because the log is flushed before it is merged into
//   the file (synchronous = NORMAL). A flush after each block (FULL) would take some milliseconds each.
//   A rollback journal instead of the log would need two flushes per save for the same guarantee.
//
// Speed, measured with 2000 rows on two cores and the SSD of a server: 120,000 saves per second of one row, 75,000 of two, 35,000 of
// five. Once in some thousand saves, the log is merged into the file, which takes up to 10 ms. Opening takes 1 ms.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "config/setup/setup.h"

namespace kadr {

/// The table that a row belongs to. If a table is added, the minor version of the file is raised; an older Kadr keeps rows of unknown
/// tables in the file.
enum class StateTable : std::uint8_t { offsets, work_offsets, variables, parameters, tool_table, place_table, form_table, panel };

/// Names of the tables in the file, by StateTable. A set-up has the same names.
inline constexpr std::array<std::string_view, 8> state_table_names = {"offsets",    "work_offsets", "variables",  "parameters",
                                                                      "tool_table", "place_table",  "form_table", "panel"};

using StateValue = std::variant<std::monostate, double, std::string>;  // in a change, monostate means that the row is to be removed

/// One value. The keys use the names of the set-up:
///   offsets "5/length_wear" · work_offsets "G54.1 P2/X", "G54/G17" · variables "#500", the counters "#3901" and "#3902", the cutting
///   time "#3002" · parameters "N0107.4#0" · tool_table "2/T", "2/info" (letters or a number), "2/user/1" · place_table "10/1" ·
///   form_table "5/left" · panel: what panel/panel_journal keeps, in a file of its own
struct StateRow {
  StateTable table = StateTable::variables;
  std::string key;
  StateValue value;
  friend bool operator==(const StateRow&, const StateRow&) = default;
};

struct StoredState {
  std::vector<StateRow> rows;  // rows of the file, sorted by table and key; a new file has no rows
};

struct StateChanges {
  std::vector<StateRow> rows;  // changes of one block; if several rows have the same key, the last one applies
};

class StateFile {
 public:
  /// Opens the state file of a control; creates a new file if it does not exist.
  ///   control_id  "nct"
  ///   returns     on failure, an error sentence with the file's name: the file is not a state of Kadr, damaged, of another control, of a
  ///               newer version, in use by another process, or not writable; the file is not changed
  static tl::expected<StateFile, std::string> open(const std::string& path, const std::string& control_id);

  StateFile(StateFile&&) noexcept;
  StateFile& operator=(StateFile&&) noexcept;
  ~StateFile();

  /// Returns all rows of the tables that this version of Kadr supports.
  tl::expected<StoredState, std::string> load();

  /// Saves the changes of one block, all or none. After an error, the file contains what it contained before, and this object remains
  /// usable.
  tl::expected<void, std::string> save(const StateChanges& changes);

 private:
  class Database;
  explicit StateFile(std::unique_ptr<Database> database);
  std::unique_ptr<Database> database_;
};

/// Sorts the rows by table, then by key.
void sort_rows(std::vector<StateRow>& rows);

/// Returns the rows of all tables that survive power-off. A variable has a row only if it has a value in the set-up.
std::vector<StateRow> rows_of(const Setup& tables);

/// Returns a set-up with the tables of a stored state.
///   returns  on failure, an error sentence with the first invalid row
///   law      setup_of({rows_of(tables)}) gives the same tables
tl::expected<Setup, std::string> setup_of(const StoredState& state);

}  // namespace kadr
