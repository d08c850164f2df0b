#pragma once
// Reads a state file with its checksums: finds the valid rows, and all faults. Only state_*.cpp use it.
//
// Each row has a checksum of two things: its contents (kind, key, type, value), and the totals of the whole file when the row was written.
// The totals are the turn (a count of all writes of rows), the number of rows, and the sum of the checksums of all values and of the
// control's name. So the checksum of the latest row covers the whole file: an added or missing row is detected, and also a file that is
// mixed from two files. Saving one row writes a single page. A turn that changes the number of rows (new file, new row, removed row) also
// stores the totals as `whole` in the table `about`, without a row. The checksum is FNV-1a with 64 bits. Two rows that differ in one byte
// certainly have different checksums, because each step of FNV-1a is invertible.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/state/state_base.h"
#include "config/state/state_file.h"

namespace kadr::state {

/// Returns the checksum of a row's kind, key and value only, without the totals.
std::uint64_t sum_of_row(std::string_view kind, std::string_view key, const StateValue& value);

/// The totals of the whole file. They are updated with each row that is written.
struct Whole {
  std::uint64_t turn = 0;
  std::uint64_t rows = 0;
  std::uint64_t sum = 0;
  static Whole of_control(std::string_view control);
  void add(std::uint64_t row) { ++rows, sum += row; }
  void take(std::uint64_t row) { --rows, sum -= row; }
  /// Returns the checksum of a row in a file with these totals. `row` is the checksum of the row's kind, key and value. With 0 for `row`,
  /// returns the checksum of the totals alone.
  std::uint64_t sealed(std::uint64_t row) const;
  std::string text() const;  // returns the totals and their checksum as a text of four numbers: turn, rows, sum, checksum
  static std::optional<Whole> parsed(const std::string& text);
};

struct Content {
  std::string control;              // id of the control; empty if the file does not state it readably
  bool checked = true;              // true if the file has checksums; if false, an older Kadr wrote the file
  bool ours = true;                 // true if the file has the tables or the application id of a state file of Kadr
  std::vector<StateRow> rows;       // the valid rows, sorted
  std::vector<std::uint64_t> sums;  // checksum of each row
  std::vector<std::string> faults;  // the faults of the file as sentences; empty: the file is valid
  Whole whole;                      // totals of the file; only set if the file is valid and has checksums
};

/// Reads everything that is readable in the file, without changing the file.
Content read_content(const Base& base);

/// Returns a message if the file has a newer version than this program can read; else an empty text.
std::string newer_version_message(const Base& base, const std::string& name);

/// Returns the name that messages use for a row: "work_offsets G54/X".
std::string name_of_row(std::string_view kind, std::string_view key);

}  // namespace kadr::state
