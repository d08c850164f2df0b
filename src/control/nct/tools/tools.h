#pragma once
// Tool management (nct 12): the tables of tools, pockets and forms (a form states the space that a tool needs), tool call and
// change, tool life, data input by G10. ToolManagement has the tables; DataInput fills them between G10 L75/L76/L77 and G11. Magazine
// numbers: 1…4 are magazines with many pockets; 10, 20, … are the spindles and 11, 21, … their stand-by magazines, with one
// pocket each.

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "config/setup/setup.h"
#include "control/state/journal.h"

namespace kadr::nct {

using Pocket = std::pair<int, int>;  // magazine number, pocket number

/// A table that can restore the rows that a block has changed, and that lists the rows changed since the last take_changed().
template <class Key, class Row>
class JournaledTable {
 public:
  JournaledTable() = default;
  explicit JournaledTable(std::map<Key, Row> rows) : rows_(std::move(rows)) {}

  const std::map<Key, Row>& rows() const { return rows_; }
  const Row* find(const Key& key) const {
    const auto found = rows_.find(key);
    return found == rows_.end() ? nullptr : &found->second;
  }
  /// Returns the row for writing; creates the row if it does not exist.
  Row& edit(const Key& key) {
    keep(key);
    return rows_[key];
  }
  void erase(const Key& key) {
    if (find(key) == nullptr) return;
    keep(key);
    rows_.erase(key);
  }
  std::vector<Key> take_changed() {
    std::vector<Key> keys(changed_.begin(), changed_.end());
    changed_.clear();
    return keys;
  }

  /// Copies the rows from the table of another channel, between two blocks. Rows that differ count as changed in this table.
  void take(const JournaledTable& other) {
    for (const auto& [key, row] : other.rows_)
      if (const auto [place, is_new] = rows_.try_emplace(key, row); is_new || !(place->second == row))
        place->second = row, changed_.insert(key);
    for (auto place = rows_.begin(); place != rows_.end();) {
      if (other.rows_.contains(place->first)) {
        ++place;
      } else {
        changed_.insert(place->first);
        place = rows_.erase(place);
      }
    }
    version_ = other.version_;
  }
  /// Returns a number that increases with each change of the table.
  std::uint64_t version() const { return version_; }

  /// Connects the table to a journal, which restores the rows that a faulty block has written. Without a journal no row is restored.
  void keep_in(Journal& journal) { journal_.relink(journal); }

 private:
  void keep(const Key& key) {
    ++version_;
    changed_.insert(key);
    if (!journal_) return;
    if (journal_.is_first()) {
      old_.clear();
      journal_.on_undo([this] { undo(); });
    }
    if (std::any_of(old_.begin(), old_.end(), [&](const auto& entry) { return entry.first == key; })) return;
    const Row* row = find(key);
    old_.emplace_back(key, row != nullptr ? std::optional<Row>(*row) : std::nullopt);
  }
  void undo() {
    ++version_;
    for (const auto& [key, row] : old_) {
      changed_.insert(key);  // A restored row counts as changed, because its value may have been read since the change.
      if (row) rows_[key] = *row;
      else rows_.erase(key);
    }
    old_.clear();
    journal_.start_again();
  }

  std::map<Key, Row> rows_;
  std::vector<std::pair<Key, std::optional<Row>>> old_;  // the rows written in this block, each with its value before the block
  std::set<Key> changed_;
  std::uint64_t version_ = 0;
  JournalLink journal_;
};

struct ToolLimits {
  int rows = 99'999'999;  // N2902: greatest number of rows of the tool table
  int user_data = 20;     // N2903: number of columns for the user's data in the tool table, at most 20
  int offsets = 999;      // N1400: greatest offset number in the words H, D, G, W
};

/// The data that T and M6 emit for the machine.
struct ToolCall {
  std::uint32_t tool = 0;  // number of the word T, or the type number in the tool's row
  int data = 0;            // data number, which is the number of the tool's row in the tool table; 0: none
  int magazine = 0;        // magazine of the tool, now or before the change; 0: the tool is in no pocket
  int pocket = 0;
  friend bool operator==(const ToolCall&, const ToolCall&) = default;
};

/// The offset numbers in a tool's row; 0: none.
struct OffsetNumbers {
  int h = 0, d = 0;  // for milling tools: numbers of the length offset and of the radius offset
  int g = 0, w = 0;  // for turning tools: numbers of the geometry offset and of the wear offset
};

enum class CallBy : std::uint8_t { type, place };
enum class CountUse : std::uint8_t { no, yes };

class ToolManagement {
 public:
  static constexpr int main_spindle = 10;

  ToolManagement() = default;
  /// Reads the tables from the set-up, and also the tool in the main spindle, which the tables need not list.
  explicit ToolManagement(const Setup& setup, ToolLimits limits = {});

  const ToolLimits& limits() const { return limits_; }
  void set_limits(const ToolLimits& limits) { limits_ = limits; }
  /// Returns true if the tables have a tool whose life is counted in time.
  bool counts_time() const;
  const std::map<int, ToolRow>& rows() const { return rows_.rows(); }
  const PocketTable& places() const { return places_.rows(); }
  const std::map<int, ToolForm>& forms() const { return forms_.rows(); }

  /// Returns true if the tool table has at least one row or the pocket table at least one pocket. Otherwise T and M6 only pass the tool
  /// number to the machine.
  bool enabled() const { return !rows().empty() || !places().empty(); }
  const ToolRow* row(int data) const { return rows_.find(data); }

  /// Finds the tool for a T word with this type number. Only valid rows are searched: rows whose life status is 1 (not used yet) or 2
  /// (already used, life not expired), and rows with status 0 (tool life is not managed) that have the bit S (searchable). The result is
  /// the row with the greatest life counter; among equal rows, the row with the smallest data number. The tool need not be in a pocket.
  ///   returns  data number; 0: none
  ///   manual   12.3.1
  int search(std::uint32_t type) const;

  /// Returns the pocket that contains the tool of this row; of several pockets, the first by magazine and pocket number. Returns nullopt if
  /// the tool is in no pocket.
  std::optional<Pocket> place_of(int data) const;

  /// Executes T: finds the tool and prepares it for the next change of this spindle. A later T replaces the prepared tool.
  ///   tool     CallBy::type: type number; 0: no tool, the change empties the spindle (12.1, inferred). CallBy::place: magazine · 10000 +
  ///            pocket (N2924, 12.5.2); neither status nor life matters
  ///   returns  data, magazine and pocket, as far as the tables list them
  ///   alarms   tool_not_found (T): no row fits; or the pocket table lists magazines, but not this one (inferred)
  Result<ToolCall> call(std::uint32_t tool, CallBy by, int spindle = main_spindle);

  /// Executes M6 (or T, if T changes tools): moves the prepared tool into the spindle. If no tool is prepared, nothing changes and no use
  /// is counted. INFERRED: the old tool goes into the pocket of the new tool (random handling, 12.3 c). Otherwise it goes into
  /// the pocket from which it came, else into the first empty pocket of a magazine, else into no pocket. A prepared tool that is already in
  /// the spindle stays there.
  ///   count    the change code counts as a use (N2901 TLC: 0 M6, 1 T). The use of the tool now in the spindle is counted (inferred), if
  ///            its row is valid (bit V), its life is counted in uses (bit C), and its life status is 1 (not used) or 2 (used). Status 1
  ///            then becomes 2; the status becomes 3 (expired) when the counter reaches the life
  ///   returns  tool and row now in the spindle, and the pocket it came from; `tool` is the row's type number, if it has one
  ///   manual   12.2, 12.3.1, 12.5
  ToolCall change(int spindle, CountUse count);

  /// Adds cutting time in seconds to the life counter of the tool in this spindle, if the row is valid (bit V), its life is counted in time
  /// (bit T), and its life status is 1 (not used) or 2 (used). INFERRED: the counter is in seconds, with fractions. The caller checks that
  /// override, rotation and feed meet the conditions of 12.3.1.
  void add_time(double seconds, int spindle = main_spindle);

  /// Returns true if the life of the tool is nearly used up: the tool takes part in life management (life status 1 to 3), and the remaining
  /// life is at most the limit `warn` of its row (12.3.1).
  bool warning(int data) const;

  /// Returns the data number of the tool in a spindle or stand-by magazine; 0: no tool, or a tool that no table lists.
  int spindle_row(int magazine = main_spindle) const;

  /// Returns #8401…#8450 for the tool in a spindle or stand-by magazine (12.5.3); times are in whole seconds. If the magazine is empty,
  /// #8401 is 0 and the other variables are vacant. If the tool's row is not in the table, all variables but #8401 are vacant. The
  /// variables #8415…#8430 and those of user data above N2903 are always vacant.
  std::optional<double> spindle_data(int magazine, int variable) const;

  /// Checks a value that is assigned to #8400: it must be the number of a spindle or stand-by magazine. Whether the machine has that
  /// magazine is not checked.
  ///   alarms  magazine_number (its argument is the value)
  static Status check_magazine(double number);

  /// Returns the offset numbers H, D, G, W of the tool in the spindle, for N2923 (12.5.1); all 0 if the spindle is empty (inferred).
  OffsetNumbers offset_numbers(int spindle = main_spindle) const;

  /// Returns the form of a tool: the space that it needs. Only a tool whose row has bit L and a form number has a form; any other tool
  /// needs just its own pocket.
  ToolForm form_of(int data) const;

  // The following functions are for DataInput only, which fills the tables from a program.
  ToolRow& edit_row(int data) { return rows_.edit(data); }
  void clear_row(int data) { rows_.erase(data); }
  void set_place(Pocket pocket, int data) { places_.edit(pocket) = data; }
  void set_form(int number, const ToolForm& form) { forms_.edit(number) = form; }
  /// Returns the pocket of a magazine with one pocket: the pocket that the pocket table lists, or pocket 1 if the table lists none.
  Pocket only_pocket(int magazine) const;

  /// Connects the tables and the prepared tools to a journal, which restores them after an alarm. After this call the object must not be
  /// moved in memory.
  void keep_in(Journal& journal) { rows_.keep_in(journal), places_.keep_in(journal), forms_.keep_in(journal), spindles_.keep_in(journal); }

  /// Copies from another channel the three tables, which all channels share (12.3). The prepared tools belong to each channel.
  void take_tables(const ToolManagement& from) { rows_.take(from.rows_), places_.take(from.places_), forms_.take(from.forms_); }
  std::uint64_t tables_version() const { return rows_.version() + places_.version() + forms_.version(); }

  /// Returns, for the state file, the keys of the rows written since the last call. A key without a row belongs to a deleted row.
  ///   law  every row that differs from its state at the last call is returned; after Journal::undo() others may be returned too
  std::vector<int> take_changed_rows() { return rows_.take_changed(); }
  std::vector<Pocket> take_changed_places() { return places_.take_changed(); }
  std::vector<int> take_changed_forms() { return forms_.take_changed(); }

 private:
  struct InSpindle {
    std::optional<ToolCall> prepared;
    std::uint32_t tool = 0;  // number of the last T word, used if no table lists the tool in the spindle
    Pocket home{};           // pocket from which the tool in the spindle came
  };
  void exchange(InSpindle& state, ToolCall& now, int spindle);
  void put_away(int data, const std::optional<Pocket>& first, Pocket second);
  void use(int data, double amount);

  ToolLimits limits_;
  JournaledTable<int, ToolRow> rows_;
  JournaledTable<Pocket, int> places_;
  JournaledTable<int, ToolForm> forms_;
  JournaledTable<int, InSpindle> spindles_;
};

/// Returns true if two tools in pockets of one chain, or of one row of a matrix, do not collide (12.3.3). Condition: the space that the
/// left tool needs on its right plus the space that the right tool needs on its left is at most twice the number of pockets between the
/// tools. INFERRED: space is counted in half pockets, from the border of the tool's own pocket.
///   law  symmetric in the two tools; false for the same pocket
bool fits_next_to(int pocket_a, const ToolForm& a, int pocket_b, const ToolForm& b);

enum class DataKind : std::uint8_t { register_rows, modify_rows, delete_rows, places, forms };

/// Returns which table G10 Ll Pp opens for data: L75 P1 … P3, L76 P1, L77 P6; nullopt for other values.
std::optional<DataKind> data_kind(double l, double p);

struct DataWord {
  char letter;
  double value;
  std::string_view digits;  // digits of the word as written, which Q and R need as binary digits; empty: the digits of `value`
  Span where;
};
struct DataBlock {
  std::span<const DataWord> words;
  Span where;
};

/// Reads the data blocks between G10 and G11 (12.4). The object is a plain value, so that a copy can restore it after an alarm.
class DataInput {
 public:
  void begin(DataKind kind) { kind_ = kind, row_ = 0; }

  /// Executes one data block. An empty block does nothing. After an alarm the tables are unchanged.
  ///   alarms   value_out_of_range (letter, value), also for a fraction or digits that are not binary (inferred)
  ///            word_missing (letter, "G10 L75")
  ///            data_block (letter): a word that is not allowed here, or occurs twice
  ///   manual   12.4.1 … 12.4.5. Inferred: the program can change rows protected by info bit D; the items of a row may be spread over
  ///            several blocks; items of a form that are not given are 0
  Status block(const DataBlock& block, ToolManagement& tools);

 private:
  Status row_block(const DataBlock& block, ToolManagement& tools);
  Status items(const DataBlock& block, ToolManagement& tools) const;
  Status user_item(const DataBlock& block, ToolManagement& tools) const;

  DataKind kind_ = DataKind::register_rows;
  int row_ = 0;  // data number of the row being filled; 0: none yet
};

}  // namespace kadr::nct
