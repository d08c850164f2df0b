#pragma once
// The state file (--state FILE): what survives power-off. NCT 9, 12.3, 23.1.4, 23.1.9, 24.1.
//
// One SQLite database, a row a value. It is opened by one process at a time, and each save is one transaction in a write-ahead log:
//   killed process   the log's pages are the operating system's as soon as save() returns, so the last completed block is kept;
//                    a block that was being saved is there whole or not at all
//   power cut        synchronous = NORMAL: the log is flushed before it is merged into the file; the last blocks may be lost, the
//                    file stays in order. FULL would flush at each block, some milliseconds each
//   a rollback journal would have to be flushed twice a save to promise the same
//
// Speed, measured with 2000 rows on two cores and the SSD of a server: 120,000 saves of one row a second, 75,000 of two, 35,000 of five.
// Once in some thousand saves the log is merged into the file, which takes up to 10 ms. Opening takes 1 ms.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "config/setup.h"

namespace kadr {

/// What a row belongs to. A new one makes a new minor version of the file; an older Kadr keeps rows that it does not know.
enum class StateTable : std::uint8_t { offsets, work_offsets, variables, parameters, tool_table, place_table, form_table, panel };

/// Their names in the file, those of the set-up, by StateTable.
inline constexpr std::array<std::string_view, 8> state_table_names = {"offsets",    "work_offsets", "variables",  "parameters",
                                                                      "tool_table", "place_table",  "form_table", "panel"};

using StateValue = std::variant<std::monostate, double, std::string>;  // monostate: the row is removed

/// One value. Keys, with the names of the set-up:
///   offsets "5/length_wear" · work_offsets "G54.1 P2/X", "G54/G17" · variables "#500", the counters "#3901" and "#3902", the cutting
///   time "#3002" · parameters "N0107.4#0" · tool_table "2/T", "2/info" (letters or a number), "2/user/1" · place_table "10/1" · form_table
///   "5/left" · panel: what panel/panel_journal keeps, in a file of its own
struct StateRow {
  StateTable table = StateTable::variables;
  std::string key;
  StateValue value;
  friend bool operator==(const StateRow&, const StateRow&) = default;
};

struct StoredState {
  std::vector<StateRow> rows;  // in the order of tables and keys; empty: a new file
};

struct StateChanges {
  std::vector<StateRow> rows;  // of one block; the last of two with the same key counts
};

class StateFile {
 public:
  /// Opens the state of a control, or makes a new one where there is no file.
  ///   control_id  "nct"
  ///   returns     an error sentence naming the file if it is no state of Kadr, damaged, another control's, of a newer version,
  ///               in use by another process, or cannot be written; such a file is left as it was
  static tl::expected<StateFile, std::string> open(const std::string& path, const std::string& control_id);

  StateFile(StateFile&&) noexcept;
  StateFile& operator=(StateFile&&) noexcept;
  ~StateFile();

  /// All rows that this version knows.
  tl::expected<StoredState, std::string> load();

  /// Keeps the changes of one block, all or none; after an error the file holds what it held before, and may be used on.
  tl::expected<void, std::string> save(const StateChanges& changes);

 private:
  class Database;
  explicit StateFile(std::unique_ptr<Database> database);
  std::unique_ptr<Database> database_;
};

/// By tables, then by keys.
void sort_rows(std::vector<StateRow>& rows);

/// The rows of all tables that survive; of the variables those that the set-up gives a value.
std::vector<StateRow> rows_of(const Setup& tables);

/// The tables of a stored state.
///   returns  an error sentence naming the first row that is none
///   law      setup_of({rows_of(tables)}) gives the same tables
tl::expected<Setup, std::string> setup_of(const StoredState& state);

}  // namespace kadr
