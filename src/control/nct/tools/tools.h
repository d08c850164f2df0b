#pragma once
// Tool management (nct 12): the tables of tools, pockets and forms, tool call and change, life, data input by G10.
// ToolManagement holds the tables, DataInput fills them between G10 L75/L76/L77 and G11.
// A magazine has a number: 1…4 with many pockets; 10, 20, … the spindles, 11, 21, … their stand-by places, one pocket each.

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
#include "config/setup.h"
#include "control/state/journal.h"

namespace kadr::nct {

using Pocket = std::pair<int, int>;  // magazine, pocket

/// A table that knows its rows as they were when the block began, and which have changed since they were last asked for.
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
  /// The row to be written to; a new one where there is none.
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

  /// The rows of another one, between two blocks; those that differ have changed.
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
  /// Goes up with each change.
  std::uint64_t version() const { return version_; }

  /// What a block writes is kept there; before, nothing is taken back.
  void keep_in(Journal& journal) { journal_.lead_to(journal); }

 private:
  void keep(const Key& key) {
    ++version_;
    changed_.insert(key);
    if (!journal_) return;
    if (journal_.is_first()) {
      old_.clear();
      journal_.on_undo([this] { undo(); });
    }
    if (std::any_of(old_.begin(), old_.end(), [&](const auto& kept) { return kept.first == key; })) return;
    const Row* row = find(key);
    old_.emplace_back(key, row != nullptr ? std::optional<Row>(*row) : std::nullopt);
  }
  void undo() {
    ++version_;
    for (const auto& [key, row] : old_) {
      changed_.insert(key);  // a reader may have seen it in between
      if (row) rows_[key] = *row;
      else rows_.erase(key);
    }
    old_.clear();
    journal_.start_anew();
  }

  std::map<Key, Row> rows_;
  std::vector<std::pair<Key, std::optional<Row>>> old_;  // of this block, the first value of each
  std::set<Key> changed_;
  std::uint64_t version_ = 0;
  JournalLink journal_;
};

struct ToolLimits {
  int rows = 99'999'999;  // N2902, rows of the tool table
  int user_data = 20;     // N2903, columns of user data, at most 20
  int offsets = 999;      // N1400, greatest number of H, D, G, W
};

/// What T and M6 emit for the machine.
struct ToolCall {
  std::uint32_t tool = 0;  // T as programmed, or the type number of the row
  int data = 0;            // row of the tool table; 0: none
  int magazine = 0;        // where the tool lies, or lay before the change; 0: in no pocket
  int pocket = 0;
  friend bool operator==(const ToolCall&, const ToolCall&) = default;
};

/// Offset numbers of a tool, 0 where there is none.
struct OffsetNumbers {
  int h = 0, d = 0;  // milling: length, radius
  int g = 0, w = 0;  // turning: geometry, wear
};

enum class CallBy : std::uint8_t { type, place };
enum class CountUse : std::uint8_t { no, yes };

class ToolManagement {
 public:
  static constexpr int main_spindle = 10;

  ToolManagement() = default;
  /// Tables and, where no table names it, the tool in the main spindle.
  explicit ToolManagement(const Setup& setup, ToolLimits limits = {});

  const ToolLimits& limits() const { return limits_; }
  void set_limits(const ToolLimits& limits) { limits_ = limits; }
  /// A tool whose life is counted in time is in a table.
  bool counts_time() const;
  const std::map<int, ToolRow>& rows() const { return rows_.rows(); }
  const PlaceTable& places() const { return places_.rows(); }
  const std::map<int, ToolForm>& forms() const { return forms_.rows(); }

  /// There is a row or a pocket. Without, T and M6 only carry the tool number.
  bool enabled() const { return !rows().empty() || !places().empty(); }
  const ToolRow* row(int data) const { return rows_.find(data); }

  /// The tool that T of this type number means: of the valid rows with status 1 or 2, or 0 with the bit S, the one with the
  /// greatest counter; of equal ones the smallest data number. Whether it lies in a pocket does not matter.
  ///   returns  data number, 0: none
  ///   manual   12.3.1
  int search(std::uint32_t type) const;

  /// The first pocket (magazine, then pocket number) in which the row lies.
  std::optional<Pocket> place_of(int data) const;

  /// T: looks for the tool and prepares it for the next change of that spindle; a further T replaces it.
  ///   tool     by type: type number, 0: no tool, the change empties the spindle (12.1, inferred)
  ///            by place: magazine · 10000 + pocket (N2924, 12.5.2); neither status nor life matters
  ///   returns  data, magazine, pocket as far as the tables know them
  ///   alarms   tool_not_found (T): no candidate; or the table of pockets, where it lists magazines, has not this one (inferred)
  Result<ToolCall> call(std::uint32_t tool, CallBy by, int spindle = main_spindle);

  /// M6 (or T, where T changes): the prepared tool goes into the spindle. Nothing prepared: nothing changes, nothing counts.
  /// The old tool goes into the pocket of the new one (random handling, 12.3 c), else into the one it came from, else into
  /// the first empty pocket of a magazine; else it lies in no pocket any more. Inferred. A tool that is in the spindle already stays.
  ///   count    the change code counts as a use (N2901 TLC: 0 M6, 1 T). Counted is the tool now in the spindle (inferred), with
  ///            bits V and C and status 1 or 2: 1 becomes 2; 3 when the counter reaches the life
  ///   returns  tool and row now in the spindle, and the pocket from which it came; `tool` is the row's type number, if it has one
  ///   manual   12.2, 12.3.1, 12.5
  ToolCall change(int spindle, CountUse count);

  /// Cutting time of the tool in that spindle, s. Counts for bits V and T, status 1 or 2; the counter is in seconds (inferred)
  /// and keeps fractions. That override, rotation and feed are as 12.3.1 asks is the caller's business.
  void add_time(double seconds, int spindle = main_spindle);

  /// A tool with status 1 to 3 has `warn` or less of its life left (12.3.1).
  bool warning(int data) const;

  /// Row of the tool in a spindle or stand-by magazine; 0: empty, or not listed.
  int spindle_row(int magazine = main_spindle) const;

  /// #8401…#8450 for the tool in a spindle or stand-by magazine (12.5.3). An empty one: #8401 is 0, the others are vacant.
  /// Vacant too: #8415…#8430, user data above N2903, and all but #8401 where the row is not in the table. Time is in whole seconds.
  std::optional<double> spindle_data(int magazine, int variable) const;

  /// For #8400: it must be a spindle or stand-by magazine; which of them exist is not known. Alarm magazine_number (value).
  static Status check_magazine(double number);

  /// H, D, G, W of the tool in the spindle, for N2923 (12.5.1); all 0 with an empty spindle (inferred).
  OffsetNumbers offset_numbers(int spindle = main_spindle) const;

  /// The tool's form: only of a row with the bit L and a form number; any other occupies its own pocket.
  ToolForm form_of(int data) const;

  // For data input.
  ToolRow& edit_row(int data) { return rows_.edit(data); }
  void clear_row(int data) { rows_.erase(data); }
  void set_place(Pocket pocket, int data) { places_.edit(pocket) = data; }
  void set_form(int number, const ToolForm& form) { forms_.edit(number) = form; }
  /// The pocket of a magazine that has only one: as listed, else 1.
  Pocket only_pocket(int magazine) const;

  /// The journal brings back tables and prepared tools. This object must not move from here on.
  void keep_in(Journal& journal) { rows_.keep_in(journal), places_.keep_in(journal), forms_.keep_in(journal), spindles_.keep_in(journal); }

  /// The three tables are those of all channels (12.3); what is prepared for a spindle is the channel's own.
  void take_tables(const ToolManagement& from) { rows_.take(from.rows_), places_.take(from.places_), forms_.take(from.forms_); }
  std::uint64_t tables_version() const { return rows_.version() + places_.version() + forms_.version(); }

  /// Keys that were written to since the last call, for the state file; a row that is gone was deleted.
  ///   law  any row that differs from the one at the last call is named; also others, after Journal::undo()
  std::vector<int> take_changed_rows() { return rows_.take_changed(); }
  std::vector<Pocket> take_changed_places() { return places_.take_changed(); }
  std::vector<int> take_changed_forms() { return forms_.take_changed(); }

 private:
  struct InSpindle {
    std::optional<ToolCall> prepared;
    std::uint32_t tool = 0;  // T, where no table tells
    Pocket home{};           // from which it came
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

/// Whether two tools in pockets of one chain, or of one row of a matrix, leave each other room: right + left at most twice the
/// number of pockets between them (12.3.3, inferred: the demand is counted from the border of the tool's own pocket, in half pockets).
///   law  the order of the two does not matter; never in the same pocket
bool fits_beside(int pocket_a, const ToolForm& a, int pocket_b, const ToolForm& b);

enum class DataKind : std::uint8_t { register_rows, modify_rows, delete_rows, places, forms };

/// What G10 Ll Pp opens: L75 P1 … P3, L76 P1, L77 P6.
std::optional<DataKind> data_kind(double l, double p);

struct DataWord {
  char letter;
  double value;
  std::string_view digits;  // as written, for binary Q and R; empty: those of `value`
  Span where;
};
struct DataBlock {
  std::span<const DataWord> words;
  Span where;
};

/// The blocks between G10 and G11 (12.4). A value: a copy brings it back.
class DataInput {
 public:
  void begin(DataKind kind) { kind_ = kind, row_ = 0; }

  /// One block. Nothing has changed when it alarms; an empty one does nothing.
  ///   alarms   value_out_of_range (letter, value), also for a fraction or digits that are not binary (inferred)
  ///            word_missing (letter, "G10 L75")
  ///            data_block (letter): a word that has no business here, or stands twice
  ///   manual   12.4.1 … 12.4.5. Inferred: rows that the info bit D protects can be changed from the program; items may be
  ///            spread over several blocks; items of a form that are not given are 0
  Status block(const DataBlock& block, ToolManagement& tools);

 private:
  Status row_block(const DataBlock& block, ToolManagement& tools);
  Status items(const DataBlock& block, ToolManagement& tools) const;
  Status user_item(const DataBlock& block, ToolManagement& tools) const;

  DataKind kind_ = DataKind::register_rows;
  int row_ = 0;  // being filled; 0: none yet
};

}  // namespace kadr::nct
